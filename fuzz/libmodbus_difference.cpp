// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Requests of a right length, of every function that both have, to our server and to libmodbus's: the same answers,
// byte by byte, and the same registers and coils after them. Only function 17 is left out: each names itself.
#include <modbus.h>

#include <algorithm>
#include <ctime>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <rtuwire/rtuwire.hpp>

#include "input.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using fuzz::require;

/// In the place of the system's: libmodbus sleeps before it refuses, be it for a microsecond, which takes 60, and then
/// flushes its line.
extern "C" int nanosleep(timespec const* /*length*/, timespec* /*left*/) { return 0; }
extern "C" int tcflush(int /*device*/, int /*queues*/) noexcept { return 0; }

namespace {

constexpr std::uint16_t map_size = 200;

/// Coils, inputs and both kinds of registers, with the same inputs on both sides.
struct our_bank : word_bank<map_size> {
    bit_bank<map_size> switched{};
    bit_bank<map_size> contacts{};
    word_bank<map_size> measured{};

    auto& coils() { return switched; }
    auto& discrete_inputs() { return contacts; }
    auto& input_registers() { return measured; }
};
using shared_functions =
    function_list<read_coils, read_discrete_inputs, read_holding_registers, read_input_registers, write_single_coil,
                  write_single_register, write_multiple_coils<>, write_multiple_registers<>, mask_write_register,
                  read_write_multiple_registers<>>;

constexpr std::uint16_t input_word(std::size_t at) { return static_cast<std::uint16_t>(at * 40'503U + 7U); }
constexpr bool input_bit(std::size_t at) { return (at * 11U / 7U) % 2U != 0; }

/// A bank as every input finds it.
our_bank new_bank()
{
    our_bank made;
    for (std::uint16_t at = 0; at < map_size; ++at) {
        require(made.contacts.set(at, input_bit(at)).has_value());
        require(made.measured.set(at, input_word(at)).has_value());
    }
    return made;
}

/// A libmodbus server whose responses go into a pipe. Made once: that takes longer than an input.
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
        for (std::size_t at = 0; at < map_size; ++at) {
            map_->tab_input_registers[at] = input_word(at);
            map_->tab_input_bits[at] = input_bit(at) ? 1 : 0;
        }
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

    /// What requests can have changed is as at first, and no response is left over.
    void restart()
    {
        std::fill_n(map_->tab_registers, map_size, std::uint16_t{0});
        std::fill_n(map_->tab_bits, map_size, std::uint8_t{0});
        require(::read(pipe_[0], response_.data(), response_.size()) < 0);
    }

    byte_view response_to(byte_view frame)
    {
        static_cast<void>(modbus_reply(context_, reinterpret_cast<std::uint8_t const*>(frame.data()),
                                       static_cast<int>(frame.size()), map_));
        ssize_t const count = ::read(pipe_[0], response_.data(), response_.size());
        return byte_view{response_}.first(count < 0 ? 0 : static_cast<std::size_t>(count));
    }

    std::uint16_t get(std::size_t at) const { return map_->tab_registers[at]; }
    bool is_on(std::size_t at) const { return map_->tab_bits[at] != 0; }

private:
    modbus_t* context_{modbus_new_rtu("/dev/null", 19'200, 'N', 8, 1)};
    modbus_mapping_t* map_{modbus_mapping_new(map_size, map_size, map_size, map_size)};
    int pipe_[2]{-1, -1};
    std::array<std::byte, 512> response_{};
};

/// As many values as fit a frame of function 23.
void write_values(fuzz::input& in, byte_writer& out)
{
    std::uint16_t const count = in.u8() % 122U;
    out.u16(count);
    out.u8(2U * count);
    for (unsigned i = 0; i < count; ++i) {
        out.u16(in.u16());
    }
}

/// Bits; what is left of the last byte is any.
void write_coils(fuzz::input& in, byte_writer& out)
{
    unsigned const count = in.u16() % 1969U;
    out.u16(count);
    out.u8((count + 7) / 8);
    for (unsigned i = 0; i < (count + 7) / 8; ++i) {
        out.u8(in.u8());
    }
}

/// One request of a function that both have, its byte count and length as its quantity says.
byte_view request_from(fuzz::input& in, byte_span place)
{
    constexpr std::uint8_t functions[] = {3, 6, 16, 23, 1, 2, 4, 5, 15, 22};
    byte_writer out{place};
    std::uint8_t const function = functions[in.u8() % sizeof functions];
    out.u8(1);
    out.u8(function);
    std::uint8_t const address = in.u8();
    out.u16(address);
    switch (function) {
    case 5: {
        // AP 6.5 looks at the value first, libmodbus at the address.
        std::uint16_t const value = in.u16();
        out.u16(address < map_size ? value : value % 2U == 0 ? 0U : 0xFF00U);
        break;
    }
    case 15: write_coils(in, out); break;
    case 16: write_values(in, out); break;
    case 22:
        out.u16(in.u16());
        out.u16(in.u16());
        break;
    case 23:
        out.u16(in.u8());
        out.u16(in.u8());
        write_values(in, out);
        break;
    default: out.u16(in.u8()); break; // quantity, or the value of 06
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
    static our_bank const as_new = new_bank();
    static other_server theirs;
    theirs.restart();
    our_bank ours = as_new;
    fuzz::input in{data, size};
    while (not in.is_empty()) {
        std::array<std::byte, 300> place{};
        byte_view const frame = request_from(in, place);
        std::array<std::byte, max_pdu_size> response{};
        byte_view const pdu =
            respond<shared_functions>(frame.subspan(1, frame.size() - adu_overhead), ours, profile, response);
        byte_view const other = theirs.response_to(frame);
        require(other.size() == pdu.size() + adu_overhead);
        require(same_bytes(other.subspan(1, pdu.size()), pdu));
    }
    for (std::uint16_t at = 0; at < map_size; ++at) {
        require(ours.get(at) == theirs.get(at));
        require(ours.switched.get(at) == theirs.is_on(at));
    }
    return 0;
}
