// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Decoders: size, byte count and quantity must agree, and no bytes make them read outside.
#include <rtuwire/wire/serial_line/device_identification.hpp>

#include <array>

#include "support/exact.hpp"
#include "support/proof.hpp"
#include "support/random.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/wire/raw.hpp>
#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/serial_line/diagnostics.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

template <typename P, std::size_t Size> constexpr errc fault(std::array<std::byte, Size> const& bytes)
{
    return P::decode(bytes).error();
}

using fc03 = read_holding_registers;
STATIC_CHECK(fault<fc03>("03 00 00 00 7D"_hex) == errc::none);
STATIC_CHECK(fault<fc03>("03 00 00 00 00"_hex) == errc::invalid_quantity);
STATIC_CHECK(fault<fc03>("03 00 00 00 7E"_hex) == errc::invalid_quantity);
STATIC_CHECK(fault<fc03>("03 00 00 FF FF"_hex) == errc::invalid_quantity);
STATIC_CHECK(fault<fc03>("03 00 00 00"_hex) == errc::wrong_length);
STATIC_CHECK(fault<fc03>("03 00 00 00 01 00"_hex) == errc::wrong_length);
STATIC_CHECK(fault<fc03>("06 00 00 00 01"_hex) == errc::wrong_function);
// The last register exists; what lies past it is for the bank to say.
STATIC_CHECK(fault<fc03>("03 FF FF 00 02"_hex) == errc::none);

using fc03_response = read_holding_registers_response;
STATIC_CHECK(fault<fc03_response>("03 02 12 34"_hex) == errc::none);
STATIC_CHECK(fault<fc03_response>("03"_hex) == errc::wrong_length);
STATIC_CHECK(fault<fc03_response>("03 00"_hex) == errc::invalid_quantity);
STATIC_CHECK(fault<fc03_response>("03 03 12 34 56"_hex) == errc::wrong_length);
STATIC_CHECK(fault<fc03_response>("03 02 12"_hex) == errc::wrong_length);
STATIC_CHECK(fault<fc03_response>("03 02 12 34 56"_hex) == errc::wrong_length);

using fc06 = write_single_register;
STATIC_CHECK(fault<fc06>("06 00 01 00 03"_hex) == errc::none);
STATIC_CHECK(fault<fc06>("06 00 01 00 03 00"_hex) == errc::wrong_length);
STATIC_CHECK(fault<fc06>("06 00 01 00"_hex) == errc::wrong_length);

using fc16 = write_multiple_registers<>;
STATIC_CHECK(fault<fc16>("10 00 00 00 01 02 00 05"_hex) == errc::none);
STATIC_CHECK(fault<fc16>("10 00 00 00 7B 06 00 01 00 02 00 03"_hex) == errc::wrong_length);
STATIC_CHECK(fault<fc16>("10 00 00 00 01 02 00 05 AA BB"_hex) == errc::wrong_length);
STATIC_CHECK(fault<fc16>("10 00 00 00 01 03 00 05 00"_hex) == errc::wrong_length);
STATIC_CHECK(fault<fc16>("10 00 00 00 00 00"_hex) == errc::invalid_quantity);
STATIC_CHECK(fault<fc16>("10 00 00 00 01"_hex) == errc::wrong_length);
using fc16_response = write_multiple_registers_response;
STATIC_CHECK(fault<fc16_response>("10 00 00 00 7B"_hex) == errc::none);
STATIC_CHECK(fault<fc16_response>("10 00 00 00 7C"_hex) == errc::invalid_quantity);
STATIC_CHECK(fault<fc16_response>("10 00 00 00"_hex) == errc::wrong_length);

using fc23 = read_write_multiple_registers<>;
STATIC_CHECK(fault<fc23>("17 00 00 00 01 00 00 00 01 02 00 05"_hex) == errc::none);
STATIC_CHECK(fault<fc23>("17 00 00 00 01 00 00 00 01 02"_hex) == errc::wrong_length);
STATIC_CHECK(fault<fc23>("17 00 00 00 00 00 00 00 01 02 00 05"_hex) == errc::invalid_quantity);
STATIC_CHECK(fault<fc23>("17 00 00 00 7E 00 00 00 01 02 00 05"_hex) == errc::invalid_quantity);
STATIC_CHECK(fault<fc23>("17 00 00 00 01 00 00 00 00 00"_hex) == errc::invalid_quantity);
STATIC_CHECK(fault<fc23>("17 00 00 00 01 00 00 00 02 02 00 05"_hex) == errc::wrong_length);

