// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What is at the other end of a line that is compared: units of every kind, echoes, noise. It only makes events;
// who compares hands each to both engines.
#pragma once

#include <map>

#include "compare.hpp"

namespace compare {

using model::bytes;
using model::microseconds;

/// Something that happens on the line.
struct line_event {
    enum class kind { chunk, damage, sent } what;
    model::bytes of{};
};

class manual_unit {
public:
    enum class habit { quick, slow, silent, faulty, busy };
    static constexpr std::uint8_t units = 6;

    manual_unit(random_source& roll, model::line_times const& times, microseconds response, bool is_echoing)
        : roll_{roll}, times_{times}, response_{response}, is_echoing_{is_echoing}
    {
        bool const is_rush = roll.chance(3);
        for (habit& each : habits_) {
            each = is_rush
                       ? habit::busy
                       : roll.any({habit::quick, habit::quick, habit::slow, habit::silent, habit::faulty, habit::busy});
        }
    }

    std::multimap<microseconds, line_event> to_come{};

    /// A request leaves from `now` on.
    void hear(bytes const& frame, microseconds now)
    {
        microseconds const end = now + times_.characters(frame.size());
        microseconds const told = end + (roll_.chance(20) ? roll_.below(3'000) : 0);
        if (not roll_.chance(3)) {
            to_come.emplace(told, line_event{line_event::kind::sent});
        }
        if (roll_.chance(is_echoing_ ? 95 : 3)) {
            echo(frame, now);
        }
        if (frame.size() >= 4 and frame[0] >= 1 and frame[0] <= units) {
            response(frame, end);
        }
    }
    /// Something that nobody asked for.
    void disturb(microseconds now)
    {
        microseconds const at = now + roll_.below(20'000);
        switch (roll_.below(4)) {
        case 0: to_come.emplace(at, line_event{line_event::kind::damage}); break;
        case 1: say({roll_.byte()}, at); break;
        case 2: {
            bytes noise;
            for (unsigned i = 1 + roll_.below(12); i > 0; --i) {
                noise.push_back(roll_.chance(30) ? static_cast<std::uint8_t>(1 + roll_.below(units)) : roll_.byte());
            }
            say(noise, at);
            break;
        }
        default: say(last_response_, at);
        }
    }

private:
    void say(bytes const& what, microseconds at)
    {
        if (what.empty()) {
            return;
        }
        std::size_t done = 0;
        while (done < what.size()) {
            std::size_t const left = what.size() - done;
            std::size_t const part = roll_.chance(60) ? left : 1 + roll_.below(left);
            auto const from = what.begin() + static_cast<std::ptrdiff_t>(done);
            at += times_.characters(part);
            to_come.emplace(at,
                            line_event{line_event::kind::chunk, bytes(from, from + static_cast<std::ptrdiff_t>(part))});
            done += part;
            if (roll_.chance(12)) {
                at += roll_.below(3) == 0 ? times_.frame_end + roll_.below(3) - 1 : microseconds{roll_.below(6'000)};
            }
            if (roll_.chance(2)) {
                to_come.emplace(at, line_event{line_event::kind::damage});
            }
        }
    }
    void echo(bytes what, microseconds now)
    {
        switch (roll_.below(10)) {
        case 0: what[roll_.below(what.size())] ^= 4; break;
        case 1: what.resize(roll_.below(what.size())); break;
        case 2: what.push_back(roll_.byte()); break;
        default: break;
        }
        say(what, now + (roll_.chance(30) ? roll_.below(9'000) : 0));
    }
    void response(bytes const& frame, microseconds end)
    {
        habit const own = habits_[frame[0]];
        if (own == habit::silent and not roll_.chance(5)) {
            return;
        }
        bytes said = response_to(frame);
        unsigned const faults = own == habit::faulty ? 60 : 6;
        if (own == habit::busy and roll_.chance(90)) {
            said = exception(frame, roll_.any<unsigned>({5, 6, 6, 6}));
        }
        said = model::with_crc(said);
        if (roll_.chance(faults)) {
            said = spoilt(said, frame);
        }
        microseconds delay = roll_.chance(80) ? roll_.below(12'000) : -microseconds{roll_.below(3'000)};
        if (own == habit::slow) {
            delay = static_cast<microseconds>(static_cast<double>(response_) * 0.03 * (3 + roll_.below(98)));
        }
        last_response_ = said;
        say(said, end + delay);
        if (roll_.chance(3)) {
            say(said, end + delay + times_.characters(said.size()) + roll_.below(20'000));
        }
    }
    bytes spoilt(bytes said, bytes const& asked)
    {
        std::size_t const body = said.size() - 2;
        switch (roll_.below(16)) {
        case 0: said[roll_.below(said.size())] ^= static_cast<std::uint8_t>(1 + roll_.below(255)); return said;
        case 1: said[body] ^= 0x10; return said;
        case 2: said.pop_back(); return said;
        case 3: said.push_back(roll_.chance(50) ? 0 : roll_.byte()); return said;
        case 4: said.insert(said.begin(), roll_.byte()); return said;
        case 5: return asked;
        case 6: said[0] = static_cast<std::uint8_t>(1 + roll_.below(units)); break;
        case 7: said[1] = static_cast<std::uint8_t>(1 + roll_.below(24)); break;
        case 8: said[2 % body] ^= static_cast<std::uint8_t>(1 + roll_.below(3)); break;
        case 9: said[roll_.below(body)] = roll_.byte(); break;
        case 10: return bytes(said.begin(), said.begin() + 1 + roll_.below(4));
        case 11: said.resize(body - 1); break;
        case 12: return model::with_crc(exception(asked, roll_.below(256)));
        case 13: return model::with_crc(exception(asked, roll_.below(13)));
        case 14:
            said.resize(3);
            said[1] |= 0x80;
            break;
        default:
            said.insert(said.begin(), roll_.byte());
            said.insert(said.begin(), roll_.byte());
            return said;
        }
        said.resize(std::min(said.size(), body));
        return model::with_crc(said);
    }
    static bytes exception(bytes const& to, unsigned code)
    {
        bytes said(3);
        said[0] = to[0];
        said[1] = static_cast<std::uint8_t>(to[1] | 0x80);
        said[2] = static_cast<std::uint8_t>(code);
        return said;
    }
    /// Without its CRC.
    bytes response_to(bytes const& frame)
    {
        bytes said;
        said.reserve(600);
        said.push_back(frame[0]);
        said.push_back(frame[1]);
        std::size_t const body = frame.size() - 2;
        auto const counted = [&](std::size_t count) {
            said.push_back(static_cast<std::uint8_t>(count));
            for (std::size_t i = 0; i < (count & 0xFFU); ++i) {
                said.push_back(roll_.chance(40) ? 0 : roll_.byte());
            }
        };
        std::size_t const quantity = body >= 6 ? frame[4] * 256U + frame[5] : 0U;
        switch (frame[1]) {
        case 1:
        case 2: counted((quantity + 7) / 8); break;
        case 3:
        case 4:
        case 23: counted(2 * quantity); break;
        case 15:
        case 16: said.assign(frame.begin(), frame.begin() + 6); break;
        case 7: said.push_back(roll_.byte()); break;
        case 11: said.resize(6, roll_.byte()); break;
        case 12:
        case 17:
        case 20: counted(roll_.below(9)); break;
        case 24: {
            auto const words = static_cast<std::uint8_t>(roll_.below(4));
            said.resize(6);
            said[3] = static_cast<std::uint8_t>(2 + 2 * words);
            said[5] = words;
            said.resize(6U + 2U * words, roll_.byte());
            break;
        }
        case 43: identify(said, frame); break;
        default:
            if (frame[1] < 100) {
                said.assign(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(body));
            } else {
                for (unsigned i = roll_.below(12); i > 0; --i) {
                    said.push_back(roll_.byte());
                }
            }
        }
        said.resize(std::min<std::size_t>(said.size(), 254));
        return said;
    }

    /// A page of identification, not always a good one.
    void identify(bytes& said, bytes const& frame)
    {
        said.resize(8);
        said[2] = roll_.chance(95) ? 14 : 13;
        said[3] = roll_.chance(95) ? frame[3] : roll_.byte();
        said[4] = roll_.any<std::uint8_t>({1, 0x81, 2, 0x83, 4});
        bool const follows = roll_.chance(20);
        said[5] = follows ? 0xFF : (roll_.chance(95) ? 0 : roll_.byte());
        unsigned const objects = roll_.below(4);
        said[6] = follows ? static_cast<std::uint8_t>(frame[4] + objects) : 0;
        said[7] = static_cast<std::uint8_t>(objects);
        for (unsigned i = 0; i < objects; ++i) {
            said.push_back(static_cast<std::uint8_t>(roll_.chance(90) ? frame[4] + i : roll_.byte()));
            auto const size = static_cast<std::uint8_t>(roll_.below(5));
            said.push_back(size);
            for (unsigned k = 0; k < size; ++k) {
                said.push_back(roll_.byte());
            }
        }
    }

    random_source& roll_;
    model::line_times times_;
    microseconds response_;
    bool is_echoing_;
    habit habits_[units + 1];
    bytes last_response_{};
};

} // namespace compare
