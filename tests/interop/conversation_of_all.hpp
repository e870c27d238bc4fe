// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A request of every function, and what our server answers: what a protocol analyser is shown.
#pragma once

#include <array>
#include <vector>

#include <rtuwire/core/hex.hpp>
#include <rtuwire/rtuwire.hpp>
#include <rtuwire/server/banks.hpp>
#include <rtuwire/wire/functions.hpp>

namespace rtuwire::test {

using namespace detail;

using byte_list = std::vector<std::byte>;

struct pair_of_frames {
    byte_list request;
    byte_list response;
};

inline constexpr device_object objects[] = {
    {vendor_name, "Schneider Electric"}, {product_code, "ATV310H037N4"}, {major_minor_revision, "0201"}};
inline constexpr server_profile profile{.identity = identity_of<objects>};

/// A device with everything: each third coil and input is on, and records count up.
struct device : word_bank<100> {
    bit_bank<32> switched{0};
    bit_bank<32> contacts{0};
    word_bank<4> measured{0};

    device() : word_bank<100>{3100}
    {
        static_cast<void>(set(3102, 40));
        static_cast<void>(measured.set(1, 10));
        for (std::uint16_t each = 1; each < 10; each = static_cast<std::uint16_t>(each + 3)) {
            static_cast<void>(switched.set(each, true));
            static_cast<void>(contacts.set(static_cast<std::uint16_t>(each + 1), true));
        }
    }
    auto& coils() { return switched; }
    auto& discrete_inputs() { return contacts; }
    auto& input_registers() { return measured; }
    static std::uint8_t exception_status() { return 0x6D; }
    static byte_view server_id()
    {
        static constexpr auto id = "12 34 FF"_hex;
        return id;
    }
    static errc read_fifo(std::uint16_t, byte_writer& out)
    {
        out.u16(0x01B8);
        out.u16(0x1284);
        return errc::none;
    }
    static errc check_read_file(file_run) { return errc::none; }
    static errc read_file(file_run run, byte_writer& out)
    {
        for (std::uint32_t i = 0; i < run.count; ++i) {
            out.u16(0x0DFE + run.record + i);
        }
        return errc::none;
    }
    static errc check_write_file(file_run, register_view) { return errc::none; }
    static errc write_file(file_run, register_view) { return errc::none; }
};

template <typename Request> pair_of_frames ask(Request const& request)
{
    auto const frame = encode(unit_id{2}, request);
    device bank;
    serial_diagnostics line;
    for (int i = 0; i < 258; ++i) {
        line.note_message();
    }
    line.note_end(function_code::read_coils, errc::none);
    std::array<std::byte, max_pdu_size> place{};
    auto const asked = decode_adu(*frame);
    auto const said = raw_pdu<>::decode(respond<public_functions>(asked->pdu(), bank, profile, place, line));
    byte_list response;
    if (said) {
        auto const sent = encode(unit_id{2}, *said);
        response.assign(sent->view().begin(), sent->view().end());
    } else {
        auto const refusal =
            exception_response::decode(respond<public_functions>(asked->pdu(), bank, profile, place, line));
        auto const sent = encode(unit_id{2}, *refusal);
        response.assign(sent->view().begin(), sent->view().end());
    }
    return {{frame->view().begin(), frame->view().end()}, response};
}

inline std::vector<pair_of_frames> conversation_of_all()
{
    return {
        ask(read_holding_registers{3102, 4}),
        ask(write_single_register{3103, 13}),
        ask(diagnostics{subfunction::return_query_data, register_block{0xA537}}),
        ask(write_multiple_registers{3104, register_block{20, 30}}),
        ask(read_write_multiple_registers{3102, 2, 3110, register_block{15, 1500}}),
        ask(read_device_identification{}),
        ask(read_holding_registers{1, 1}),
        ask(read_coils{1, 10}),
        ask(read_discrete_inputs{2, 9}),
        ask(read_input_registers{0, 2}),
        ask(write_single_coil{17, true}),
        ask(write_single_coil{18, false}),
        ask(read_exception_status{}),
        ask(diagnostics{subfunction::restart_communications, register_block{0xFF00}}),
        ask(diagnostics{subfunction::bus_message_count, register_block{0}}),
        ask(diagnostics{subfunction::server_busy_count, register_block{0}}),
        ask(get_comm_event_counter{}),
        ask(get_comm_event_log{}),
        ask(write_multiple_coils{19, bit_block{true, false, true, true, false, false, true, true, true, false}}),
        ask(report_server_id{}),
        ask(read_file_record{std::array<file_run, 2>{{{4, 1, 2}, {3, 9, 1}}}}),
        ask(write_file_record{4, 7, register_block{0x06AF, 0x04BE, 0x100D}}),
        ask(mask_write_register{3104, 0x00F2, 0x0025}),
        ask(read_fifo_queue{0x04DE}),
    };
}

} // namespace rtuwire::test
