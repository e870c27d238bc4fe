// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Registers in wire order, one by one and all at once.
#include <rtuwire/wire/views.hpp>

#include <array>
#include <type_traits>

#include "support/exact.hpp"
#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

// A block is written with one value for each register.
STATIC_CHECK(std::is_constructible_v<register_block<2>, int, int>);
STATIC_CHECK(not std::is_constructible_v<register_block<2>, int>);
STATIC_CHECK(not std::is_constructible_v<register_block<2>, int, int, int>);

// A view equals the block with the same registers, from either side.
constexpr register_block pair{0x1234, 7};
constexpr std::array<std::byte, 4> same_pair{std::byte{0x12}, std::byte{0x34}, std::byte{0}, std::byte{7}};
STATIC_CHECK(register_view{same_pair} == pair and pair == register_view{same_pair});
STATIC_CHECK(not(register_view{same_pair} == register_block{0x1234, 8}));
STATIC_CHECK(not(register_view{same_pair} == register_block{0x1234}));

constexpr std::uint16_t untouched = 0xA5A5;

/// Registers of which both bytes differ, and every one from its neighbours.
constexpr std::uint16_t word_of(std::size_t index)
{
    return static_cast<std::uint16_t>(0x8000U + 0x0101U * index + 1U);
}

constexpr bool copies(std::size_t count)
{
    test::exact_bytes bytes{2 * count, std::byte{0}};
    for (std::size_t i = 0; i < count; ++i) {
        bytes.span()[2 * i] = to_byte(std::uint32_t{word_of(i)} >> 8U);
        bytes.span()[2 * i + 1] = to_byte(word_of(i));
    }
    register_view const view{bytes.view()};
    std::array<std::uint16_t, 130> words;
    words.fill(untouched);
    bool good = view.copy_to(std::span{words}.first(count)) == count;
    for (std::size_t i = 0; i < words.size(); ++i) {
        good = good and words[i] == (i < count ? word_of(i) : untouched);
        good = good and (i >= count or view[i] == word_of(i));
    }
    return good;
}

constexpr bool copies_any_count()
{
    for (std::size_t count = 0; count <= 20; ++count) {
        if (not copies(count)) {
            return false;
        }
    }
    return copies(63) and copies(125);
}
PROOF("all registers are copied, and no word beyond them", copies_any_count)

constexpr bool copies_none_to(std::size_t room)
{
    constexpr std::array<std::byte, 10> bytes{};
    std::array<std::uint16_t, 4> words;
    words.fill(untouched);
    std::size_t copied = 1;
    copied = register_view{bytes}.copy_to(std::span{words}.first(room));
    return copied == 0 and words[0] == untouched and words[3] == untouched;
}
constexpr bool copies_all_or_nothing() { return copies_none_to(4) and copies_none_to(0); }
PROOF("registers for which there is no room are not copied in part", copies_all_or_nothing)

constexpr bool holds_registers_in_wire_order()
{
    register_block block{0x0102, 0x0304, 0x0506};
    using test::is;
    bool const reads = is(block[0] == 0x0102, "the first register") and is(block[1] == 0x0304, "the second") and
                       is(block[2] == 0x0506, "the third");
    block.set(1, 0xFEDC);
    return reads and is(block[0] == 0x0102, "the register before") and
           is(block[1] == 0xFEDC, "the one that was set") and is(block[2] == 0x0506, "the register behind") and
           is(block.view().bytes()[2] == std::byte{0xFE}, "its high byte comes first") and
           is(block.size() == 3, "size");
}
PROOF("a block holds its registers in wire order", holds_registers_in_wire_order)

constexpr bool drops_half_a_register()
{
    constexpr std::array<std::byte, 3> bytes{std::byte{1}, std::byte{2}, std::byte{3}};
    register_view const view{bytes};
    return view.size() == 1 and view[0] == 0x0102 and not view.empty();
}
PROOF("an odd last byte is not part of any register", drops_half_a_register)

} // namespace
