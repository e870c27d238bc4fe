// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The times of a line, held against the specification's table.
#include <rtuwire/rtu/line.hpp>

#include "support/catch.hpp"
#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr auto e = character_format::even_8_1;
constexpr auto n1 = character_format::none_8_1;
constexpr auto e2 = character_format::even_8_2;

constexpr bool lasts(std::uint32_t rate, character_format format, std::uint32_t character, std::uint32_t t1_5,
                     std::uint32_t t3_5)
{
    line_timing const line{rate, format};
    return line.characters(1) == microseconds(character) and line.t1_5() == microseconds(t1_5) and
           line.t3_5() == microseconds(t3_5) and line.frame_end() == line.t3_5();
}

STATIC_CHECK(lasts(1'200, e, 9'167, 13'751, 32'084));
STATIC_CHECK(lasts(4'800, e, 2'292, 3'438, 8'021));
STATIC_CHECK(lasts(9'600, e, 1'146, 1'719, 4'011));
STATIC_CHECK(lasts(19'200, e, 573, 860, 2'006));
STATIC_CHECK(lasts(38'400, e, 287, 750, 1'750));
STATIC_CHECK(lasts(115'200, e, 96, 750, 1'750));
STATIC_CHECK(lasts(9'600, n1, 1'042, 1'563, 3'646));
STATIC_CHECK(lasts(19'200, n1, 521, 782, 1'823));
STATIC_CHECK(lasts(38'400, n1, 261, 750, 1'750));
// Parity and two stop bits: 12 bits, which the specification has not.
STATIC_CHECK(lasts(9'600, e2, 1'250, 1'875, 4'375));
STATIC_CHECK(lasts(19'200, e2, 625, 938, 2'188));
STATIC_CHECK(lasts(38'400, e2, 313, 750, 1'750));
STATIC_CHECK(lasts(115'200, character_format::odd_8_2, 105, 750, 1'750));

