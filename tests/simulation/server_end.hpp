// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One of the library's servers and the loop around it, which comes late at times, and whether the server
// takes, does and answers what it should.
#pragma once

#include <algorithm>
#include <vector>

#include <rtuwire/server/server.hpp>
#include <rtuwire/sim/line/line_faults.hpp>

#include "records.hpp"

namespace rtuwire::simulation {

using namespace detail;

/// What a server's registers tell: the transmission that it answers.
struct telling_registers {
    std::uint32_t transmission{0};
    unsigned writes{0};
    std::uint16_t write_start{0};
    frame written{};

    static errc check_read(std::uint16_t, std::size_t) { return errc::none; }
    static errc check_write(std::uint16_t, register_view) { return errc::none; }
    errc read(std::uint16_t, std::size_t count, byte_writer& out) const
    {
        for (std::size_t i = 0; i < count; ++i) {
            out.u16(word_of(transmission, i));
        }
        return errc::none;
    }
    errc write(std::uint16_t start, register_view values)
    {
        ++writes;
        write_start = start;
        written = {};
        for (std::size_t i = 0; i < values.size(); ++i) {
            written.word(values[i]);
        }
        return errc::none;
    }

    /// Whether a request asks for just the writes that were done.
    bool were_asked_by(frame const& request) const
    {
        unsigned const function = request[1];
        if (function != 6 and function != 16 and function != 23) {
            return writes == 0;
        }
        std::size_t const values_at = function == 6 ? 4 : function == 16 ? 7 : 11;
        return writes == 1 and write_start == request.word_at(function == 23 ? 6 : 2) and
               same(written.view(), request.view().subspan(values_at, request.size() - values_at - 2));
    }
};

/// A server on the line.
class server_end {
public:
    /// What its loop does wrong, in a million.
    struct chances {
        std::uint32_t late{0};
        std::uint32_t sent_missed{0};
    };

    server_end(std::uint8_t unit, line_timing const& timing, line_times const& times, moment frame_end,
               bool is_late_in_lumps, records& all)
        : unit_{unit}, engine_{*unit_id::checked(unit), timing}, times_{times}, frame_end_{frame_end},
          is_late_in_lumps_{is_late_in_lumps}, all_{all}
    {}

    void start(instant now) { engine_.advance(now); }

    /// Whether it still does, or has to be forgiven, something.
    bool is_busy(moment now) const { return busy_until_ > now or excused_until_ > now; }
    bool is_sending(moment at) const { return sending_until_ > at; }

    /// When its loop has something to do.
    template <typename FromClock> moment next(moment now, FromClock from_clock) const
    {
        if (busy_until_ > now) {
            return std::min(sent_at_, busy_until_);
        }
        deadline const own = engine_.poll_deadline();
        return std::min(sent_at_, own ? std::max(from_clock(*own), now + 1) : never);
    }

    /// A character that it misses.
    void misses()
    {
        is_confused_ = true;
        is_intact_ = false;
    }

    /// A character that it hears.
    void hears(passing const& by, character const& value, bool is_request, chances const& with,
               detail::random_source& random_source, moment now, instant clock)
    {
        bool const is_last = by.next + 1 == by.content.size();
        moment const silent_since = std::max(last_heard_, excused_until_);
        if (by.next == 0 and silent_since < now and now - silent_since > frame_end_ + times_.characters(2)) {
            is_confused_ = false;
        }
        last_heard_ = now;
        // Function 08 has no length: on a host what follows it within 50 ms is one with it. So is what
        // answers another request than the one just before, if it heard that well.
        bool const is_in_order = is_request or by.origin.transmission == known_request_;
        if (not by.is_whole() or by.content[1] == 8 or not is_in_order) {
            is_confused_ = true;
        }
        if (is_last) {
            known_request_ = is_request and not is_confused_ ? by.origin.transmission : 0;
        }
        // A spoiled character may be the right one by chance.
        is_intact_ = (is_intact_ or by.next == 0) and not value.is_damaged and
                     static_cast<std::uint8_t>(value.value) == by.content[by.next];
        bool const is_for_it = by.content[0] == unit_ or by.content[0] == 0;
        std::uint32_t const request = is_last and is_request and is_for_it and is_intact_ ? by.origin.transmission : 0;
        bool const can_take = busy_until_ <= now and not was_asked_ and sending_until_ < now and excused_until_ < now;
        if (request != 0 and busy_until_ <= now and random_source.happens(with.late)) {
            busy_until_ = now + 1 + random_source.below(2'000'000);
            all_.events.note(now, "server is busy", unit_);
        }
        if (busy_until_ > now and is_late_in_lumps_) {
            waiting_.push_back({value, request});
            is_confused_ = true;
            return;
        }
        take({value, request}, clock);
        if (request != 0 and by.is_whole() and can_take and not is_confused_ and by.content[1] != 8 and
            taken_ != request) {
            all_.events.note(now, "server did not take", request);
            all_.accuse(fault::deaf, now);
        }
    }

