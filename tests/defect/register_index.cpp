// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A register that a view or a block does not have is neither read nor written: the program's hook is called, and
// the program ends.
#include <rtuwire/wire/registers.hpp>

#include <limits>

#include "defect/missing_value_hook.hpp"
#include "support/death.hpp"
#include "support/proof.hpp"

using namespace rtuwire;

namespace {

/// A number that the compiler does not know.
std::size_t told(std::size_t number)
{
    std::size_t const volatile place = number;
    return place;
}

template <typename T> void consume(T value)
{
    T const volatile used = value;
    static_cast<void>(used);
}

/// Whether this ended the program behind its hook, which was told of a register that is not there.
bool is_refused(test::end how) { return how.is_trap and how.left == static_cast<int>(errc::invalid_address_range); }

// Above half of the largest index, twice the index is small again.
constexpr std::size_t wraps = std::numeric_limits<std::size_t>::max() / 2 + 1;
constexpr std::size_t beyond[]{2, 3, 124, wraps, wraps + 1, std::numeric_limits<std::size_t>::max()};

TEST_CASE("defect: no register is read behind the end of an answer")
{
    // The bytes behind the response are there, as in a client's memory.
    constexpr std::array<std::byte, 8> memory{std::byte{3}, std::byte{4}, std::byte{0}, std::byte{1},
                                              std::byte{0}, std::byte{2}, std::byte{9}, std::byte{9}};
    auto const response = read_holding_registers_response::decode(byte_view{memory}.first(6));
    REQUIRE(response);
    CHECK(test::end_of([&] { consume(response->registers[told(1)]); }).is_return);
    for (std::size_t const index : beyond) {
        CHECK(is_refused(test::end_of([&] { consume(response->registers[told(index)]); })));
    }
    CHECK(is_refused(test::end_of([&] { consume(register_view{}[told(0)]); })));
}

TEST_CASE("defect: no register is read or set behind the end of a block")
{
    register_block block{1, 2};
    CHECK(test::end_of([&] { consume(block[told(1)]); }).is_return);
    CHECK(test::end_of([&] { block.set(told(1), 7); }).is_return);
    for (std::size_t const index : beyond) {
        CHECK(is_refused(test::end_of([&] { consume(block[told(index)]); })));
        CHECK(is_refused(test::end_of([&] { block.set(told(index), 7); })));
    }
}

} // namespace
