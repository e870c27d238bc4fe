// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line for the tests of the client's defects: the units are what the test says they are, time is 64 bits wide,
// and everything that was sent is kept with its times. It shares no rule of time with the client.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include <rtuwire/client/client.hpp>
#include <rtuwire/core/crc16.hpp>

namespace rtuwire::test {

using namespace detail;

using frame_bytes = std::vector<std::byte>;

/// A frame: these bytes and their CRC.
inline frame_bytes framed(std::vector<unsigned> const& content)
{
    frame_bytes frame;
    for (unsigned const each : content) {
        frame.push_back(static_cast<std::byte>(each));
    }
    unsigned const check = crc16(frame);
    frame.push_back(static_cast<std::byte>(check & 0xFFU));
    frame.push_back(static_cast<std::byte>(check >> 8U));
    return frame;
}

inline unsigned at(frame_bytes const& frame, std::size_t place) { return static_cast<unsigned>(frame.at(place)); }

inline unsigned word_at(frame_bytes const& frame, std::size_t place)
{
    return at(frame, place) * 256U + at(frame, place + 1);
}

/// Reads registers by function 03.
inline frame_bytes read_of(unsigned unit, unsigned address, unsigned count = 1)
{
    return framed({unit, 3, address >> 8U, address & 0xFFU, 0, count});
}

/// Writes a register by function 06.
inline frame_bytes write_of(unsigned unit, unsigned address, unsigned value)
{
    return framed({unit, 6, address >> 8U, address & 0xFFU, value >> 8U, value & 0xFFU});
}

/// What an obedient unit says to a request of functions 03, 06, 16, 22 or 23. Each register holds its address.
inline frame_bytes response_to(frame_bytes const& asked)
{
    std::vector<unsigned> said{at(asked, 0), at(asked, 1)};
    bool const reads = said[1] == 3 or said[1] == 23;
    for (unsigned i = 2; not reads and i < (said[1] == 22 ? 8U : 6U); ++i) {
        said.push_back(at(asked, i));
    }
    if (reads) {
        said.push_back(2 * word_at(asked, 4));
        for (unsigned i = 0; i < word_at(asked, 4); ++i) {
            unsigned const value = word_at(asked, 2) + i;
            said.push_back(value >> 8U);
            said.push_back(value & 0xFFU);
        }
    }
    return framed(said);
}

/// A conversation of any number of requests, made one by one.
struct series : asker {
    std::function<frame_bytes(unsigned)> make;
    unsigned most{0xFFFF'FFFF};
    std::function<void(unsigned, result<response> const&)> took{};
    unsigned number{0};
    unsigned answered{0};
    errc last{errc::none};
    frame_bytes frame{};

    explicit series(std::function<frame_bytes(unsigned)> maker, unsigned count = 0xFFFF'FFFF)
        : make{std::move(maker)}, most{count}
    {}

    std::optional<request_frame> next()
    {
        if (settled()) {
            return std::nullopt;
        }
        frame = make(number);
        return request_frame{frame};
    }
    void accept(result<response> const& outcome)
    {
        last = outcome.error();
        answered += outcome ? 1U : 0U;
        if (took) {
            took(number, outcome);
        }
        ++number;
    }
    bool settled() const { return number >= most; }
};

/// One frame that left: its first bit at `begin`, its last stop bit at `end`.
struct departure {
    std::uint64_t begin;
    std::uint64_t end;
    frame_bytes frame;
};

/// The line. `Link` is a client or a bus.
template <typename Link> class scripted_line {
public:
    Link link;
    /// What happens when the last stop bit of a frame has left.
    std::function<void(frame_bytes const&)> heard{};
    /// The bytes of the client in their order, as a transmitter reads them one by one at their times.
    std::vector<departure> departures{};
    /// The number that came with what was received last.
    int last_tag{-1};
    /// Whether the transmitter reports the end of each frame.
    bool reports{true};
    /// Frames handed out before the one before them had left.
    unsigned overtaken{0};
    /// Bytes that changed between `poll_transmit` and their time on the line.
    unsigned changed{0};
    /// A time at which the program wakes up by itself.
    std::uint64_t alarm{0};
    unsigned passes{0};
    /// Passes that a deadline asked for at once, although nothing was sent or received in the pass before.
    unsigned restless{0};
    /// How many of them came in a row, at most.
    unsigned spinning{0};
    /// How many in a row end a run.
    unsigned spinning_limit{1'000'000};

    explicit scripted_line(Link const& made, line_timing const& timing) : link{made}, timing_{timing}
    {
        link.advance(now());
        time_ += 1'000'000;
        link.advance(now());
    }

    std::uint64_t time() const { return time_; }
    instant now() const { return instant{static_cast<std::uint32_t>(time_)}; }
    std::uint64_t length_of(std::size_t bytes) const { return timing_.characters(bytes).microseconds; }

    /// Bytes that have arrived whole at this time; `tag` then tells whose they were. None: a byte arrived damaged.
    void arrive(std::uint64_t when, frame_bytes const& bytes, int tag = -1)
    {
        auto const place =
            std::find_if(arrivals_.begin(), arrivals_.end(), [&](arrival const& each) { return each.when > when; });
        arrivals_.insert(place, {when, bytes, tag});
    }
    /// Bytes whose first one begins this many microseconds from here.
    void say(std::uint64_t after, frame_bytes const& bytes, int tag = -1)
    {
        arrive(time_ + after + length_of(bytes.size()), bytes, tag);
    }

    /// The program is stopped for so many microseconds: nobody makes a pass, whatever the client says.
    void stop(std::uint64_t length) { time_ += length; }

    /// Passes for so many microseconds, sleeping as long as the client says.
    template <typename Converse> void run(std::uint64_t length, Converse converse)
    {
        std::uint64_t const end = time_ + length;
        while (pass(converse, end)) {
        }
    }

    /// One pass, and the sleep behind it. Whether it is before `end`.
    template <typename Converse> bool pass(Converse converse, std::uint64_t end)
    {
        bool has_changed = transmit_until_now();
        while (not arrivals_.empty() and arrivals_.front().when <= time_) {
            arrival const each = arrivals_.front();
            arrivals_.erase(arrivals_.begin());
            if (each.bytes.empty()) {
                link.receive_error(now());
            } else {
                link.receive(each.bytes, now());
            }
            last_tag = each.tag;
            has_changed = true;
        }
        link.advance(now());
        converse(now());
        ++passes;
        if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
            has_changed = true;
            overtaken += is_sending() ? 1U : 0U;
            memory_ = frame;
            read_ = 0;
            departures.push_back({time_, time_ + length_of(frame.size()), frame_bytes(frame.begin(), frame.end())});
        }
        return sleep(end, has_changed);
    }

private:
    struct arrival {
        std::uint64_t when;
        frame_bytes bytes;
        int tag;
    };

    bool is_sending() const { return read_ < memory_.size(); }

    /// Each byte is read when its start bit begins, as from a DMA's memory.
    bool transmit_until_now()
    {
        bool has_changed = false;
        while (is_sending() and byte_time() <= time_) {
            changed += memory_[read_] != departures.back().frame[read_] ? 1U : 0U;
            ++read_;
            has_changed = true;
        }
        if (is_reported_ < departures.size() and not is_sending() and departures.back().end <= time_) {
            is_reported_ = departures.size();
            has_changed = true;
            if (reports) {
                link.sent(now());
            }
            if (heard) {
                heard(frame_bytes{departures.back().frame});
            }
        }
        return has_changed;
    }
    std::uint64_t byte_time() const { return departures.back().begin + length_of(read_); }

    bool sleep(std::uint64_t end, bool has_changed)
    {
        std::uint64_t next = end;
        deadline const own = link.poll_deadline();
        std::int64_t const left = own ? static_cast<std::int32_t>(own->microseconds - now().microseconds) : 0;
        bool const is_at_once = own and left <= 0;
        bool const is_restless = is_at_once and not has_changed;
        restless += is_restless ? 1U : 0U;
        in_a_row_ = is_restless ? in_a_row_ + 1 : 0;
        spinning = std::max(spinning, in_a_row_);
        if (own) {
            next = std::min(next, time_ + static_cast<std::uint64_t>(std::max<std::int64_t>(left, 1)));
        }
        if (is_sending()) {
            next = std::min(next, std::max(byte_time(), time_ + 1));
        } else if (is_reported_ < departures.size()) {
            next = std::min(next, std::max(departures.back().end, time_ + 1));
        }
        if (alarm > time_) {
            next = std::min(next, alarm);
        }
        if (not arrivals_.empty()) {
            next = std::min(next, std::max(arrivals_.front().when, time_));
        }
        time_ = next;
        return time_ < end and spinning < spinning_limit;
    }

    line_timing timing_;
    std::uint64_t time_{0xFFFF'FFFFU - 5'000'000U};
    std::vector<arrival> arrivals_{};
    byte_view memory_{};
    std::size_t read_{0};
    std::size_t is_reported_{0};
    unsigned in_a_row_{0};
};

inline constexpr line_timing office_line{19'200, character_format::even_8_1};

} // namespace rtuwire::test
