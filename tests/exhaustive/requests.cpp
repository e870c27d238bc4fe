// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server's verdict on every header of functions 01 to 04 and 06, and on every quantity, byte count and length
// of 16 and 23, against an oracle that knows nothing of the codec.
#include <array>

#include <rtuwire/server/respond.hpp>

#include "share.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

/// Has every coil and input; keeps none.
struct every_bit {
    static constexpr errc check_read(std::uint16_t start, std::size_t count)
    {
        return start + count <= 0x10000 ? errc::none : errc::illegal_data_address;
    }
    static constexpr errc read(std::uint16_t, std::size_t, byte_span) { return errc::none; }
};

/// Has every register, coil and input; keeps none.
struct every_register {
    static constexpr errc check_read(std::uint16_t start, std::size_t count)
    {
        return start + count <= 0x10000 ? errc::none : errc::illegal_data_address;
    }
    static constexpr errc check_write(std::uint16_t start, register_view values)
    {
        return check_read(start, values.size());
    }
    static constexpr errc read(std::uint16_t, std::size_t count, byte_writer& out)
    {
        for (std::size_t i = 0; i < count; ++i) {
            out.u16(0);
        }
        return errc::none;
    }
    static constexpr errc write(std::uint16_t, register_view) { return errc::none; }
    every_bit& coils() { return bits; }
    every_bit& discrete_inputs() { return bits; }
    every_register& input_registers() { return *this; }

    every_bit bits{};
};

using served = function_list<read_coils, read_discrete_inputs, read_holding_registers, read_input_registers,
                             write_single_register, write_multiple_registers<>, read_write_multiple_registers<>>;
constexpr server_profile profile{};

/// A PDU from its first bytes; the rest is zero.
struct pdu {
    std::array<std::byte, max_pdu_size> bytes{};
    std::size_t size{0};

    void u8(std::uint64_t value) { bytes[size++] = static_cast<std::byte>(value & 0xFFU); }
    void u16(std::uint64_t value)
    {
        u8(value >> 8U);
        u8(value);
    }
    void zeros(std::size_t count) { size += count; }
};

/// The exception that the server answers with; 0 for a normal response. `asked` becomes the response.
unsigned verdict(pdu& asked)
{
    every_register bank;
    no_diagnostics none;
    pdu_buffer place{asked.bytes, asked.size};
    respond_in_place<served>(place, bank, profile, none);
    asked.size = place.size;
    bool const is_exception = (to_u8(asked.bytes[0]) & 0x80U) != 0;
    return is_exception ? to_u8(asked.bytes[1]) : 0U;
}

/// A read of 1 to `Most` values of `Bits` bits each: what is answered, in how many bytes, and how many they are told
/// to be.
template <unsigned Function, unsigned Most, unsigned Bits> bool is_read_right(std::uint64_t header)
{
    std::uint64_t const address = header >> 16U;
    std::uint64_t const quantity = header & 0xFFFFU;
    pdu asked;
    asked.u8(Function);
    asked.u16(address);
    asked.u16(quantity);
    unsigned const expected = quantity < 1 or quantity > Most ? 3U : address + quantity > 65'536 ? 2U : 0U;
    if (verdict(asked) != expected) {
        return false;
    }
    std::uint64_t const bytes = (quantity * Bits + 7) / 8;
    return expected != 0 ? asked.size == 2 : asked.size == 2 + bytes and to_u8(asked.bytes[1]) == bytes;
}

bool is_write_right(std::uint64_t header)
{
    pdu asked;
    asked.u8(6);
    asked.u16(header >> 16U);
    asked.u16(header & 0xFFFFU);
    return verdict(asked) == 0;
}

/// Case: quantity (16 bits), byte count (8 bits), bytes of data (8 bits).
bool is_block_right(std::uint64_t at)
{
    std::uint64_t const quantity = at & 0xFFFFU;
    std::uint64_t const byte_count = (at >> 16U) & 0xFFU;
    std::size_t const data = (at >> 24U) & 0xFFU;
    if (data > max_pdu_size - 6) {
        return true;
    }
    pdu asked;
    asked.u8(16);
    asked.u16(0);
    asked.u16(quantity);
    asked.u8(byte_count);
    asked.zeros(data);
    bool const is_legal = quantity >= 1 and quantity <= 123 and byte_count == 2 * quantity and data == byte_count;
    return verdict(asked) == (is_legal ? 0U : 3U);
}

/// Case: written quantity (16 bits), byte count (8 bits), bytes of data (8 bits); one register is read.
bool is_exchange_right(std::uint64_t at)
{
    std::uint64_t const quantity = at & 0xFFFFU;
    std::uint64_t const byte_count = (at >> 16U) & 0xFFU;
    std::size_t const data = (at >> 24U) & 0xFFU;
    if (data > max_pdu_size - 10) {
        return true;
    }
    pdu asked;
    asked.u8(23);
    asked.u16(0);
    asked.u16(1);
    asked.u16(0);
    asked.u16(quantity);
    asked.u8(byte_count);
    asked.zeros(data);
    bool const is_legal = quantity >= 1 and quantity <= 121 and byte_count == 2 * quantity and data == byte_count;
    return verdict(asked) == (is_legal ? 0U : 3U);
}

/// Case: address and quantity of what is read; one register is written.
bool is_exchange_read_right(std::uint64_t header)
{
    std::uint64_t const address = header >> 16U;
    std::uint64_t const quantity = header & 0xFFFFU;
    pdu asked;
    asked.u8(23);
    asked.u16(address);
    asked.u16(quantity);
    asked.u16(0);
    asked.u16(1);
    asked.u8(2);
    asked.u16(0);
    unsigned const expected = quantity < 1 or quantity > 125 ? 3U : address + quantity > 65'536 ? 2U : 0U;
    return verdict(asked) == expected;
}

} // namespace

int main(int argc, char** argv)
{
    using exhaustive::holds;
    std::uint64_t const stride = exhaustive::stride_of(argc, argv);
    constexpr std::uint64_t all = std::uint64_t{1} << 32U;
    bool ok = holds("01, address and quantity", all, stride, is_read_right<1, 2000, 1>);
    ok = holds("02, address and quantity", all, stride, is_read_right<2, 2000, 1>) and ok;
    ok = holds("03, address and quantity", all, stride, is_read_right<3, 125, 16>) and ok;
    ok = holds("04, address and quantity", all, stride, is_read_right<4, 125, 16>) and ok;
    ok = holds("06, address and value", all, stride, is_write_right) and ok;
    ok = holds("16, quantity, byte count and length", all, stride, is_block_right) and ok;
    ok = holds("23, what is written", all, stride, is_exchange_right) and ok;
    ok = holds("23, what is read", all, stride, is_exchange_read_right) and ok;
    return ok ? 0 : 1;
}
