// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Writes what our encoders and our server say as capture files for a protocol analyser: once as UDP
// in raw IPv4, where each function is told apart, once as a recorder of serial lines has it, where the
// CRC is checked. With "damaged" as second argument one byte of one frame is wrong.
#include <array>
#include <cstdio>
#include <fstream>
#include <string>

#include "conversation_of_all.hpp"

using namespace rtuwire;
using namespace rtuwire::test;

namespace {

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
