// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Typed access: the frames of the manuals from typed settings, and typed values out of answers.
#include <rtuwire/client/access.hpp>

#include "support/far_end.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client/poller.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

constexpr station<atv12::device> drive{unit_id{2}};

template <typename Talk, std::size_t Size>
constexpr bool asks(Talk const& talk, std::array<std::byte, Size> const& frame)
{
    auto const question = talk.next();
    return question and same_bytes(question->frame(), frame);
}

STATIC_CHECK(asks(write<atv12::acc>(drive, 1.3_s), "02 06 23 29 00 0D 92 70"_hex));
STATIC_CHECK(asks(read<atv12::eta>(drive), "02 03 0C 81 00 01 D7 41"_hex));
STATIC_CHECK(asks(write_all<atv12::acc, atv12::dec>(drive, 2_s, 3_s),
                  "02 10 23 29 00 02 04 00 14 00 1E 73 A4"_hex));
STATIC_CHECK(asks(exchange<registers<atv12::nm1, atv12::nm2, atv12::nm3>, atv12::nc1, atv12::nc2,
                           atv12::nc3>(drive, 15_raw, 1500_raw, 0_raw),
                  "02 17 31 C5 00 03 31 D9 00 03 06 00 0F 05 DC 00 00 32 63"_hex));
// As many as the device takes, and a single one.
STATIC_CHECK(asks(exchange<registers<atv12::nm1>, atv12::nc1, atv12::nc2, atv12::nc3, atv12::nc4>(
                      drive, 15_raw, 1500_raw, 0_raw, 7_raw),
                  "02 17 31 C5 00 01 31 D9 00 04 08 00 0F 05 DC 00 00 00 07 EA F3"_hex));
STATIC_CHECK(asks(write_all<atv28::cmd, atv28::lfr>(station<atv28::device>{unit_id{2}},
                                                    atv28::command_word{0x000F}, 40_Hz),
                  "02 10 01 90 00 02 04 00 0F 01 90 C9 E8"_hex));
STATIC_CHECK(asks(write_in_steps_of<deciseconds, atv320::acc>(station<atv320::device>{unit_id{2}},
                                                              1.3_s),
                  "02 06 23 29 00 0D 92 70"_hex));
STATIC_CHECK(asks(write_in_steps_of<centiseconds, atv320::acc>(station<atv320::device>{unit_id{2}},
                                                               1.3_s),
                  "02 06 23 29 00 82 D3 D4"_hex));

/// Whether a question has room for its frame and for an answer of so many octets, and for no more.
template <std::size_t FrameSize, std::size_t AnswerSize>
constexpr bool takes_only(framed_question<FrameSize, AnswerSize> const& talk, std::size_t answer)
{
    return talk.next()->frame().size() == FrameSize and answer == AnswerSize;
}
STATIC_CHECK(takes_only(write_all<atv12::acc, atv12::dec>(drive, 2_s, 3_s), 5));
using three_words = registers<atv12::nm1, atv12::nm2, atv12::nm3>;
STATIC_CHECK(takes_only(exchange<three_words, atv12::nc1>(drive, 9_raw), 2 + 3 * 2));

constexpr bool reads_a_value()
{
    test::far_end unit;
    auto talk = read<atv12::uln>(station<atv12::device>{unit_id{1}});
    unit.link.converse(talk, unit.now);
    unit.transmit();
    unit.say("01 03 02 00 E6 39 CE"_hex);
    unit.link.converse(talk, unit.now);
    return talk.outcome() == volts{230};
}
PROOF("a register is read as a value with its unit", reads_a_value)

constexpr bool refuses_another_size()
{
    auto talk = read<atv12::uln>(drive);
    constexpr auto two = "03 04 00 E6 00 00"_hex;
    talk.accept(result<response>{response{two}});
    auto other = read<atv12::uln>(drive);
    other.accept(result<response>{response{}});
    return talk.outcome() == errc::wrong_length and other.outcome() == errc::wrong_length;
}
PROOF("an answer of another size is no value", refuses_another_size)

constexpr bool asks_only_what_fits()
{
    framed_question<10, 5> const question{unit_id{2},
                                          write_multiple_registers{1, register_block{1}}};
    return question.settled() and not question.next() and
           question.outcome() == errc::buffer_too_small;
}
PROOF("a question that does not fit its frame is not asked", asks_only_what_fits)

using monitor = read_plan<atv12::device, atv12::rfr, atv12::lcr, atv12::acc>;
STATIC_CHECK(monitor::request_count == 2);
STATIC_CHECK(same_bytes(monitor::frames(2)[1], "02 03 23 29 00 01 5E 75"_hex));

constexpr bool polls()
{
    test::far_end unit;
    poller<monitor> talk{station<atv12::device>{unit_id{1}}};
    unit.link.converse(talk, unit.now);
    unit.transmit();
    unit.say("01 03 06 01 F4 00 00 00 0F D1 75"_hex);
    unit.link.converse(talk, unit.now);
    unit.run(talk, milliseconds(10));
    bool const waits =
        talk.outcome() == errc::pending and talk.latest().get<atv12::rfr>() == signed_decihertz{};
    unit.say("01 03 02 00 0D 79 81"_hex);
    unit.link.converse(talk, unit.now);
    auto const& now = talk.latest();
    return waits and talk.outcome() and now.get<atv12::rfr>() == signed_decihertz{500} and
           now.get<atv12::lcr>() == deciamperes{15} and now.get<atv12::acc>() == deciseconds{13};
}
PROOF("a plan is polled round by round into a snapshot", polls)

} // namespace