STATIC_CHECK(fault<diagnostics<>>("08 00 00 A5 37"_hex) == errc::none);
STATIC_CHECK(fault<diagnostics<>>("08 00 00 A5 37 00 01"_hex) == errc::none);
STATIC_CHECK(fault<diagnostics<>>("08 00 0B 00 00 00 01"_hex) == errc::invalid_quantity);
STATIC_CHECK(fault<diagnostics<>>("08 00 00 A5"_hex) == errc::wrong_length);
STATIC_CHECK(fault<diagnostics<>>("08 00 00"_hex) == errc::invalid_quantity);

STATIC_CHECK(fault<exception_response>("83 02"_hex) == errc::none);
STATIC_CHECK(fault<exception_response>("03 02"_hex) == errc::wrong_function);
STATIC_CHECK(fault<exception_response>("83"_hex) == errc::wrong_length);
STATIC_CHECK(fault<exception_response>("83 02 00"_hex) == errc::wrong_length);

using identify = read_device_identification;
STATIC_CHECK(fault<identify>("2B 0E 01 00"_hex) == errc::none);
STATIC_CHECK(fault<identify>("2B 0E 05 00"_hex) == errc::malformed);
STATIC_CHECK(fault<identify>("2B 0E 00 00"_hex) == errc::malformed);
STATIC_CHECK(fault<identify>("2B 0D 01 00"_hex) == errc::wrong_function);
STATIC_CHECK(fault<identify>("2B 0E 01"_hex) == errc::wrong_length);

using page = device_identification;
STATIC_CHECK(fault<page>("2B 0E 01 01 00 00 01 00 01 41"_hex) == errc::none);
STATIC_CHECK(fault<page>("2B 0E 01 01 00 00"_hex) == errc::wrong_length);
STATIC_CHECK(fault<page>("2B 0E 01 01 00 00 02 00 01 41"_hex) == errc::malformed);
STATIC_CHECK(fault<page>("2B 0E 01 01 00 00 01 00 02 41"_hex) == errc::malformed);
STATIC_CHECK(fault<page>("2B 0E 01 01 00 00 01 00 01 41 42"_hex) == errc::malformed);
STATIC_CHECK(fault<page>("2B 0E 01 01 01 00 01 00 01 41"_hex) == errc::malformed);
STATIC_CHECK(fault<page>("2B 0E 01 01 00 00 02 01 01 41 01 01 42"_hex) == errc::malformed);
STATIC_CHECK(fault<page>("2B 0E 01 01 00 00 00"_hex) == errc::malformed);

constexpr bool walks_objects()
{
    constexpr auto bytes = "2B 0E 01 01 FF 03 02 00 01 41 02 00"_hex;
    auto const read = page::decode(bytes);
    if (not read or not read->more_follows or read->next_object != 3) {
        return false;
    }
    auto const first = read->first();
    auto const second = read->after(*first);
    bool const in_order = first->id == 0 and second->id == 2 and second->value.empty();
    return in_order and not read->after(*second) and read->find(2) and not read->find(1);
}
PROOF("a page's objects are walked in order", walks_objects)

/// Decodes bytes as P; what decodes must encode to the same bytes.
template <typename P> constexpr bool is_identity(byte_view bytes)
{
    auto const read = P::decode(bytes);
    if (not read) {
        return true;
    }
    std::array<std::byte, 256> place{};
    byte_writer out{place};
    read->write(out);
    return same_bytes(out.written(), bytes);
}

/// How many of pseudo-random PDUs decode to something that encodes to other bytes.
constexpr unsigned changed(std::uint32_t seed, unsigned rounds)
{
    constexpr std::array<std::uint8_t, 8> codes{3, 6, 8, 16, 23, 43, 0x83, 0x41};
    test::random random{seed};
    unsigned wrong = 0;
    for (unsigned round = 0; round < rounds; ++round) {
        test::exact_bytes bytes{random.below(40)};
        byte_span const part = bytes.span();
        random.fill(part);
        // Small numbers make headers that agree with themselves.
        for (std::byte& byte : part) {
            if (random.below(3) != 0) {
                byte = to_byte(random.below(8));
            }
        }
        if (not part.empty()) {
            part[0] = to_byte(codes[random.below(codes.size())]);
        }
        bool const same = is_identity<fc03>(part) and is_identity<fc03_response>(part) and is_identity<fc06>(part) and
                          is_identity<fc16>(part) and is_identity<fc16_response>(part) and is_identity<fc23>(part) and
                          is_identity<read_write_multiple_registers_response>(part) and
                          is_identity<diagnostics<>>(part) and is_identity<exception_response>(part) and
                          is_identity<identify>(part) and is_identity<page>(part) and is_identity<raw_pdu<>>(part);
        wrong += same ? 0U : 1U;
    }
    return wrong;
}
constexpr bool keeps_arbitrary_bytes() { return changed(13, 200) == 0; }
PROOF("no bytes make a decoder read outside them", keeps_arbitrary_bytes)

} // namespace

TEST_CASE("whatever decodes encodes to the same bytes") { CHECK(changed(11, 200'000) == 0); }
