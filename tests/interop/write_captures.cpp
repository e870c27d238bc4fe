// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Writes what our encoders and our server say as capture files for a protocol analyser: once as UDP
// in raw IPv4, where each function is told apart, once as a recorder of serial lines has it, where the
// CRC is checked. With "damaged" as second argument one byte of one frame is wrong.
#include <array>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include <rtuwire/core/hex.hpp>
#include <rtuwire/rtuwire.hpp>
#include <rtuwire/server/bank/bit_bank.hpp>
#include <rtuwire/wire/functions.hpp>

using namespace rtuwire;

namespace {

using byte_list = std::vector<std::byte>;

struct pair_of_frames {
    byte_list request;
    byte_list response;
};

constexpr device_object objects[] = {
    {vendor_name, "Schneider Electric"}, {product_code, "ATV310H037N4"}, {major_minor_revision, "0201"}};
constexpr server_profile profile{.identity = identity_of<objects>};

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

std::vector<pair_of_frames> conversation_of_all()
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

/// A capture file: a header, then records.
class capture {
public:
    capture(std::string const& name, std::uint32_t link_type) : file_{name, std::ios::binary}
    {
        put({0xA1B2C3D4U, 0x00020004U, 0U, 0U, 65535U, link_type});
    }

    void record(byte_list const& bytes)
    {
        auto const size = static_cast<std::uint32_t>(bytes.size());
        put({++seconds_, 0U, size, size});
        for (std::byte const byte : bytes) {
            file_.put(static_cast<char>(to_u8(byte)));
        }
    }

    std::uint32_t seconds() const { return seconds_; }

private:
    void put(std::initializer_list<std::uint32_t> words)
    {
        for (std::uint32_t const word : words) {
            for (unsigned shift = 32; shift > 0; shift -= 8) {
                file_.put(static_cast<char>(to_u8(to_byte(word >> (shift - 8)))));
            }
        }
    }

    std::ofstream file_;
    std::uint32_t seconds_{0};
};

byte_list in_front_of(byte_list const& frame, byte_writer const& head)
{
    byte_list packet{head.written().begin(), head.written().end()};
    packet.insert(packet.end(), frame.begin(), frame.end());
    return packet;
}

byte_list as_udp(byte_list const& frame, bool is_request)
{
    constexpr std::uint32_t server_port = 5020;
    constexpr std::uint32_t client_port = 40'000;
    std::array<std::byte, 28> head{};
    byte_writer out{head};
    out.u16(0x4500);
    out.u16(static_cast<std::uint32_t>(28 + frame.size()));
    out.u16(0);
    out.u16(0);
    out.u16(0x4011);
    out.u16(0);
    for (int i = 0; i < 2; ++i) {
        out.u16(0x7F00);
        out.u16(0x0001);
    }
    out.u16(is_request ? client_port : server_port);
    out.u16(is_request ? server_port : client_port);
    out.u16(static_cast<std::uint32_t>(8 + frame.size()));
    out.u16(0);
    return in_front_of(frame, out);
}

byte_list as_serial(byte_list const& frame, bool is_request, std::uint32_t seconds)
{
    std::array<std::byte, 12> head{};
    byte_writer out{head};
    out.u16(0);
    out.u16(seconds);
    out.u16(0);
    out.u16(0);
    out.u8(is_request ? 1 : 2);
    out.u8(0);
    out.u16(0);
    return in_front_of(frame, out);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 2) {
        return 2;
    }
    std::string const folder = argv[1];
    auto exchanges = conversation_of_all();
    if (argc > 2) {
        exchanges[0].response[4] ^= std::byte{1};
    }
    capture udp{folder + "/udp.pcap", 101};
    capture serial{folder + "/serial.pcap", 250};
    for (pair_of_frames const& each : exchanges) {
        udp.record(as_udp(each.request, true));
        udp.record(as_udp(each.response, false));
        serial.record(as_serial(each.request, true, serial.seconds()));
        serial.record(as_serial(each.response, false, serial.seconds()));
    }
    return 0;
}
