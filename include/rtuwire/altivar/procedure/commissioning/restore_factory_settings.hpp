// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Restores a drive's factory settings. With these the terminals command the drive, and a later Altivar has no unit
// address: the caller has to state that this is known, and the drive does not confirm the result. A closed run input
// would then start the motor, so the drive is checked first.
#pragma once

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/procedure/commissioning/cmi_order.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The caller's statement: the line's control and the drive's address may be lost afterwards.
struct losing_control_and_address {
    /// Written out by the caller: `losing_control_and_address{}`.
    explicit constexpr losing_control_and_address() noexcept = default;
};

/// Restores the factory settings of a drive at rest or in fault, with its run inputs open (else `run_input_closed`):
/// in three-wire control, too, because two-wire control comes back. Where the inputs cannot be read, as on an ATV310,
/// the risk has to be accepted (`accept_unseen_inputs`), or it ends as `unknown_register`. Nothing is saved: the
/// settings are lost with the power unless `save_to_eeprom` follows, if the drive can still be reached. The order is sent
/// once. A good end is `executed_unconfirmed`; it never ends as `succeeded`, and as `silent` only before the order.
class restore_factory_settings : public procedure_runner<cmi_order_procedure> {
public:
    /// Restores this drive, within the limit; the second argument is the caller's statement.
    template <device_type Device>
    constexpr restore_factory_settings(station<Device> const& drive, losing_control_and_address,
                                       terminal_options const& options = {},
                                       duration limit = milliseconds(5'000)) noexcept
        : procedure_runner{drive.unit(), limit, drive_check<Device>::layout, options, factory_order}
    {}

    /// Refused: the statement is missing.
    template <device_type Device>
    explicit constexpr restore_factory_settings(station<Device> const& drive) noexcept
        : restore_factory_settings{drive, losing_control_and_address{}}
    {
        static_assert(not device_type<Device>,
                      "factory settings may take the line's control and the drive's address away: "
                      "say losing_control_and_address");
    }
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
