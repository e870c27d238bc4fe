// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A request that is kept in a variable owns its words: what is sent later is what it was made of.
#include <rtuwire/wire/raw.hpp>
#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/serial_line/diagnostics.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/hex.hpp>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

/// Whether a request still has its words behind the expression that made it, in one size and no more.
template <typename Request, std::size_t Size>
constexpr bool is_sent_as(Request const& kept, std::array<std::byte, Size> const& bytes)
{
    Request const moved = kept;
    auto const frame = encode(unit_id{1}, moved);
    return frame and *frame == bytes and frame->capacity() == Size;
}

constexpr bool owns_its_words()
{
    auto const write = write_multiple_registers{100, register_block{1, 2}};
    auto const both = read_write_multiple_registers{3, 4, 100, register_block{7}};
    auto const query = diagnostics{subfunction::return_query_data, register_block{0xA537, 2}};
    auto const raw = raw_pdu{static_cast<function_code>(0x41), "0A 0B 0C"_hex};
    return is_sent_as(write, "01 10 00 64 00 02 04 00 01 00 02 24 75"_hex) and
           is_sent_as(both, "01 17 00 03 00 04 00 64 00 01 02 00 07 2D 78"_hex) and
           is_sent_as(query, "01 08 00 00 A5 37 00 02 1A C4"_hex) and is_sent_as(raw, "01 41 0A 0B 0C 2A CB"_hex);
}
PROOF("defect: a request that is kept owns its words", owns_its_words)

constexpr bool is_made_in_a_function()
{
    auto const made = [](std::uint16_t word) {
        register_block words{word, word};
        auto const kept = write_multiple_registers{100, words};
        words.set(0, 0xDEAD);
        return kept;
    };
    return made(1).values == register_block{1, 1} and made(2).values == register_block{2, 2};
}
PROOF("defect: a request owns its words also where the block has a name", is_made_in_a_function)

// A block or bytes that end with their expression give no view.
template <typename T> constexpr bool gives_view = std::is_convertible_v<T, register_view>;
STATIC_CHECK(gives_view<register_block<2>&>and gives_view<register_block<2> const&>);
STATIC_CHECK(not gives_view<register_block<2>> and not gives_view<register_block<2> const>);
using two_bytes = std::array<std::byte, 2>;
STATIC_CHECK(std::is_constructible_v<register_view, two_bytes const&>);
STATIC_CHECK(not std::is_constructible_v<register_view, two_bytes>);
STATIC_CHECK(std::is_constructible_v<raw_pdu<>, function_code, two_bytes const&>);
STATIC_CHECK(not std::is_constructible_v<raw_pdu<>, function_code, two_bytes>);

// A view is a view, and so is what was decoded.
constexpr register_block lasting{1, 2};
STATIC_CHECK(std::is_same_v<decltype(write_multiple_registers{100, lasting.view()}), write_multiple_registers<>>);
STATIC_CHECK(write_multiple_registers{100, lasting} == write_multiple_registers{100, lasting.view()});
STATIC_CHECK(write_multiple_registers{100, lasting} != write_multiple_registers{101, lasting});

// What a response shows outlives the response, because the bytes are elsewhere.
constexpr bool shows_bytes_of_a_response_that_is_gone()
{
    constexpr auto bytes = "03 02 12 34"_hex;
    auto const outcome = [&] { return std::optional{result<response>{response{bytes}}}; };
    unsigned sum = 0;
    for (std::byte const byte : (*outcome())->pdu()) {
        sum += to_u8(byte);
    }
    return sum == 3 + 2 + 0x12 + 0x34;
}
PROOF("defect: (b) a loop over a response's PDU needs no response", shows_bytes_of_a_response_that_is_gone)

// More words than the function takes are refused as ever.
STATIC_CHECK(encode(unit_id{1}, write_multiple_registers{0, register_block<124>{}}) == errc::invalid_quantity);
STATIC_CHECK(encode(unit_id{1}, read_write_multiple_registers{0, 1, 0, register_block<122>{}}) ==
             errc::invalid_quantity);
STATIC_CHECK(encode(unit_id{1}, diagnostics{subfunction::return_query_data, register_block<126>{}}) ==
             errc::invalid_quantity);
STATIC_CHECK(encode(unit_id{1}, raw_pdu{static_cast<function_code>(0x41), std::array<std::byte, 253>{}}) ==
             errc::frame_too_long);

// The value of a result that ends with its expression is as temporary; it may be copied, and named.
template <typename T> using content_of = decltype(*std::declval<result<T>>());
template <typename T> using content_of_named = decltype(*std::declval<result<T>&>());
STATIC_CHECK(std::is_same_v<content_of<fixed_buffer<8>>, fixed_buffer<8>>);
STATIC_CHECK(std::is_same_v<content_of_named<fixed_buffer<8>>, fixed_buffer<8> const&>);
STATIC_CHECK(not std::is_constructible_v<request_frame, content_of<fixed_buffer<8>>>);
STATIC_CHECK(not std::is_constructible_v<request_frame, content_of<std::array<std::byte, 8>>>);
STATIC_CHECK(std::is_constructible_v<request_frame, content_of_named<fixed_buffer<8>>>);
STATIC_CHECK(not gives_view<content_of<register_block<2>>>);
STATIC_CHECK(gives_view<content_of_named<register_block<2>>>);

constexpr bool may_be_kept_by_value()
{
    auto const encoded = [] { return encode(unit_id{1}, write_single_register{100, 7}); };
    auto const copied = *encoded();
    auto const& named = *encoded(); // lives as long as its name
    byte_view const same = named;
    return copied == same and *encoded() == same and encoded()->size() == 8;
}
PROOF("defect: the value of a temporary result may be copied, named and compared", may_be_kept_by_value)

} // namespace