    /// Its loop comes round; the frame that it sends then, empty where it sends none.
    byte_view pass(moment now, instant clock)
    {
        if (sent_at_ <= now) {
            engine_.sent(clock);
            sent_at_ = never;
        }
        if (busy_until_ > now) {
            return {};
        }
        if (excused_until_ == never and misses_it_at_ <= now) {
            excused_until_ = now;
        }
        for (waiting_byte const& each : waiting_) {
            take(each, clock);
            last_heard_ = now;
        }
        waiting_.clear();
        engine_.advance(clock);
        note_asked(0);
        serve(now, clock);
        byte_view const bytes = engine_.poll_transmit();
        if (not bytes.empty()) {
            check_response(bytes, now);
        }
        return bytes;
    }

    /// The transmission that it answers.
    std::uint32_t answers() const { return taken_; }

    void leaves(moment end, chances const& with, detail::random_source& random_source)
    {
        sending_until_ = sent_at_ = end;
        if (random_source.happens(with.sent_missed)) {
            sent_at_ = never;
            excused_until_ = never; // and then until a silence
            misses_it_at_ = end + 300'000;
            is_confused_ = true;
        }
    }

private:
    /// What lies in its receiver until its loop comes round.
    struct waiting_byte {
        character value{};
        std::uint32_t request{0}; ///< the request that ends here, whole, for this unit or everyone
    };

    void take(waiting_byte const& one, instant clock)
    {
        if (one.value.is_damaged) {
            engine_.receive_error(clock);
        } else {
            engine_.receive(byte_view{&one.value.value, 1}, clock);
        }
        bytes_since_taken_ += one.value.is_damaged ? 0U : 1U;
        note_asked(one.request);
    }

    void note_asked(std::uint32_t request)
    {
        ended_ = request != 0 ? request : ended_;
        if (not engine_.is_asked()) {
            was_asked_ = false;
        } else if (not was_asked_) {
            was_asked_ = true;
            taken_ = ended_;
            bytes_since_taken_ = 0;
        }
    }

    void serve(moment now, instant clock)
    {
        registers_.transmission = taken_;
        registers_.writes = 0;
        engine_.serve(registers_, clock);
        was_asked_ = false;
        frame const* const asked = request_taken();
        if (asked != nullptr and registers_.writes > 0 and not registers_.were_asked_by(*asked)) {
            all_.events.note(now, "server wrote", taken_, registers_.written.view());
            all_.accuse(fault::wrong_write, now);
        }
    }

    /// What it says is the response to what it took, after no more has come in.
    void check_response(byte_view bytes, moment now)
    {
        if (bytes_since_taken_ > 0) {
            all_.events.note(now, "server sends", taken_, bytes);
            all_.accuse(fault::stale_response, now);
        }
        frame const* const asked = request_taken();
        if (asked != nullptr and not same(bytes, response_to(*asked, taken_).view())) {
            all_.events.note(now, "server sends", taken_, bytes);
            all_.accuse(fault::wrong_response, now);
        }
    }

    /// The request that it took; null where that is too long ago.
    frame const* request_taken()
    {
        transmission const& of = all_.transmissions[taken_];
        inquiry const& asked = all_.inquiries[of.inquiry];
        return of.number == taken_ and asked.id == of.inquiry ? &asked.request : nullptr;
    }

    std::uint8_t unit_;
    server engine_;
    line_times const& times_;
    moment frame_end_;
    bool is_late_in_lumps_; ///< while it is busy nobody takes its bytes either
    records& all_;
    telling_registers registers_{};
    std::vector<waiting_byte> waiting_{};
    std::uint32_t ended_{0};         ///< the request that ended last, as far as it was handed over
    std::uint32_t taken_{0};         ///< the request that it took
    std::uint32_t known_request_{0}; ///< whose response may come next
    unsigned bytes_since_taken_{0};
    bool was_asked_{false};
    bool is_intact_{false};  ///< what came of this frame so far is what was sent
    bool is_confused_{true}; ///< may have lost track of the frames until a silence
    moment busy_until_{0};
    moment sent_at_{never};
    moment sending_until_{0};
    moment misses_it_at_{0};  ///< when a pass tells it that nobody will tell it
    moment excused_until_{0}; ///< from hearing: it was not told that its response has left
    moment last_heard_{0};
};

} // namespace rtuwire::simulation
