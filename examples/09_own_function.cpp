// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lesson 9: a function of your own, at both ends: function 65 (hexadecimal 41) returns how often the device was
// started, and resets it. Codes 65 to 72 and 100 to 110 are free for that. Builds on lessons 1 and 2.
#include <cstdio>
#include <optional>

#include <rtuwire/client.hpp>
#include <rtuwire/server.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;

namespace {

//! [function]
constexpr auto starts_code = static_cast<function_code>(65);

/// The response: the code, and a word.
struct starts_response {
    static constexpr std::size_t max_size = 3;
    unsigned count;

    static result<starts_response> decode(byte_view bytes)
    {
        if (bytes.size() != max_size) {
            return errc::wrong_length;
        }
        return starts_response{std::to_integer<unsigned>(bytes[1]) * 256U + std::to_integer<unsigned>(bytes[2])};
    }
};

/// The request: the code, and whether to reset. It has what every request of the library has.
struct read_starts {
    using response = starts_response;
    static constexpr std::size_t max_size = 2;
    bool is_reset;

    errc check() const { return errc::none; }
    std::size_t size() const { return max_size; }
    void write(byte_writer& out) const
    {
        out.u8(65);
        out.u8(is_reset ? 1U : 0U);
    }
};

/// The server's end: a bank that answers a function itself. nullopt: somebody else's; an error: the exception to send.
struct device_bank : word_bank<4> {
    unsigned starts{513};

    std::optional<errc> respond(function_code function, auto& message)
    {
        if (function != starts_code) {
            return std::nullopt;
        }
        if (message.size != 2) {
            return errc::illegal_data_value;
        }
        bool const is_reset = message.bytes[1] == std::byte{1}; // read all that is needed before writing
        message.bytes[1] = static_cast<std::byte>(starts / 256U);
        message.bytes[2] = static_cast<std::byte>(starts % 256U);
        message.size = 3;
        starts = is_reset ? 0 : starts;
        return errc::none;
    }
};
//! [function]

} // namespace

int main()
{
    device_bank device;
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, bank_at{unit_id{3}, device}};
    single_request ask{unit_id{3}, read_starts{.is_reset = true}};
    unsigned seen[2]{};
    for (unsigned& each : seen) {
        auto const outcome = bench.run(ask);
        auto const response = outcome ? outcome->to<read_starts>() : outcome.error();
        if (not response) {
            return 1;
        }
        each = response->count;
        std::printf("the device was started %u times\n", each);
    }
    return seen[0] == 513 and seen[1] == 0 ? 0 : 1;
}