// The silences are fixed above 19 200 bit/s, not only from the next usual rate on.
STATIC_CHECK(line_timing{19'201, e}.t3_5() == microseconds(1'750));
STATIC_CHECK(line_timing{20'000, e}.t3_5() == microseconds(1'750));
// Rounded up by what is needed: nothing, or for the least remainder one.
STATIC_CHECK(line_timing{10'000, n1}.characters(1) == microseconds(1'000));
STATIC_CHECK(line_timing{41'841, n1}.characters(1) == microseconds(240));

STATIC_CHECK(bits_per_character(character_format::odd_8_1) == 11);
STATIC_CHECK(bits_per_character(character_format::none_8_2) == 11);
STATIC_CHECK(bits_per_character(n1) == 10);
STATIC_CHECK(bits_per_character(e2) == 12);
STATIC_CHECK(bits_per_character(character_format::odd_8_2) == 12);

// The slowest line with the longest characters: the longest duration and a frame's 47 s are less than half the counter of an
// instant; at 64 bit/s they would not be.
STATIC_CHECK(line_timing{65, e2}.characters(256) == microseconds(256 * 184'616));
STATIC_CHECK(longest_duration.microseconds + line_timing{65, e2}.characters(256).microseconds < 1U << 31U);
STATIC_CHECK(longest_duration.microseconds + 256U * (12'000'000U / 64U) >= 1U << 31U);
STATIC_CHECK(line_timing{4'294'967'295, e}.has_wire());

STATIC_CHECK(line_timing{9'600, e}.characters(256) == microseconds(256 * 1'146));
STATIC_CHECK(line_timing{1'200, e}.characters(256) == microseconds(256 * 9'167));

// A host waits longer for the end of a frame, never shorter than t3.5; what it sends is timed alike.
STATIC_CHECK(line_timing::host(19'200, e).frame_end() == milliseconds(50));
STATIC_CHECK(line_timing::host(19'200, e).t3_5() == microseconds(2'006));
STATIC_CHECK(line_timing::host(19'200, e, milliseconds(1)).frame_end() == microseconds(2'006));

// The silence before sending is t3.5, or what is given; when a frame is complete does not depend on it.
STATIC_CHECK(line_timing{19'200, e}.silence() == microseconds(2'006));
STATIC_CHECK(line_timing::host(115'200, e).silence() == microseconds(1'750));
STATIC_CHECK(line_timing::host(115'200, e).with_silence(duration{}).silence() == duration{});
STATIC_CHECK(line_timing::host(115'200, e).with_silence(duration{}).t3_5() == microseconds(1'750));
STATIC_CHECK(line_timing::host(115'200, e).with_silence(duration{}).frame_end() == milliseconds(50));
STATIC_CHECK(line_timing::host(115'200, e).with_silence(milliseconds(80)).frame_end() == milliseconds(50));
STATIC_CHECK(line_timing{19'200, e}.with_silence(milliseconds(1)).frame_end() == microseconds(2'006));

// Behind a USB adapter nothing changes up to 38 400 bit/s; above, only the silence before sending is left out.
constexpr bool is_as_host(std::uint32_t rate, character_format format, bool rests)
{
    line_timing const usb = line_timing::usb(rate, format);
    line_timing const host = line_timing::host(rate, format);
    return usb.characters(256) == host.characters(256) and usb.t3_5() == host.t3_5() and usb.has_wire() and
           usb.frame_end() == host.frame_end() and usb.silence() == (rests ? host.t3_5() : duration{});
}
STATIC_CHECK(is_as_host(65, e2, true));
STATIC_CHECK(is_as_host(9'600, n1, true));
STATIC_CHECK(is_as_host(19'200, e, true));
STATIC_CHECK(is_as_host(38'400, e, true));
STATIC_CHECK(is_as_host(38'401, e, false));
STATIC_CHECK(is_as_host(57'600, n1, false));
STATIC_CHECK(is_as_host(115'200, e, false));
STATIC_CHECK(is_as_host(115'200, e2, false));
STATIC_CHECK(is_as_host(4'000'000, n1, false));
STATIC_CHECK(line_timing::usb(115'200, e, milliseconds(20)).frame_end() == milliseconds(20));
STATIC_CHECK(line_timing::usb(115'200, e, milliseconds(1)).frame_end() == microseconds(1'750));

// The silence before sending follows the rate where that is wanted and the line is faster than 115 200 bit/s.
constexpr duration silence_by_rate(std::uint32_t rate, character_format format, std::uint32_t least)
{
    return line_timing::host(rate, format).with_silence_by_rate(microseconds(least)).silence();
}
STATIC_CHECK(silence_by_rate(1'000'000, e, 0) == microseconds(39)); // 38.5
STATIC_CHECK(silence_by_rate(1'000'000, n1, 0) == microseconds(35));
STATIC_CHECK(silence_by_rate(1'000'000, e2, 0) == microseconds(42));
STATIC_CHECK(silence_by_rate(1'000'000, e, 200) == microseconds(200));
STATIC_CHECK(silence_by_rate(230'400, e, 0) == microseconds(168)); // 3.5 characters of 48 us, each rounded up from 47.7
STATIC_CHECK(silence_by_rate(128'000, e, 0) == microseconds(301));
STATIC_CHECK(silence_by_rate(115'200, e, 0) == microseconds(1'750));
STATIC_CHECK(silence_by_rate(115'200, n1, 0) == microseconds(1'750));
STATIC_CHECK(silence_by_rate(19'200, e, 0) == microseconds(2'006));
STATIC_CHECK(line_timing::without_wire().with_silence_by_rate(milliseconds(1)).silence() == duration{});
STATIC_CHECK(line_timing::host(1'000'000, e).with_silence_by_rate(duration{}).t3_5() == microseconds(1'750));
STATIC_CHECK(line_timing::host(1'000'000, e).with_silence_by_rate(duration{}).frame_end() == milliseconds(50));

// Without a wire nothing takes time but the end of what has no length rule.
STATIC_CHECK(line_timing::without_wire().characters(256) == duration{});
STATIC_CHECK(line_timing::without_wire().silence() == duration{});
STATIC_CHECK(line_timing::without_wire().frame_end() == milliseconds(50));
STATIC_CHECK(line_timing::without_wire(milliseconds(5)).frame_end() == milliseconds(5));

} // namespace

// A rate that a program reads from somewhere may be anything, 0 too.
TEST_CASE("A rate that is too low at run time counts as the slowest")
{
    for (std::uint32_t rate = 0; rate < 65; ++rate) {
        CHECK(line_timing{rate, e}.characters(1) == microseconds(169'231));
        CHECK(line_timing{rate, e2}.characters(1) == microseconds(184'616));
        CHECK(line_timing::usb(rate, n1).t3_5() == microseconds(538'462));
    }
}
