// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A public function in a unit's own form, asked by a client that knows only the usual one.
// EXPECT: this client's list of functions lacks one that the conversation asks
#include <rtuwire/client.hpp>

using namespace rtuwire;

struct words {
    static constexpr std::size_t max_size = 60;
    static result<words> decode(byte_view) { return words{}; }
};

struct read_words : read_holding_registers {
    using response = words;
    static constexpr std::size_t length_of_response(byte_view so_far) { return so_far.size() < 4 ? 0 : 8; }
    static constexpr errc check_response(byte_view, byte_view) { return errc::none; }
};

inline constexpr client_needs<public_functions_and<read_words>> own{};

void act()
{
#ifdef REFUSED
    client link{line_timing{19'200, character_format::even_8_1}};
#else
    basic_client<own> link{line_timing{19'200, character_format::even_8_1}};
#endif
    single_request ask{unit_id{7}, read_words{{.start = 100, .count = 1}}};
    link.converse(ask, instant{0});
}
