// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Requests of a right length to our server and to libmodbus's: the same answers, byte by byte, and the
// same registers after them.
#include <modbus.h>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <rtuwire/rtuwire.hpp>

#include "input.hpp"

using namespace rtuwire;
using fuzz::require;

namespace {

constexpr std::uint16_t map_size = 200;

/// A libmodbus server whose responses go into a pipe.
class other_server {
public:
    other_server()
    {
        require(context_ != nullptr and map_ != nullptr and ::pipe(pipe_) == 0);
        ::fcntl(pipe_[0], F_SETFL, O_NONBLOCK);
        modbus_set_slave(context_, 1);
        modbus_set_socket(context_, pipe_[1]);
        // It sleeps that long before it refuses.
        modbus_set_response_timeout(context_, 0, 1);
    }
    other_server(other_server const&) = delete;
    other_server& operator=(other_server const&) = delete;
    ~other_server()
    {
        ::close(pipe_[0]);
        ::close(pipe_[1]);
        modbus_mapping_free(map_);
        modbus_free(context_);
    }

    byte_view response_to(byte_view frame)
    {
        static_cast<void>(modbus_reply(context_, reinterpret_cast<std::uint8_t const*>(frame.data()),
                                       static_cast<int>(frame.size()), map_));
        ssize_t const count = ::read(pipe_[0], response_.data(), response_.size());
        return byte_view{response_}.first(count < 0 ? 0 : static_cast<std::size_t>(count));
    }

    std::uint16_t get(std::size_t at) const { return map_->tab_registers[at]; }

private:
    modbus_t* context_{modbus_new_rtu("/dev/null", 19'200, 'N', 8, 1)};
    modbus_mapping_t* map_{modbus_mapping_new(0, 0, map_size, 0)};
    int pipe_[2]{-1, -1};
    std::array<std::byte, 512> response_{};
};

/// One request of a function that both have, its byte count and length as its quantity says.
byte_view request_from(fuzz::input& in, byte_span place)
{
    constexpr std::uint8_t functions[] = {3, 6, 16, 23};
    byte_writer out{place};
    std::uint8_t const what = in.u8();
    std::uint8_t const function = functions[what % 4U];
    out.u8(1);
    out.u8(function);
    out.u16(in.u8());
    if (function != 16) {
        out.u16(in.u8()); // quantity, or the value of 06
    }
    if (function >= 16) {
        std::uint16_t const count = in.u8() % 122U; // what fits a frame of 23
        if (function == 23) {
            out.u16(in.u8());
        }
        out.u16(count);
        out.u8(2U * count);
        for (unsigned i = 0; i < count; ++i) {
            out.u16(in.u16());
        }
    }
    std::uint16_t const crc = crc16(out.written());
    out.u8(crc & 0xFFU);
    out.u8(std::uint32_t{crc} >> 8U);
    return out.written();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    static constexpr server_profile profile{};
    other_server theirs;
    word_bank<map_size> ours;
    fuzz::input in{data, size};
    while (not in.is_empty()) {
        std::array<std::byte, 300> place{};
        byte_view const frame = request_from(in, place);
        std::array<std::byte, max_pdu_size> response{};
        byte_view const pdu = respond(frame.subspan(1, frame.size() - adu_overhead), ours, profile, response);
        byte_view const other = theirs.response_to(frame);
        require(other.size() == pdu.size() + adu_overhead);
        require(same_bytes(other.subspan(1, pdu.size()), pdu));
    }
    for (std::uint16_t at = 0; at < map_size; ++at) {
        require(ours.get(at) == theirs.get(at));
    }
    return 0;
}
