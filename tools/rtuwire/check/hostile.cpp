// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "check/hostile.hpp"

#include <algorithm>
#include <optional>
#include <random>
#include <span>
#include <utility>

#include "frame/hex_text.hpp"
#include "line/end_wish.hpp"
#include "motion/raw_effect.hpp"

namespace tool {

namespace {

using frame_list = std::vector<line_bytes>;

constexpr std::size_t frames_to_a_read = 100;
/// Of the time of each hundred frames, for those that are given all the time that the unit takes.
constexpr line_time patience{200'000};

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

    /// What a try found, and what was said meanwhile.
    struct trouble {
        bool is_deaf{false};
        std::string flaw{};         ///< an answer that may not come
        std::size_t silent_from{0}; ///< the first frame behind the last answer
        std::vector<passed_bytes> passed{};

        explicit operator bool() const { return is_deaf or not flaw.empty(); }
    };

    /// There are units that end a frame whose length they do not know by a long silence only, or wait before they refuse.
    void find_times()
    {
        probed_line& line = unit_.line();
        line_bytes const read = plain_read(unit_.where()), unknown = framed({unit(), std::byte{0x63}});
        line_time longest{0}, longest_refusal{0};
        for (unsigned i = 0; i < 10; ++i) {
            longest = std::max(longest, line.ask(read).took);
        }
        for (unsigned i = 0; i < 2; ++i) {
            line.wait_for_quiet(known_silence);
            longest_refusal = std::max(longest_refusal, line.ask(unknown).took);
        }
        line.wait_for_quiet(known_silence);
        haste_ = 2 * longest + line_time{2'000};
        usual_ = std::max({haste_, unit_.usual_wait(), 2 * longest_refusal + line_time{2'000}});
    }

    bool is_read_answered(line_time wait)
    {
        line_bytes const read = plain_read(unit_.where());
        return is_allowed("OK1", unit_.line().ask({sent_piece{.bytes = read}}, wait).bytes, read, {}, unit_.where());
    }

    /// Whether a plain read is answered at the first time.
    bool is_alive()
    {
        unit_.line().wait_for_quiet(known_silence);
        return is_read_answered(unit_.line().longest_wait());
    }

    /// Behind frames for which nobody waited: the first times may be the unit's, for the last of them.
    bool is_alive_behind_haste()
    {
        for (auto const end = std::chrono::steady_clock::now() + usual_; std::chrono::steady_clock::now() < end;) {
            unit_.line().wait_for_quiet(known_silence);
            if (is_read_answered(usual_)) {
                return true;
            }
        }
        return is_alive();
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

    /// Sends these, and asks for the plain read behind them.
    trouble behind(std::span<line_bytes const> frames, line_time wait)
    {
        trouble found;
        auto const is_there = [&] { return wait < usual_ ? is_alive_behind_haste() : is_alive(); };
        for (std::size_t i = 0; i < frames.size() and noted_signal() == 0; ++i) {
            std::vector<sent_piece> const piece{sent_piece{.bytes = frames[i]}};
            if (not unit_.feed_before(unit_.line().time_without_answer(piece, wait)) and not is_there()) {
                break;
            }
            line_bytes const came = unit_.line().ask(piece, wait).bytes;
            found.silent_from = came.empty() ? found.silent_from : i + 1;
            found.flaw = found.flaw.empty() ? flaw_of(came, frames[i]) : found.flaw;
        }
        found.is_deaf = not is_there() and noted_signal() == 0;
        found.passed = unit_.line().take_passed(); // a minute is some megabytes
        return found;
    }

    /// Whether the unit is deaf behind these; it has come back when this returns, or is lost.
    bool breaks(std::span<line_bytes const> frames, line_time wait)
    {
        trouble const found = behind(frames, wait);
        if (found.is_deaf) {
            evidence_ = found.passed;
            is_lost_ = not comes_back();
        }
        return found.is_deaf;
    }

    /// What to say of these, behind which there was trouble. Nothing of an answer that came in haste, to whatever frame, and to
    /// none of them when each was given its time.
    std::optional<judgement> explained(frame_list frames, line_time wait, trouble const& first)
    {
        if (not first.is_deaf and wait == usual_) {
            return judgement{verdict::fails, first.flaw, {}};
        }
        if (not first.is_deaf) {
            static_cast<void>(comes_back());
            trouble const again = behind(frames, usual_);
            return again ? explained(frames, usual_, again) : std::nullopt;
        }
        evidence_ = first.passed;
        is_lost_ = not comes_back();
        std::string silent;
        if (is_lost_) {
            // The last that it answered may have done it, and what came then.
            silent = first.silent_from < frames.size()
                         ? "; it answered nothing from " + shown(frames[first.silent_from]) + " on"
                         : std::string{};
            std::size_t const innocent = std::max<std::size_t>(first.silent_from, 1) - 1;
            frames.erase(frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(innocent));
        } else if (wait < usual_ and breaks(frames, usual_)) {
            wait = usual_; // what breaks it by itself is found sooner than what breaks it in a crowd
        }
        halve(frames, wait);
        if (frames.size() == 1 and not is_lost_) {
            shorten(frames.front(), wait);
        }
        return judgement{verdict::fails,
                         (frames.size() == 1
                              ? "behind " + shown(frames.front())
                              : "behind " + std::to_string(frames.size()) + " frames, the first of them " +
                                    shown(frames.front()) + ", the last " + shown(frames.back())) +
                             " a plain read is not answered" + (is_lost_ ? ", and the unit does not come back" : "") +
                             silent + "; --seed and --only " + std::string{which_.id} + " send the same",
                         std::move(evidence_)};
    }

    /// The shortest run of these behind which the unit is deaf.
    void halve(frame_list& frames, line_time wait)
    {
        while (frames.size() > 1 and not is_lost_ and noted_signal() == 0) {
            auto const middle = frames.begin() + static_cast<std::ptrdiff_t>(frames.size() / 2);
            frame_list const first{frames.begin(), middle}, second{middle, frames.end()};
            if (breaks(first, wait)) {
                frames = first;
            } else if (not is_lost_ and breaks(second, wait)) {
                frames = second;
            } else {
                return; // it takes frames of both halves, or was chance
            }
        }
    }

    /// Takes bytes out as long as the unit is deaf behind what is left.
    void shorten(line_bytes& frame, line_time wait)
    {
        bool const had_right_crc = has_right_crc(frame);
        // What says that it only reads stays: a sub-function of 08, the interface of 43.
        std::size_t const kept_tail = had_right_crc ? 2 : 0, head = not had_right_crc             ? 0
                                                                    : frame[1] == std::byte{8}    ? 4
                                                                    : frame[1] == std::byte{0x2B} ? 3
                                                                                                  : 2;
        if (frame.size() < head + kept_tail) {
            return;
        }
        for (std::size_t part = (frame.size() - kept_tail - head + 1) / 2; part > 0; part /= 2) {
            for (std::size_t at = head; at + part + kept_tail <= frame.size();) {
                line_bytes shorter{frame.begin(), frame.end() - static_cast<std::ptrdiff_t>(kept_tail)};
                auto const from = shorter.begin() + static_cast<std::ptrdiff_t>(at);
                shorter.erase(from, from + static_cast<std::ptrdiff_t>(part));
                shorter = had_right_crc ? framed(shorter) : shorter;
                bool const may_be_sent =
                    not shorter.empty() and changing_frame_in(shorter, functions_within::public_ones, 0).empty();
                bool const still = may_be_sent and breaks(std::span{&shorter, 1}, wait);
                (still ? static_cast<void>(frame = shorter) : static_cast<void>(at += part));
                if (is_lost_ or noted_signal() != 0) {
                    return;
                }
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

    /// Some of each hundred are given the time that the unit takes, as many as `patience` has room for: all, where it is prompt.
    /// The others follow each other as closely as a client may.
    template <typename Make> judgement for_a_time(Make make, bool may_answer)
    {
        may_answer_ = may_answer;
        find_times();
        auto const end = std::chrono::steady_clock::now() + time_;
        std::size_t count = 0, awaited = 0;
        line_time saved{0};
        while (std::chrono::steady_clock::now() < end and noted_signal() == 0) {
            frame_list frames(frames_to_a_read);
            std::ranges::generate(frames, [&] { return harmless(make); });
            saved += patience;
            std::size_t const first = std::min<std::size_t>(static_cast<std::size_t>(saved / usual_), frames.size());
            saved -= usual_ * static_cast<std::int64_t>(first);
            saved = std::min(saved, usual_);
            count += frames.size();
            awaited += first;
            auto const middle = frames.begin() + static_cast<std::ptrdiff_t>(first);
            for (auto const& [part, wait] : {std::pair{frame_list{frames.begin(), middle}, usual_},
                                             std::pair{frame_list{middle, frames.end()}, haste_}}) {
                if (part.empty() or noted_signal() != 0) {
                    continue;
                }
                if (trouble const found = behind(part, wait)) {
                    if (auto why = explained(part, wait, found)) {
                        return *std::move(why);
                    }
                }
            }
        }
        return {verdict::holds,
                std::to_string(count) + " frames, of which " + std::to_string(awaited) + " were given " +
                    std::to_string(usual_.count() / 1'000) + " ms each, and the others " +
                    std::to_string(haste_.count() / 1'000) + " ms",
                {}};
    }

    /// What is neither silence nor an answer in its form; empty where nothing is.
    std::string flaw_of(line_bytes const& came, line_bytes const& asked) const
    {
        if (came.empty()) {
            return {};
        }
        bool const is_formed =
            has_right_crc(came) and came[0] == unit() and came.size() == stated_size(came, asked).value_or(came.size());
        return may_answer_ and is_formed ? std::string{} : shown(came) + " came to " + shown(asked);
    }

    judgement each_alone(frame_list const& frames)
    {
        usual_ = unit_.usual_wait();
        for (line_bytes const& each : frames) {
            may_answer_ = each.size() >= 4 and each[1] < std::byte{0x80};
            if (trouble const found = behind(std::span{&each, 1}, usual_)) {
                return explained({each}, usual_, found).value_or(judgement{});
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
    bool may_answer_{false};
    bool is_lost_{false};
    line_time usual_{0};                   ///< that the unit takes at most for a frame, whatever it is
    line_time haste_{0};                   ///< that it takes for a plain read
    std::vector<passed_bytes> evidence_{}; ///< of the last time that it was deaf
};

} // namespace

judgement hostile_judged(checked_unit& unit, clause const& which, std::chrono::seconds time, std::uint32_t seed)
{
    return hostile_line{unit, which, time, seed}.run();
}

} // namespace tool
