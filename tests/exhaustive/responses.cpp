// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client's verdict on answers of every unit, function, byte count and length, to requests of each
// function, against an oracle that knows nothing of the codec.
#include <array>

#include <rtuwire/wire/bits.hpp>
#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/response.hpp>

#include "share.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr std::uint8_t unit = 17;
constexpr std::uint64_t registers = 5;
constexpr std::uint64_t coils = 19;
constexpr std::uint64_t bytes_of_coils = 3;

auto const read_bits = *encode(*unit_id::checked(unit), read_coils{0, coils});
auto const read_contacts = *encode(*unit_id::checked(unit), read_discrete_inputs{0, coils});
auto const read = *encode(*unit_id::checked(unit), read_holding_registers{0, registers});
auto const read_inputs = *encode(*unit_id::checked(unit), read_input_registers{0, registers});
auto const write = *encode(*unit_id::checked(unit), write_single_register{0x0A00, 0x0002});
auto const write_block = *encode(*unit_id::checked(unit), write_multiple_registers{0x0A00, register_block{1, 2}});

/// Case: unit, function, third byte, length of the PDU, 8 bits each.
struct response {
    std::uint64_t from;
    std::uint64_t function;
    std::uint64_t third;
    std::size_t size;

    explicit response(std::uint64_t at)
        : from{at & 0xFFU}, function{(at >> 8U) & 0xFFU}, third{(at >> 16U) & 0xFFU}, size{(at >> 24U) & 0xFFU}
    {}

    /// Whether the rest is what a write of 2 at 0A00 returns: third byte 0A, then 00 00 02.
    bool is_echo() const { return third == 0x0A and size == 5; }

    errc against(byte_view request) const
    {
        std::array<std::byte, 0x100 + adu_overhead> frame{
            static_cast<std::byte>(from), static_cast<std::byte>(function), static_cast<std::byte>(third)};
        frame[5] = std::byte{2};
        return check_response(request, adu{byte_view{frame}.first(size + adu_overhead)});
    }
};

/// What is right for any request of function `asked`; `normal` is for its own normal answers.
bool is_right(response const& heard, std::uint64_t asked, errc got, bool is_good)
{
    if (heard.from != unit) {
        return got == errc::wrong_unit;
    }
    if ((heard.function & 0x7FU) != asked) {
        return got == errc::wrong_function;
    }
    if (heard.function >= 0x80) {
        bool const is_listed = heard.third > 0 and heard.third < 0x80;
        return heard.size != 2 ? got == errc::wrong_length
               : is_listed     ? static_cast<std::uint64_t>(got) == heard.third
                               : got == errc::unlisted_exception;
    }
    return is_good == (got == errc::none);
}

bool is_size_possible(response const& heard) { return heard.size >= 1 and heard.size <= max_pdu_size; }

/// To a read whose response has so many bytes behind its byte count.
bool is_read_right(std::uint64_t at, byte_view request, std::uint64_t function, std::uint64_t bytes)
{
    response const heard{at};
    bool const is_good = heard.third == bytes and heard.size == 2 + bytes;
    return not is_size_possible(heard) or is_right(heard, function, heard.against(request), is_good);
}

bool is_01_right(std::uint64_t at) { return is_read_right(at, read_bits, 1, bytes_of_coils); }
bool is_02_right(std::uint64_t at) { return is_read_right(at, read_contacts, 2, bytes_of_coils); }
bool is_03_right(std::uint64_t at) { return is_read_right(at, read, 3, 2 * registers); }
bool is_04_right(std::uint64_t at) { return is_read_right(at, read_inputs, 4, 2 * registers); }

bool is_write_right(std::uint64_t at)
{
    response const heard{at};
    return not is_size_possible(heard) or is_right(heard, 6, heard.against(write), heard.is_echo());
}

bool is_block_right(std::uint64_t at)
{
    response const heard{at};
    return not is_size_possible(heard) or is_right(heard, 16, heard.against(write_block), heard.is_echo());
}

} // namespace

int main(int argc, char** argv)
{
    using exhaustive::holds;
    std::uint64_t const stride = exhaustive::stride_of(argc, argv);
    constexpr std::uint64_t all = std::uint64_t{1} << 32U;
    bool ok = holds("answers to 01", all, stride, is_01_right);
    ok = holds("answers to 02", all, stride, is_02_right) and ok;
    ok = holds("answers to 03", all, stride, is_03_right) and ok;
    ok = holds("answers to 04", all, stride, is_04_right) and ok;
    ok = holds("answers to 06", all, stride, is_write_right) and ok;
    ok = holds("answers to 16", all, stride, is_block_right) and ok;
    return ok ? 0 : 1;
}
