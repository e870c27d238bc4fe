// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "check/hostile.hpp"

#include <algorithm>
#include <random>
#include <span>

#include "frame/hex_text.hpp"
#include "line/end_wish.hpp"
#include "motion/raw_effect.hpp"

namespace tool {

namespace {

using frame_list = std::vector<line_bytes>;

constexpr std::size_t frames_to_a_read = 100;

/// Codes that no document gives a meaning, and that no maker is known to use.
bool is_unknown_function(unsigned code)
{
    bool const is_public = (code >= 1 and code <= 8) or code == 0x0B or code == 0x0C or
                           (code >= 0x0F and code <= 0x11) or (code >= 0x14 and code <= 0x18) or code == 0x2B;
    bool const is_of_makers = (code >= 65 and code <= 72) or (code >= 100 and code <= 110) or code == 90;
    return code > 0 and code < 0x80 and not is_public and not is_of_makers;
}

class hostile_line {
public:
    hostile_line(checked_unit& unit, clause const& which, std::chrono::seconds time, std::uint32_t seed)
        : unit_{unit}, which_{which}, time_{time}, random_{seed}
    {}

    judgement run()
    {
        if (which_.id == "H01") {
            return for_a_time([this] { return readable_frame(); }, true);
        }
        if (which_.id == "H02") {
            return for_a_time([this] { return noise(); }, false);
        }
        if (which_.id == "H06") {
            return babble();
        }
        return each_alone(which_.id == "H03" ? every_code() : which_.id == "H04" ? overlong() : cut_reads());
    }

private:
    std::byte unit() const { return std::byte{unit_.where().unit}; }
    unsigned drawn(unsigned most) { return std::uniform_int_distribution<unsigned>{0, most}(random_); }

    /// With a right CRC, by functions that read or that nobody has.
    line_bytes readable_frame()
    {
        constexpr unsigned reading[]{1, 2, 3, 4, 8, 0x2B};
        unsigned code = reading[drawn(5)];
        if (drawn(2) == 0) {
            do {
                code = drawn(0x7F);
            } while (not is_unknown_function(code));
        }
        line_bytes frame{unit(), static_cast<std::byte>(code)};
        bool const is_short = drawn(3) != 0;
        unsigned const size = drawn(is_short ? 8 : 252);
        for (unsigned i = 0; i < size; ++i) {
            frame.push_back(static_cast<std::byte>(drawn(2) == 0 ? drawn(3) : drawn(255)));
        }
        for (std::size_t i = 2; code == 8 and i < std::min<std::size_t>(frame.size(), 4); ++i) {
            frame[i] = std::byte{0}; // its other sub-functions change what it counts
        }
        if (code == 0x2B and frame.size() > 2) {
            frame[2] = std::byte{0x0E}; // another may write: 0D, of CANopen
        }
        return framed(frame);
    }

    line_bytes noise()
    {
        line_bytes bytes(1 + drawn(299));
        std::ranges::generate(bytes, [this] { return static_cast<std::byte>(drawn(255)); });
        return bytes;
    }

    frame_list every_code() const
    {
        frame_list all;
        for (unsigned code = 0; code <= 0xFF; ++code) {
            if (code != 8 and code != 0x0B and code != 0x0C) {
                all.push_back(framed({unit(), static_cast<std::byte>(code)}));
            }
        }
        return all;
    }

    frame_list overlong() const
    {
        frame_list all;
        for (std::size_t const size : {297U, 997U}) {
            line_bytes frame{unit(), std::byte{0x63}};
            frame.resize(size + 2, std::byte{0x5A});
            all.push_back(framed(frame));
        }
        return all;
    }

    frame_list cut_reads() const
    {
        frame_list all;
        line_bytes const read = plain_read(unit_.where());
        for (std::size_t size = 1; size < read.size(); ++size) {
            all.emplace_back(read.begin(), read.begin() + static_cast<std::ptrdiff_t>(size));
        }
        return all;
    }

