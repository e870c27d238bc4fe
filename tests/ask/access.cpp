// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Typed access: the frames of the manuals from typed settings, and typed values out of responses.
#include <rtuwire/ask/access.hpp>

#include "support/manual_unit.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/ask/poller.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr station<atv12::device> drive{unit_id{2}};

template <typename Conversation, std::size_t Size>
constexpr bool asks(Conversation const& conversation, std::array<std::byte, Size> const& frame)
{
    auto const request = conversation.next();
    return request and same_bytes(request->frame(), frame);
}

STATIC_CHECK(asks(write<atv12::acc>(drive, 1.3_s), "02 06 23 29 00 0D 92 70"_hex));
STATIC_CHECK(asks(read<atv12::eta>(drive), "02 03 0C 81 00 01 D7 41"_hex));
STATIC_CHECK(asks(write_all<atv12::acc, atv12::dec>(drive, 2_s, 3_s), "02 10 23 29 00 02 04 00 14 00 1E 73 A4"_hex));
STATIC_CHECK(asks(exchange<contiguous<atv12::nm1, atv12::nm2, atv12::nm3>, atv12::nc1, atv12::nc2, atv12::nc3>(
                      drive, 15_raw, 1500_raw, 0_raw),
                  "02 17 31 C5 00 03 31 D9 00 03 06 00 0F 05 DC 00 00 32 63"_hex));
// As many as the device takes, and a single one.
STATIC_CHECK(asks(exchange<contiguous<atv12::nm1>, atv12::nc1, atv12::nc2, atv12::nc3, atv12::nc4>(drive, 15_raw,
                                                                                                   1500_raw, 0_raw,
                                                                                                   7_raw),
                  "02 17 31 C5 00 01 31 D9 00 04 08 00 0F 05 DC 00 00 00 07 EA F3"_hex));
STATIC_CHECK(asks(write_all<atv28::cmd, atv28::lfr>(station<atv28::device>{unit_id{2}}, atv28::command_word{0x000F},
                                                    40_Hz),
                  "02 10 01 90 00 02 04 00 0F 01 90 C9 E8"_hex));
STATIC_CHECK(asks(write_with_step<deciseconds, atv320::acc>(station<atv320::device>{unit_id{2}}, 1.3_s),
                  "02 06 23 29 00 0D 92 70"_hex));
STATIC_CHECK(asks(write_with_step<centiseconds, atv320::acc>(station<atv320::device>{unit_id{2}}, 1.3_s),
                  "02 06 23 29 00 82 D3 D4"_hex));

/// Whether a request has room for its frame and for a response of so many bytes, and for no more.
template <std::size_t FrameSize, std::size_t AnswerSize>
constexpr bool takes_only(sized_request<FrameSize, AnswerSize> const& conversation, std::size_t response)
{
    return conversation.next()->frame().size() == FrameSize and response == AnswerSize;
}
STATIC_CHECK(takes_only(write_all<atv12::acc, atv12::dec>(drive, 2_s, 3_s), 5));
using three_words = contiguous<atv12::nm1, atv12::nm2, atv12::nm3>;
STATIC_CHECK(takes_only(exchange<three_words, atv12::nc1>(drive, 9_raw), 2 + 3 * 2));

// A value known only at run time: in whatever unit it is known, exact, or refused with the reason and not sent.
template <typename Value> constexpr auto ramp_of(Value value) { return write<atv12::acc>(drive, checked(value)); }
constexpr bool writes_what_fits()
{
    bool ok = true;
    for (int tenths = 0; tenths <= 9'999; tenths += 99) {
        auto const tell = ramp_of(tenths * 0.1_s);
        auto const byte = [&](std::size_t at) { return std::to_integer<int>(tell.next()->frame()[at]); };
        ok = ok and tell.next() and byte(1) == 6 and byte(4) == tenths / 256 and byte(5) == tenths % 256;
    }
    return ok and asks(ramp_of(deciseconds{13}), "02 06 23 29 00 0D 92 70"_hex) and
           asks(ramp_of(1.30_s), "02 06 23 29 00 0D 92 70"_hex) and
           asks(write<atv12::acc>(drive, setting<atv12::acc>::checked(1.3_s)), "02 06 23 29 00 0D 92 70"_hex);
}
PROOF("a value known at run time is written as one known at compile time", writes_what_fits)

