// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A meter whose response to function 03 has a byte count of 16 bits, read by a client that knows it.
#include <iostream>

#include <rtuwire/client.hpp>
#include <rtuwire/print.hpp>

using namespace rtuwire;

namespace {

constexpr line_timing timing{9'600, character_format::none_8_1};

//! [request]
/// Response: unit, 03, a byte count of two bytes, words, CRC.
struct counted_words {
    static constexpr std::size_t max_size = 123; // without unit and CRC
    register_view words;

    static constexpr result<counted_words> decode(byte_view pdu)
    {
        return counted_words{register_view{pdu.subspan(3)}};
    }
};

struct read_counted_words {
    using response = counted_words;
    static constexpr function_code code = function_code::read_holding_registers;
    static constexpr std::size_t max_size = 5;
    std::uint16_t start;
    std::uint16_t count;

    constexpr errc check() const { return count == 0 or count > 60 ? errc::invalid_quantity : errc::none; }
    constexpr std::size_t size() const { return max_size; }
    constexpr void write(byte_writer& out) const
    {
        out.u8(3);
        out.u16(start);
        out.u16(count);
    }
    /// How many bytes the frame has, from the unit to the CRC, as soon as those so far tell it; else 0.
    static constexpr std::size_t length_of_response(byte_view so_far)
    {
        return so_far.size() < 4
                   ? 0
                   : 6 + 256 * std::to_integer<std::size_t>(so_far[2]) + std::to_integer<std::size_t>(so_far[3]);
    }
    /// Whether it answers the request; both without unit and CRC. Of a `raw_pdu` of this code, too, which may be shorter.
    static constexpr errc check_response(byte_view asked, byte_view came)
    {
        bool const fits = asked.size() == max_size and came.size() == 3 + 2 * std::to_integer<std::size_t>(asked[4]);
        return fits ? errc::none : errc::response_mismatch;
    }
};
//! [request]

//! [ask]
inline constexpr client_needs<public_functions_and<read_counted_words>> meter_needs{};
basic_client<meter_needs> link{timing}; // likewise blocking_client<posix_serial, meter_needs>
single_request ask{unit_id{1}, read_counted_words{.start = 0x7002, .count = 1}};
//! [ask]

/// The line: what the meter sends behind a request.
constexpr auto came = "01 03 00 02 17 81 2B 9A"_hex;

} // namespace

int main()
{
    for (std::uint32_t ms = 0; ms < 1'000 and not ask.settled(); ++ms) {
        instant const now{ms * 1'000};
        link.advance(now);
        link.converse(ask, now);
        if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
            link.sent(now);
            link.receive(came, now + milliseconds(4));
        }
    }
    auto const read = ask.outcome();
    auto const words = read ? read->to<read_counted_words>() : read.error();
    if (not words) {
        std::cerr << words.error() << '\n';
        return 1;
    }
    std::cout << words->words[0] << '\n';
    return words->words[0] == 0x1781 ? 0 : 1;
}
