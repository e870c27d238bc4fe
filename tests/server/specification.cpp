// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server with every public function answers the examples of the specification (AP 6.1 to 6.21) as they are printed.
#include <rtuwire/server/banks.hpp>
#include <rtuwire/server/respond.hpp>

#include <array>

#include "support/fact.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

/// The device of the examples: coils 20 to 38, inputs 197 to 218, input register 9, register 5, and two files.
struct printed_device : word_bank<16> {
    bit_bank<256> switched{};
    bit_bank<256> contacts{};
    word_bank<16> measured{};
    std::array<std::uint16_t, 4> file_3_and_4{0x33CD, 0x0040, 0x0DFE, 0x0020};
    std::array<std::uint16_t, 3> written{};

    constexpr auto& coils() { return switched; }
    constexpr auto& discrete_inputs() { return contacts; }
    constexpr auto& input_registers() { return measured; }
    static constexpr std::uint8_t exception_status() { return 0x6D; }
    static constexpr byte_view server_id() { return id; }
    static constexpr errc read_fifo(std::uint16_t address, byte_writer& out)
    {
        if (address != 0x04DE) {
            return errc::illegal_data_address;
        }
        out.u16(0x01B8);
        out.u16(0x1284);
        return errc::none;
    }
    static constexpr errc check_read_file(file_run run)
    {
        bool const is_there =
            run.count == 2 and ((run.file == 4 and run.record == 1) or (run.file == 3 and run.record == 9));
        return is_there ? errc::none : errc::illegal_data_address;
    }
    constexpr errc read_file(file_run run, byte_writer& out) const
    {
        std::size_t const at = run.file == 4 ? 2 : 0;
        out.u16(file_3_and_4[at]);
        out.u16(file_3_and_4[at + 1]);
        return errc::none;
    }
    static constexpr errc check_write_file(file_run run, register_view values)
    {
        return run.file == 4 and run.record == 7 and values.size() == 3 ? errc::none : errc::illegal_data_address;
    }
    constexpr errc write_file(file_run, register_view values)
    {
        return values.copy_to(written) == 3 ? errc::none : errc::server_device_failure;
    }

private:
    static constexpr std::array<std::byte, 3> id{std::byte{0x12}, std::byte{0xFF}, std::byte{0x34}};
};

constexpr void put(bit_bank<256>& bits, std::uint16_t first, byte_view bytes)
{
    for (std::size_t i = 0; i < 8 * bytes.size(); ++i) {
        static_cast<void>(bits.set(static_cast<std::uint16_t>(first + i), bit_at(bytes, i)));
    }
}

constexpr printed_device fresh()
{
    printed_device device;
    put(device.switched, 19, "CD 6B 05"_hex);
    put(device.contacts, 196, "AC DB 35"_hex);
    static_cast<void>(device.measured.set(8, 10));
    static_cast<void>(device.set(4, 0x0012));
    return device;
}

template <std::size_t Asked, std::size_t Told>
constexpr bool answers(std::array<std::byte, Asked> const& asked, std::array<std::byte, Told> const& told)
{
    printed_device device = fresh();
    serial_diagnostics line;
    std::array<std::byte, max_pdu_size> place{};
    return same_bytes(respond<public_functions>(asked, device, server_profile{}, place, line), told);
}

STATIC_CHECK(answers("01 00 13 00 13"_hex, "01 03 CD 6B 05"_hex));
STATIC_CHECK(answers("02 00 C4 00 16"_hex, "02 03 AC DB 35"_hex));
STATIC_CHECK(answers("04 00 08 00 01"_hex, "04 02 00 0A"_hex));
STATIC_CHECK(answers("05 00 AC FF 00"_hex, "05 00 AC FF 00"_hex));
STATIC_CHECK(answers("07"_hex, "07 6D"_hex));
STATIC_CHECK(answers("0B"_hex, "0B 00 00 00 00"_hex));
STATIC_CHECK(answers("0C"_hex, "0C 06 00 00 00 00 00 00"_hex));
STATIC_CHECK(answers("0F 00 13 00 0A 02 CD 01"_hex, "0F 00 13 00 0A"_hex));
STATIC_CHECK(answers("11"_hex, "11 03 12 FF 34"_hex));
STATIC_CHECK(answers("14 0E 06 00 04 00 01 00 02 06 00 03 00 09 00 02"_hex,
                     "14 0C 05 06 0D FE 00 20 05 06 33 CD 00 40"_hex));
STATIC_CHECK(answers("15 0D 06 00 04 00 07 00 03 06 AF 04 BE 10 0D"_hex,
                     "15 0D 06 00 04 00 07 00 03 06 AF 04 BE 10 0D"_hex));
STATIC_CHECK(answers("16 00 04 00 F2 00 25"_hex, "16 00 04 00 F2 00 25"_hex));
STATIC_CHECK(answers("18 04 DE"_hex, "18 00 06 00 02 01 B8 12 84"_hex));

constexpr bool does_what_is_printed()
{
    printed_device device = fresh();
    serial_diagnostics line;
    std::array<std::byte, max_pdu_size> place{};
    static_cast<void>(respond<public_functions>("16 00 04 00 F2 00 25"_hex, device, server_profile{}, place, line));
    static_cast<void>(respond<public_functions>("05 00 AC FF 00"_hex, device, server_profile{}, place, line));
    static_cast<void>(respond<public_functions>("15 0D 06 00 04 00 07 00 03 06 AF 04 BE 10 0D"_hex, device,
                                                server_profile{}, place, line));
    using test::is;
    return is(device.get(4) == 0x0017, "the register is masked") and is(device.switched.get(172), "coil 173 is on") and
           is(device.written[0] == 0x06AF and device.written[2] == 0x100D, "the records are written");
}
PROOF("the writes of the examples take effect", does_what_is_printed)

// A server has the functions that its type names, and no other.
template <typename Functions, std::size_t Asked> constexpr bool lacks(std::array<std::byte, Asked> const& asked)
{
    printed_device device = fresh();
    serial_diagnostics line;
    std::array<std::byte, max_pdu_size> place{};
    byte_view const told = respond<Functions>(asked, device, server_profile{}, place, line);
    return told.size() == 2 and told[0] == (asked[0] | std::byte{0x80}) and told[1] == std::byte{1};
}
STATIC_CHECK(lacks<register_functions>("01 00 13 00 13"_hex) and lacks<register_functions>("16 00 04 00 F2 00 25"_hex));
using coils_only = function_list<read_coils>;
STATIC_CHECK(lacks<coils_only>("03 00 04 00 01"_hex) and lacks<coils_only>("08 00 00 12 34"_hex));
STATIC_CHECK(not lacks<coils_only>("01 00 13 00 13"_hex));

} // namespace
