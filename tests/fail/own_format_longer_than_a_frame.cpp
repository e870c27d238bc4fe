// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A format of one's own whose response is longer than any frame.
// EXPECT: a response has at most 253 bytes without unit and CRC: its max_size
#include <rtuwire/client.hpp>

using namespace rtuwire;

#ifdef REFUSED
inline constexpr std::size_t most = 32'765;
#else
inline constexpr std::size_t most = 253;
#endif

struct words {
    static constexpr std::size_t max_size = most;
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
    single_request ask{unit_id{7}, read_words{{.start = 100, .count = 1}}};
    link.converse(ask, instant{0});
}
