// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Bytes as people write them, both ways.
#include <rtuwire/core/hex.hpp>

#include <array>
#include <string>

#include "support/proof.hpp"

using namespace rtuwire;

namespace {

STATIC_CHECK("02 0c1E"_hex == std::array{std::byte{0x02}, std::byte{0x0C}, std::byte{0x1E}});
STATIC_CHECK(""_hex.size() == 0);
STATIC_CHECK("09 af AF"_hex == std::array{std::byte{0x09}, std::byte{0xAF}, std::byte{0xAF}});
STATIC_CHECK("FF"_hex[0] == std::byte{0xFF});

std::string shown(byte_view bytes, std::size_t room)
{
    std::string text(room, '?');
    auto const part = to_hex(bytes, text);
    return {part.begin(), part.end()};
}

} // namespace

TEST_CASE("bytes are shown two digits each with a space between")
{
    CHECK(shown("02 0C FE"_hex, 8) == "02 0C FE");
    CHECK(shown("02 0C FE"_hex, 100) == "02 0C FE");
    CHECK(shown(byte_view{}, 8).empty());
}

TEST_CASE("what lies behind the text shown stays as it was")
{
    for (std::size_t room = 0; room <= 10; ++room) {
        CAPTURE(room);
        std::string text(room, '?');
        std::size_t const size = to_hex("02 0C FE"_hex, text).size();
        CHECK(size == (room < 2 ? 0 : room < 5 ? 2 : room < 8 ? 5 : 8));
        CHECK(text == std::string{"02 0C FE"}.substr(0, size) + std::string(room - size, '?'));
    }
}

TEST_CASE("bytes that do not fit are left out whole")
{
    CHECK(shown("02 0C FE"_hex, 7) == "02 0C");
    CHECK(shown("02 0C FE"_hex, 4) == "02");
    CHECK(shown("02 0C FE"_hex, 1).empty());
    CHECK(shown("02 0C FE"_hex, 0).empty());
}
