// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line on which exchanges follow each other at known times, and what may be damaged of it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "trace/listener/heard_list.hpp"
#include "trace/listener/made_exchange.hpp"

namespace listening {

/// A frame on the line, sent without gaps.
struct sent_frame {
    bytes frame;
    std::uint64_t end; ///< of its last byte, in microseconds
    heard_entry truth;
    bool is_damaged{false};
    std::size_t request_at{0}; ///< of a response: which frame is its request
};

class made_line {
public:
    explicit made_line(std::uint32_t seed, unsigned units = 30) : make_{seed}, units_{units} {}

    static rtuwire::line_timing timing() { return rtuwire::line_timing{19'200, rtuwire::character_format::even_8_1}; }

    /// An exchange of any kind, one in ten without a response.
    void add_any()
    {
        unsigned const kind = make_.below(20);
        add(kind == 0 ? make_.make_broadcast() : kind == 1 ? make_.make_unknown(unit()) : make_.make(unit()));
    }
    /// The same, but for functions that nobody knows.
    void add_with_rule() { add(make_.below(20) == 0 ? make_.make_broadcast() : make_.make(unit())); }
    /// A read of registers, as most exchanges are.
    void add_read()
    {
        unsigned const who = unit(); // one after the other: compilers take arguments in orders of their own
        unsigned const code = make_.below(3) == 0 ? 16 : 3;
        bool const is_refused = make_.below(50) == 0;
        add(make_.make(who, code, is_refused));
    }

    /// One byte in so many changes in one to eight bits.
    void damage_bytes(unsigned one_in)
    {
        for (sent_frame& each : sent_) {
            for (std::byte& byte : each.frame) {
                if (make_.below(one_in) == 0) {
                    byte ^= static_cast<std::byte>(1 + make_.below(255));
                    each.is_damaged = true;
                }
            }
        }
    }
    /// Some bytes between frames, as far from both as silence asks for.
    void add_noise()
    {
        for (std::size_t i = 10; i < sent_.size(); i += 17) {
            bytes noise;
            for (unsigned left = 1 + make_.below(5); left > 0; --left) {
                put(noise, make_.below(256));
            }
            if (sent_[i].end - sent_[i - 1].end > 40'000U + 573U * sent_[i].frame.size()) {
                noises_.push_back({noise, sent_[i - 1].end + 20'000, {}, true});
            }
        }
    }
    /// The listener joins in the middle of the first frame.
    void cut_front()
    {
        sent_[0].frame.erase(sent_[0].frame.begin(), sent_[0].frame.begin() + 2);
        sent_[0].is_damaged = true;
    }

    std::vector<sent_frame> all() const
    {
        std::vector<sent_frame> every = sent_;
        every.insert(every.end(), noises_.begin(), noises_.end());
        std::sort(every.begin(), every.end(), [](auto const& one, auto const& other) { return one.end < other.end; });
        return every;
    }

    /// What a listener should say of a line without damage.
    std::vector<heard_entry> truth() const
    {
        std::vector<heard_entry> found;
        for (sent_frame const& each : sent_) {
            found.push_back(each.truth);
        }
        return found;
    }
    /// The same of the exchanges of which nothing was damaged.
    std::vector<heard_entry> whole_truth() const
    {
        std::vector<heard_entry> found;
        for (sent_frame const& each : sent_) {
            bool const is_response = each.truth.role == rtuwire::frame_role::response;
            if (not each.is_damaged and not(is_response and sent_[each.request_at].is_damaged)) {
                found.push_back(each.truth);
            }
        }
        return found;
    }
    std::size_t unanswered() const { return unanswered_; }
    /// In microseconds.
    std::uint64_t length() const { return now_; }

private:
    unsigned unit() { return 1 + make_.below(units_); }

    void add(made_exchange const& made)
    {
        using rtuwire::frame_role;
        using rtuwire::frame_verdict;
        bool const is_silent = make_.below(10) == 0 and not made.response.empty();
        send(made.request, {frame_role::request, frame_verdict::good, made.request, {}});
        std::size_t const request_at = sent_.size() - 1;
        if (is_silent) {
            ++unanswered_;
            now_ += 1'100'000;
        } else if (not made.response.empty()) {
            send(made.response, {frame_role::response, frame_verdict::good, made.response, made.request});
            sent_.back().request_at = request_at;
        }
        now_ += make_.below(8) == 0 ? 60'000U : 0U;
    }
    /// After a silence of 4 to 24 ms.
    void send(bytes const& frame, heard_entry const& truth)
    {
        now_ += 4'000 + make_.below(20'000) + 573U * frame.size();
        sent_.push_back({frame, now_, truth});
    }

    exchange_maker make_;
    unsigned units_;
    std::vector<sent_frame> sent_{};
    std::vector<sent_frame> noises_{};
    std::uint64_t now_{1'000'000};
    std::size_t unanswered_{0};
};

/// Each byte as it ends.
inline heard_list hear_by_bytes(made_line const& line)
{
    heard_list heard;
    rtuwire::line_listener tap{made_line::timing()};
    auto const take = [&heard](rtuwire::heard_frame const& it) { heard.take(it); };
    auto const time = [](std::uint64_t at) { return rtuwire::instant{static_cast<std::uint32_t>(at)}; };
    std::uint64_t last = 0;
    for (sent_frame const& each : line.all()) {
        for (std::size_t i = 0; i < each.frame.size(); ++i) {
            std::uint64_t const at = each.end - 573U * (each.frame.size() - 1 - i);
            tap.advance(time(at - 573), take);
            tap.receive({&each.frame[i], 1}, time(at), take);
            last = at;
        }
    }
    tap.advance(time(last + 3'000'000), take);
    return heard;
}

/// All bytes of a time at its end, as a USB adapter hands them over.
inline heard_list hear_in_lumps(made_line const& line, rtuwire::duration lump)
{
    heard_list heard;
    rtuwire::line_listener tap{rtuwire::line_timing::host(19'200, rtuwire::character_format::even_8_1)};
    auto const take = [&heard](rtuwire::heard_frame const& it) { heard.take(it); };
    auto const time = [](std::uint64_t at) { return rtuwire::instant{static_cast<std::uint32_t>(at)}; };
    bytes waiting;
    std::uint64_t handed = 0;
    auto const hand_over = [&](std::uint64_t until) {
        if (not waiting.empty()) {
            tap.receive(waiting, time(until), take);
            waiting.clear();
        }
        tap.advance(time(until), take);
    };
    for (sent_frame const& each : line.all()) {
        for (std::size_t i = 0; i < each.frame.size(); ++i) {
            std::uint64_t const at = each.end - 573U * (each.frame.size() - 1 - i);
            std::uint64_t const end = (at / lump.microseconds + 1) * lump.microseconds;
            if (end != handed) {
                hand_over(handed);
                handed = end;
            }
            waiting.push_back(each.frame[i]);
        }
    }
    hand_over(handed);
    tap.advance(time(handed + 3'000'000), take);
    return heard;
}

} // namespace listening
