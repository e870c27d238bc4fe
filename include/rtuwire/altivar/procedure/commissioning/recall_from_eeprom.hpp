// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Restores the settings that a drive saved last: what was written since is lost. Only an ATV28 has the order, bit 2
// of CMI; other orders that CMI still holds are not repeated with it.
#pragma once

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/procedure/commissioning/cmi_order.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Recalls the saved settings of a drive at rest with its run inputs open: they may give the command to another source.
/// The drive is silent for up to 2 s. `not_taken` where it did not accept the order, which is then cleared. Once the order
/// was sent, it ends as `executed_unconfirmed` where the drive does not confirm it; an order that it may have left in
/// CMI is cleared, if the drive still receives that.
class recall_from_eeprom : public procedure_runner<cmi_order_procedure> {
public:
    /// Recalls the settings of this drive, within the limit.
    template <device_type Device>
    explicit constexpr recall_from_eeprom(station<Device> const& its_drive, terminal_options const& its_options = {},
                                          duration its_limit = milliseconds(8'000)) noexcept
        : procedure_runner{its_drive.unit(), its_limit, drive_check<Device>::layout, its_options, recall_order}
    {
        static_assert((drive_check<Device>::layout.cmi_orders & recall_order.bit) != 0,
                      "this device cannot recall its saved settings over the line");
    }
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
