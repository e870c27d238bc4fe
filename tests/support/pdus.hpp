// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The one list of the kinds of PDU, for tests and fuzz targets that try all of them.
#pragma once

#include <type_traits>

#include <rtuwire/wire/pdu/device_identification.hpp>
#include <rtuwire/wire/pdu/diagnostics.hpp>
#include <rtuwire/wire/pdu/exception.hpp>
#include <rtuwire/wire/pdu/raw.hpp>
#include <rtuwire/wire/pdu/read_holding_registers.hpp>
#include <rtuwire/wire/pdu/read_write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/write_single_register.hpp>

namespace rtuwire::test {

template <typename... Pdus> struct pdu_list {
    template <typename Pdu> static constexpr bool contains = (std::is_same_v<Pdu, Pdus> or ...);

    /// Calls `visit.operator()<Pdu>()` for each.
    template <typename F> static constexpr void for_each(F const& visit) { (visit.template operator()<Pdus>(), ...); }

    /// Whether `holds.operator()<Pdu>()` is true of each.
    template <typename F> static constexpr bool all_of(F const& holds)
    {
        return (holds.template operator()<Pdus>() and ...);
    }
};

using all_pdus =
    pdu_list<read_holding_registers, read_holding_registers_response, write_single_register, write_multiple_registers<>,
             write_multiple_registers_response, read_write_multiple_registers<>, read_write_multiple_registers_response,
             diagnostics<>, read_device_identification, device_identification, exception_response, raw_pdu<>>;

} // namespace rtuwire::test
