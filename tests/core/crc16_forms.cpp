// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// All forms of the CRC are one function, in the compiler and when they run.
#include <rtuwire/core/crc16.hpp>

#include <array>

#include "support/exact.hpp"
#include "support/proof.hpp"
#include "support/random.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

template <crc_form... Others> constexpr bool agree(byte_view bytes)
{
    std::uint16_t const bitwise = crc16<crc_form::bitwise>(bytes);
    return ((crc16<Others>(bytes) == bitwise) and ...);
}

constexpr bool all_agree(byte_view bytes)
{
    using enum crc_form;
    return agree<nibble_table, byte_table, host>(bytes);
}

constexpr bool agree_up_to(std::size_t most)
{
    test::random random{11};
    for (std::size_t size = 0; size <= most; ++size) {
        test::exact_bytes bytes{size}; // of which none too many is read
        random.fill(bytes.span());
        if (not all_agree(bytes.view())) {
            return false;
        }
    }
    return true;
}
constexpr bool agree_on_short_frames() { return agree_up_to(72); }
PROOF("the forms agree on frames of every length up to 72", agree_on_short_frames)

#ifdef RTUWIRE_CRC_FORM_IS_DEFAULT
// Where nobody chooses: by the size of a pointer.
STATIC_CHECK(default_crc_form == (sizeof(void*) == 8 ? crc_form::host : crc_form::nibble_table));
#endif

/// How often the next byte leads a growing CRC elsewhere than the bits do.
template <crc_form Form>
std::uint32_t differences(running_crc16<crc_form::bitwise> const& bits, running_crc16<Form> const& other)
{
    std::uint32_t count = 0;
    for (std::uint32_t byte = 0; byte <= 0xFF; ++byte) {
        auto after = bits;
        auto after_other = other;
        after.add(to_byte(byte));
        after_other.add(to_byte(byte));
        count += after.value() != after_other.value() ? 1U : 0U;
    }
    return count;
}

template <crc_form Form> std::uint32_t differences_in_every_state()
{
    std::uint32_t count = 0;
    for (std::uint32_t two = 0; two <= 0xFFFF; ++two) { // two bytes lead to every state
        running_crc16<crc_form::bitwise> bits;
        running_crc16<Form> other;
        for (std::uint32_t const byte : {two & 0xFFU, two >> 8U}) {
            bits.add(to_byte(byte));
            other.add(to_byte(byte));
        }
        count += differences(bits, other);
    }
    return count;
}

} // namespace

TEST_CASE("the forms agree on random bytes of every length up to 600") { CHECK(agree_up_to(600)); }

TEST_CASE("the forms agree on bytes at any address")
{
    test::random random{12};
    std::array<std::byte, 96> bytes{};
    random.fill(bytes);
    for (std::size_t at = 0; at < 16; ++at) {
        for (std::size_t size = 0; size < 80; ++size) {
            REQUIRE(all_agree(byte_view{bytes}.subspan(at, size)));
        }
    }
}

TEST_CASE("a growing CRC takes every byte in every state as the bits do")
{
    CHECK(differences_in_every_state<crc_form::nibble_table>() == 0);
    CHECK(differences_in_every_state<crc_form::byte_table>() == 0);
    CHECK(differences_in_every_state<crc_form::host>() == 0);
}