    /// Whether a plain read is answered at the first time.
    bool is_alive()
    {
        unit_.line().wait_for_quiet(line_time{60'000});
        line_bytes const read = plain_read(unit_.where());
        return is_allowed("OK1", unit_.line().ask(read).bytes, read, {}, unit_.where());
    }

    /// Where the unit comes back by itself, or by somebody's hand.
    bool comes_back()
    {
        for (unsigned i = 0; i < 5 and noted_signal() == 0; ++i) {
            if (unit_.establish(clause_state::known)) {
                return true;
            }
        }
        return false;
    }

    void say(std::span<line_bytes const> frames)
    {
        for (line_bytes const& each : frames) {
            static_cast<void>(unit_.line().ask({sent_piece{.bytes = each}}, unit_.usual_wait()));
        }
    }

    bool breaks(std::span<line_bytes const> frames)
    {
        say(frames);
        if (is_alive()) {
            return false;
        }
        is_lost_ = not comes_back();
        return true;
    }

    /// The shortest run of these behind which the unit is deaf; then the shortest frame.
    judgement broken_by(frame_list frames)
    {
        std::string const tail = "; --seed and --only " + std::string{which_.id} + " send the same";
        if (not comes_back()) {
            return {verdict::fails,
                    "the unit does not answer any more behind " + std::to_string(frames.size()) +
                        " frames, the last of them " + shown(frames.back()) + tail,
                    {}};
        }
        while (frames.size() > 1 and not is_lost_ and noted_signal() == 0) {
            auto const middle = frames.begin() + static_cast<std::ptrdiff_t>(frames.size() / 2);
            frame_list const first{frames.begin(), middle}, second{middle, frames.end()};
            if (breaks(first)) {
                frames = first;
            } else if (not is_lost_ and breaks(second)) {
                frames = second;
            } else {
                break; // it takes frames of both halves, or was chance
            }
        }
        if (frames.size() == 1 and not is_lost_) {
            shorten(frames.front());
        }
        return {verdict::fails,
                (frames.size() == 1 ? "behind " + shown(frames.front())
                                    : "behind " + std::to_string(frames.size()) + " frames, the last of them " +
                                          shown(frames.back())) +
                    " a plain read is not answered" + (is_lost_ ? ", and the unit does not come back" : "") + tail,
                {}};
    }

    /// Takes bytes out as long as the unit is deaf behind what is left.
    void shorten(line_bytes& frame)
    {
        bool const had_right_crc = has_right_crc(frame);
        std::size_t const kept_tail = had_right_crc ? 2 : 0, head = had_right_crc ? 2 : 0;
        for (std::size_t part = (frame.size() - kept_tail - head) / 2; part > 0; part /= 2) {
            for (std::size_t at = head; at + part + kept_tail <= frame.size();) {
                line_bytes shorter{frame.begin(), frame.end() - static_cast<std::ptrdiff_t>(kept_tail)};
                auto const from = shorter.begin() + static_cast<std::ptrdiff_t>(at);
                shorter.erase(from, from + static_cast<std::ptrdiff_t>(part));
                shorter = had_right_crc ? framed(shorter) : shorter;
                frame_list const one{shorter};
                bool const still = not shorter.empty() and breaks(one);
                if (is_lost_ or noted_signal() != 0) {
                    return;
                }
                (still ? static_cast<void>(frame = shorter) : static_cast<void>(at += part));
            }
        }
    }

    /// Whoever looks for frames in it finds none that changes something, of whatever unit.
    template <typename Make> static line_bytes harmless(Make const& make)
    {
        line_bytes bytes = make();
        while (not changing_frame_in(bytes, functions_within::public_ones, 0).empty()) {
            bytes = make();
        }
        return bytes;
    }

    template <typename Make> judgement for_a_time(Make make, bool may_answer)
    {
        auto const end = std::chrono::steady_clock::now() + time_;
        std::size_t count = 0;
        while (std::chrono::steady_clock::now() < end and noted_signal() == 0) {
            frame_list frames;
            for (std::size_t i = 0; i < frames_to_a_read; ++i) {
                frames.push_back(harmless(make));
                line_bytes const came =
                    unit_.line().ask({sent_piece{.bytes = frames.back()}}, unit_.usual_wait()).bytes;
                ++count;
                if (std::string const wrong = flaw_of(came, frames.back(), may_answer); not wrong.empty()) {
                    return {verdict::fails, wrong, {}};
                }
                static_cast<void>(unit_.line().take_passed()); // a minute is some megabytes
            }
            if (not is_alive()) {
                return broken_by(frames);
            }
        }
        return {verdict::holds, std::to_string(count) + " frames", {}};
    }

    /// What is neither silence nor an answer in its form; empty where nothing is.
    std::string flaw_of(line_bytes const& came, line_bytes const& asked, bool may_answer) const
    {
        if (came.empty()) {
            return {};
        }
        bool const is_formed =
            has_right_crc(came) and came[0] == unit() and came.size() == stated_size(came, asked).value_or(came.size());
        return may_answer and is_formed ? std::string{} : shown(came) + " came to " + shown(asked);
    }

    judgement each_alone(frame_list const& frames)
    {
        for (line_bytes const& each : frames) {
            line_answer const answer = unit_.line().ask({sent_piece{.bytes = each}}, unit_.usual_wait());
            bool const may_answer = each.size() >= 4 and each[1] < std::byte{0x80};
            if (std::string const wrong = flaw_of(answer.bytes, each, may_answer); not wrong.empty()) {
                return {verdict::fails, wrong, {}};
            }
            if (not is_alive()) {
                return broken_by({each});
            }
            if (noted_signal() != 0) {
                break;
            }
        }
        return {};
    }

    /// Requests and answers of others without any silence for three seconds.
    judgement babble()
    {
        line_bytes const once = bytes_of(pieces_of("V 03 R 00 01 CRC ; V 03 02 12 34 CRC", unit_.where()));
        line_bytes all;
        std::size_t const by_wire = 3'000'000U / std::max(unit_.line().wire().characters(1).microseconds, 1U);
        while (all.size() < std::min<std::size_t>(by_wire, 30'000)) {
            all.insert(all.end(), once.begin(), once.end());
        }
        line_bytes const came = unit_.line().ask({sent_piece{.bytes = all}}, unit_.usual_wait()).bytes;
        if (not came.empty()) {
            return {verdict::fails, shown(came) + " came while others talked", {}};
        }
        return is_alive() ? judgement{} : judgement{verdict::fails, "a plain read behind it is not answered", {}};
    }

    checked_unit& unit_;
    clause const& which_;
    std::chrono::seconds time_;
    std::mt19937 random_;
    bool is_lost_{false};
};

} // namespace

judgement hostile_judged(checked_unit& unit, clause const& which, std::chrono::seconds time, std::uint32_t seed)
{
    return hostile_line{unit, which, time, seed}.run();
}

} // namespace tool