template <typename Conversation> constexpr bool is_refused(Conversation conversation, errc why)
{
    bool ok = conversation.settled() and not conversation.next() and conversation.outcome() == why;
    conversation.again();
    return ok and conversation.settled() and not conversation.next();
}
constexpr bool refuses_what_does_not_fit()
{
    constexpr station<atv320::device> other{unit_id{2}};
    std::int32_t const past_end = 10'000;
    bool ok = is_refused(ramp_of(past_end * 0.1_s), errc::value_too_high);
    ok = ok and is_refused(ramp_of(past_end * 100 * 1_s), errc::value_too_high);
    ok = ok and is_refused(ramp_of(-past_end * 0.1_s), errc::value_too_low);
    ok = ok and is_refused(ramp_of(past_end * 0.01_s + 0.01_s), errc::value_between_steps);
    ok = ok and
         is_refused(write_with_step<centiseconds, atv320::acc>(other, checked(past_end * 1_s)), errc::value_too_high);
    ok = ok and asks(write_with_step<centiseconds, atv320::acc>(other, checked(1.3_s)), "02 06 23 29 00 82 D3 D4"_hex);
    ok = ok and asks(write_all<atv12::acc, atv12::dec>(drive, checked(2_s), checked(deciseconds{30})),
                     "02 10 23 29 00 02 04 00 14 00 1E 73 A4"_hex);
    ok = ok and is_refused(write_all<atv12::acc, atv12::dec>(drive, checked(2_s), checked(past_end * -1_s)),
                           errc::value_too_low);
    return ok and is_refused(write<atv12::sll>(drive, checked(static_cast<value_of<atv12::sll>>(past_end))),
                             errc::value_without_meaning);
}
PROOF("a value that does not fit is not sent, and the outcome says why", refuses_what_does_not_fit)

constexpr bool reads_a_value()
{
    test::manual_unit unit;
    auto conversation = read<atv12::uln>(station<atv12::device>{unit_id{1}});
    unit.link.converse(conversation, unit.now);
    unit.transmit();
    unit.say("01 03 02 00 E6 39 CE"_hex);
    unit.link.converse(conversation, unit.now);
    return conversation.outcome() == volts{230};
}
PROOF("a register is read as a value with its unit", reads_a_value)

constexpr bool refuses_another_size()
{
    auto conversation = read<atv12::uln>(drive);
    constexpr auto two = "03 04 00 E6 00 00"_hex;
    conversation.accept(result<response>{response{two}});
    auto other = read<atv12::uln>(drive);
    other.accept(result<response>{response{}});
    return conversation.outcome() == errc::wrong_length and other.outcome() == errc::wrong_length;
}
PROOF("a response of another size is no value", refuses_another_size)

constexpr bool asks_only_what_fits()
{
    sized_request<10, 5> const request{unit_id{2}, write_multiple_registers{1, register_block{1}}};
    return request.settled() and not request.next() and request.outcome() == errc::buffer_too_small;
}
PROOF("a request that does not fit its frame is not asked", asks_only_what_fits)

using monitor = read_plan<atv12::device, atv12::rfr, atv12::lcr, atv12::acc>;
STATIC_CHECK(monitor::request_count == 2);
STATIC_CHECK(same_bytes(read_frames<monitor>(unit_id{2})[1], "02 03 23 29 00 01 5E 75"_hex));

constexpr bool frames_are_of_the_blocks()
{
    for (std::uint32_t unit = 1; unit <= 247; unit += 41) {
        unit_id const of{*unit_id::checked(unit)};
        auto const frames = read_frames<monitor>(of);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            address_block const block = monitor::requests()[i];
            auto const frame = encode(of, read_holding_registers{block.start, block.count});
            if (not same_bytes(frames[i], *frame)) {
                return false;
            }
        }
    }
    return read_frames<monitor>(unit_id{2}).size() == monitor::request_count;
}
PROOF("the frames of a plan are those of its blocks", frames_are_of_the_blocks)

constexpr bool polls()
{
    test::manual_unit unit;
    poller<monitor> conversation{station<atv12::device>{unit_id{1}}};
    unit.link.converse(conversation, unit.now);
    unit.transmit();
    unit.say("01 03 06 01 F4 00 00 00 0F D1 75"_hex);
    unit.link.converse(conversation, unit.now);
    unit.run(conversation, milliseconds(10));
    bool const waits =
        conversation.outcome() == errc::busy and conversation.latest().get<atv12::rfr>() == signed_decihertz{};
    unit.say("01 03 02 00 0D 79 81"_hex);
    unit.link.converse(conversation, unit.now);
    auto const& now = conversation.latest();
    return waits and conversation.outcome() and now.get<atv12::rfr>() == signed_decihertz{500} and
           now.get<atv12::lcr>() == deciamperes{15} and now.get<atv12::acc>() == deciseconds{13};
}
PROOF("a plan is polled round by round into a snapshot", polls)

} // namespace
