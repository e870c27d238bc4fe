// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Two formats of one's own for one function.
// EXPECT: a list of functions has a code once, where a request of one's own format uses it
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

struct read_others : read_words {};

#ifdef REFUSED
inline constexpr client_needs<public_functions_and<read_words, read_others>> own{};
#else
inline constexpr client_needs<public_functions_and<read_words>> own{};
#endif

void act(basic_client<own>& link)
{
    single_request ask{unit_id{7}, read_words{{.start = 100, .count = 1}}};
    link.converse(ask, instant{0});
}
