// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The server against its model over random schedules: compare_server COUNT [SEED].
#include <rtuwire/server/server.hpp>

#include "compare.hpp"
#include "model_server.hpp"

using compare::random_source;
using compare::report;
using model::bytes;
using model::microseconds;

namespace {

constexpr std::uint8_t own_unit = 1;

struct world {
    random_source& roll;
    report& told;
    compare::clock clock;
    model::line_times times;
    rtuwire::counting_server engine;
    rtuwire::word_bank<model::server::registers> bank{};
    model::server second;
    microseconds now{0};
    bytes pending{};
    bytes last_foreign{};
    std::size_t leaving{0};
    bool is_late{false}; ///< stopped, and time did not pass for it since: no deadline is asked for

    world(random_source& with, report& to, std::uint32_t start, std::uint32_t bits, microseconds end,
          std::optional<microseconds> silence)
        : roll{with}, told{to}, clock{start}, times{bits, 11, end, silence},
          engine{rtuwire::unit_id{own_unit}, compare::line_of(bits, rtuwire::character_format::even_8_1, end, silence)},
          second{own_unit, times}
    {}

    bytes request()
    {
        std::uint8_t const unit = roll.any<std::uint8_t>({1, 1, 1, 1, 0, 2, 2, 3});
        std::uint8_t const start = static_cast<std::uint8_t>(roll.below(18));
        std::uint8_t const count = static_cast<std::uint8_t>(roll.below(6));
        bytes frame{unit};
        auto const add = [&](std::initializer_list<unsigned> of) {
            for (unsigned const each : of) {
                frame.push_back(static_cast<std::uint8_t>(each));
            }
        };
        auto const words = [&](unsigned of) {
            for (unsigned i = 0; i < 2 * of; ++i) {
                frame.push_back(roll.chance(50) ? 0 : roll.byte());
            }
        };
        switch (roll.below(12)) {
        case 0:
        case 1:
        case 2: add({3, 0, start, 0, count}); break;
        case 3:
        case 4: add({6, 0, start, roll.byte(), roll.byte()}); break;
        case 5:
            add({16, 0, start, 0, count, 2U * count});
            words(count);
            break;
        case 6: {
            unsigned const read = roll.below(5);
            add({23, 0, start, 0, read, 0, roll.below(18), 0, count, 2U * count});
            words(count);
            break;
        }
        case 7: add({8, 0, roll.below(0x16), 0, 0}); break;
        case 8: add({8, 0, 0x0A + roll.below(9), 0, 0}); break;
        case 9: add({8, 0, roll.below(5), roll.any<unsigned>({0, 0xFF, 1}), 0}); break;
        case 10: add({roll.below(256), 0, start, 0, count}); break;
        default: add({1 + roll.below(4), 0, start, 0, count}); break;
        }
        if (roll.chance(5)) {
            frame.pop_back();
        }
        return damaged(model::with_crc(frame));
    }
    bytes response_to(bytes const& asked)
    {
        bytes frame{asked[0], asked[1]};
        if (roll.chance(15)) {
            frame[1] |= 0x80;
            frame.push_back(2);
        } else if (asked[1] <= 4 or asked[1] == 23) {
            auto const count = static_cast<std::uint8_t>(asked[1] <= 2 ? 1 + roll.below(6) : 2 * roll.below(5));
            frame.push_back(count);
            for (unsigned i = 0; i < count; ++i) {
                frame.push_back(roll.chance(60) ? 0 : roll.byte());
            }
        } else {
            frame.insert(frame.end(), asked.begin() + 2,
                         asked.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(6, asked.size() - 2)));
        }
        return damaged(model::with_crc(frame));
    }
    bytes damaged(bytes frame)
    {
        switch (roll.below(20)) {
        case 0: frame[roll.below(frame.size())] ^= 8; break;
        case 1: frame.pop_back(); break;
        case 2: frame.push_back(roll.chance(60) ? 0 : roll.byte()); break;
        case 3: frame.insert(frame.begin(), roll.byte()); break;
        default: break;
        }
        return frame;
    }

    void check()
    {
        if (told.is_told and not told.failed()) {
            auto const next = second.poll_deadline();
            told.steps.back() += "  [phase " + std::to_string(static_cast<int>(second.now_in())) +
                                 (second.line().is_quiet ? " quiet" : " busy") + ", line " +
                                 std::to_string(static_cast<int>(second.line().at)) + ", frame " +
                                 compare::hex(second.line().frame) + ", next " +
                                 (next ? std::to_string(*next) : "never") + "]";
        }
        for (std::uint16_t i = 0; i < model::server::registers; ++i) {
            told.same("word", bank.get(i), second.words[i]);
        }
        told.same("asked", engine.is_asked(), second.is_asked());
        if (is_late) {
            return;
        }
        auto const expected = second.poll_deadline();
        rtuwire::deadline const next = engine.poll_deadline();
        told.same("whether there is a deadline", next.has_value(), expected.has_value());
        if (next and expected) {
            told.same("deadline, from now", static_cast<std::int32_t>(next->microseconds - clock.at(now).microseconds),
                      *expected - now);
        }
    }
    void step(char const* what, bytes const& of = {})
    {
        told.step("%lld %s %s", static_cast<long long>(now), what, compare::hex(of).c_str());
    }

