// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What the description of a drive says of its registers by itself, whatever their rows say: some are never a setting (its
// command, its references, the words that its scanner passes on), others never an ordinary one (its safeguards). A row that
// forgets its role would be restored, and the motor would turn.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/device/cycle_registers.hpp>
#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/row_table.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// What the row at an address has to be: never restored, or by the option of this role.
struct row_demand {
    std::uint16_t address{0};
    parameter_role role{parameter_role::order}; ///< one that is not restorable: never restored

    [[nodiscard]] constexpr bool is_met_by(parameter_role found) const noexcept
    {
        return not is_restorable(found) or found == role;
    }
};

/// The demands of a drive.
template <typename Device>
inline constexpr auto row_demands = [] {
    constexpr drive_layout layout = Device::layout;
    constexpr safeguard_layout own = layout.safeguards;
    constexpr cycle_addresses writes = Device::cycle.writes;
    constexpr scanner_registers scanner = Device::scanner;
    // Every drive has these, at address 0 too.
    constexpr std::uint16_t words[]{layout.cmd,
                                    layout.cmi,
                                    layout.eta,
                                    layout.eti,
                                    layout.lft,
                                    layout.rfr,
                                    Device::speed_reference.address,
                                    Device::frequency_reference.address};
    // Of these, address 0 says that the drive has none.
    constexpr row_demand if_any[]{{layout.other_cmd},
                                  {own.inputs},
                                  {own.sll, parameter_role::supervision},
                                  {own.tto, parameter_role::link_timeout},
                                  {own.chcf, parameter_role::channel},
                                  {own.cd1, parameter_role::channel},
                                  {own.fr1, parameter_role::channel},
                                  {own.flo, parameter_role::channel},
                                  {own.atr, parameter_role::restart},
                                  {own.tcc, parameter_role::run_input},
                                  {own.dotd, parameter_role::motion},
                                  {layout.lsp, parameter_role::frequency_limit},
                                  {layout.hsp, parameter_role::frequency_limit}};
    std::array<row_demand, std::size(words) + std::size(if_any) + writes.size() + 2U * scanner.words> all{};
    all.fill({layout.cmd}); // what is left over
    std::size_t next = 0;
    for (std::uint16_t const each : words) {
        all[next++] = {each};
    }
    for (row_demand const& each : if_any) {
        if (each.address != 0) {
            all[next++] = each;
        }
    }
    for (std::size_t i = 0; i < writes.size(); ++i) {
        bool const is_left_to_program = Device::cycle.by_scanner and writes[i] == 0;
        if (not is_left_to_program) {
            all[next++] = {writes[i]};
        }
    }
    for (std::size_t i = 0; i < scanner.words; ++i) {
        all[next++] = {static_cast<std::uint16_t>(scanner.output_words + i)};
        all[next++] = {static_cast<std::uint16_t>(scanner.output_addresses + i), parameter_role::channel};
    }
    return all;
}();

/// Whether a row says of itself what the description of its drive says of its register.
template <typename Device> [[nodiscard]] constexpr bool agrees_with_drive(parameter const& row) noexcept
{
    bool agrees = true;
    for (row_demand const& each : row_demands<Device>) {
        agrees = agrees and (each.address != row.address or each.is_met_by(role_of(row)));
    }
    return agrees;
}

/// Of a drive whose registers are rows.
template <detail::has_all_parts T>
    requires requires { T::registers::row_for(0); }
inline constexpr bool has_rows_with_roles<T> = [] {
    bool all = detail::are_right_rows<typename T::registers>();
    for (row_demand const& each : row_demands<T>) {
        // GCC with -fsanitize=undefined compares no address of a constant, not even with null.
        all = all and (not T::registers::has_address(each.address) or
                       each.is_met_by(role_of(*T::registers::row_for(each.address))));
    }
    return all;
}();

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
