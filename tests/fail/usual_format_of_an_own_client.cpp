// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A usual read by a client that asks that function in a format of one's own.
// EXPECT: this client asks a function of the conversation in a format of one's own
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

void act(basic_client<own>& link)
{
#ifdef REFUSED
    single_request ask{unit_id{7}, read_holding_registers{.start = 100, .count = 1}};
#else
    single_request ask{unit_id{7}, read_input_registers{.start = 100, .count = 1}};
#endif
    link.converse(ask, instant{0});
}