    void receive(bytes const& chunk)
    {
        step("receive", chunk);
        compare::receive(engine, chunk, clock.at(now));
        second.receive(chunk, now);
        check();
    }
    void advance()
    {
        step("advance");
        engine.advance(clock.at(now));
        second.advance(now);
        is_late = false;
        check();
    }
    void hear()
    {
        std::size_t const part = roll.chance(60) ? pending.size() : 1 + roll.below(pending.size());
        bytes const chunk(pending.begin(), pending.begin() + static_cast<std::ptrdiff_t>(part));
        pending.erase(pending.begin(), pending.begin() + static_cast<std::ptrdiff_t>(part));
        now += times.characters(chunk.size()) + (roll.chance(10) ? roll.below(4000) : 0);
        receive(chunk);
    }

    void pass()
    {
        auto const next = second.poll_deadline();
        switch (roll.below(12)) {
        case 0: break;
        case 1: now += roll.below(3000); break;
        case 2: now += times.t3_5 + roll.below(3) - 1; break;
        case 3: now += times.frame_end + roll.below(3) - 1; break;
        case 4: now += roll.below(200'000); break;
        case 5:
            if (not next and pending.empty()) {
                now += microseconds{roll.below(11'000)} * 1'000'000; // nothing is due for hours
            } else if (roll.chance(10)) {                            // the program is stopped
                now += microseconds{roll.any<unsigned>({1, 36, 50, 71, 110, 142})} * 60'000'000;
                is_late = true;
                if (roll.chance(50)) {
                    advance();
                }
            }
            break;
        default:
            if (next and *next > now and pending.empty()) {
                now = std::max(now, *next + (roll.chance(80) ? 0 : microseconds{roll.below(3)} - 1));
            }
        }
        if (pending.empty() and roll.chance(50)) {
            if (not last_foreign.empty() and roll.chance(60)) {
                pending = response_to(last_foreign);
                last_foreign.clear();
            } else {
                pending = request();
                if (pending[0] > 1 and pending.size() >= 4) {
                    last_foreign = pending;
                }
            }
        }
        if (not pending.empty() and roll.chance(85)) {
            hear();
        }
        if (roll.chance(3)) {
            step("receive_error");
            engine.receive_error(clock.at(now));
            second.receive_error(now);
            check();
        }
        if (roll.chance(2)) {
            step("receive_overrun");
            engine.receive_overrun(clock.at(now));
            second.receive_overrun(now);
            check();
        }
        if ((leaving > 0 and roll.chance(85)) or roll.chance(1)) {
            now += times.characters(leaving);
            leaving = 0;
            step("sent");
            engine.sent(clock.at(now));
            second.sent(now);
            check();
        }
        if (roll.chance(80)) {
            advance();
        }
        if (roll.chance(85)) {
            step("serve");
            engine.serve(bank, clock.at(now));
            second.serve(now);
            is_late = false;
            check();
        }
        if (roll.chance(90)) {
            step("poll_transmit");
            bytes const frame = compare::copy(engine.poll_transmit());
            told.same("bytes to send", frame, second.poll_transmit());
            check();
            leaving = frame.size();
        }
    }

    void run()
    {
        told.step("times: character %lld, t3.5 %lld, frame end %lld", static_cast<long long>(times.character),
                  static_cast<long long>(times.t3_5), static_cast<long long>(times.frame_end));
        advance();
        unsigned const passes = 30 + roll.below(31);
        for (unsigned i = 0; i < passes and not told.failed(); ++i) {
            pass();
        }
    }
};

} // namespace

int main(int argc, char** argv)
{
    return compare::main(argc, argv, [](random_source& roll, report& told) {
        std::uint32_t const start =
            roll.chance(70) ? 0U - roll.below(3'000'000) : static_cast<std::uint32_t>(roll.next());
        std::uint32_t const bits = roll.any<std::uint32_t>({4'800, 9'600, 19'200, 38'400, 115'200, 0});
        microseconds const end = roll.any<microseconds>({0, 0, 1'000, 8'000, 50'000});
        world{roll, told, start, bits, end, compare::any_silence(roll)}.run();
    });
}
