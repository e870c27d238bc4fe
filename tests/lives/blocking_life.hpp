// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A life of a blocking client: its port's reads and writes fail, and its program is stopped within its calls. A stop that
// was run has sent its word, and nobody waits for longer than a moment.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "lives/conversations.hpp"
#include "lives/judge.hpp"
#include "lives/receiver.hpp"
#include "lives/wire.hpp"

#include <rtuwire/client/blocking.hpp>

namespace rtuwire::lives {

using namespace detail;

/// What befalls a port during one run.
struct port_trouble {
    unsigned bad_reads{0};
    unsigned bad_writes{0};
    errc why{errc::device_failed}; ///< ... of them
    unsigned calls_to_stop{0};     ///< before the program is stopped; 0: it is not
    moment stop{0};                ///< for how long
    bool has_stale{false};         ///< a frame that lies in it
};

/// A host's port to one drive.
class failing_port {
public:
    failing_port(life_setting const& how, tally& counts, chronicle const& said)
        : how_{how}, said_{said}, receiver_{how, counts}, drive_{make_drive(how.drive[0], how.timing(), at())}
    {}

    port_trouble trouble{};

    /// The program may have been stopped before.
    instant now()
    {
        if (trouble.calls_to_stop != 0 and --trouble.calls_to_stop == 0) {
            pass(trouble.stop);
            say("the program was stopped for %.1f s", double(trouble.stop) / 1e6);
        }
        told_ = now_;
        return at();
    }
    result<void> write(byte_view bytes, instant until)
    {
        moment const limit = left(until);
        if (trouble.bad_writes != 0) {
            --trouble.bad_writes;
            ++failed_;
            pass(trouble.why == errc::transmit_stalled ? limit : 20);
            say("a write fails");
            return trouble.why;
        }
        pass(bytes.size() * 11'000'000ULL / how_.bits_per_second);
        auto const word = control_word_in(bytes, drive_->profile());
        stop_words_ += word and not enables(*word, drive_->profile()) ? 1U : 0U;
        said_.frame("->", bytes, "", nullptr);
        drive_->receive(bytes, at());
        return {};
    }
    /// As a port does that makes a deadline of the host first.
    result<byte_span> read(byte_span place, instant until)
    {
        moment const length = left(until);
        longest_wait_ = std::max(longest_wait_, length);
        moment const end = now_ + length;
        if (trouble.bad_reads != 0) {
            --trouble.bad_reads;
            pass(20);
            return errc::device_failed;
        }
        if (std::exchange(trouble.has_stale, false)) {
            constexpr std::array<std::byte, 3> stale{std::byte{3}, std::byte{0x83}, std::byte{2}};
            byte_writer{place}.bytes(stale);
            return place.first(stale.size());
        }
        for (;;) {
            pass(0);
            if (byte_view const frame = drive_->poll_transmit(); not frame.empty()) {
                said_.frame("  <-", frame, "", nullptr);
                std::vector<std::byte> const whole{frame.begin(), frame.end()};
                pass(frame.size() * 11'000'000ULL / how_.bits_per_second);
                drive_->sent(at());
                receiver_.take(0, drive_->status(), whole, now_);
            }
            if (now_ >= receiver_.due()) {
                auto const bytes = receiver::bytes_of(receiver_.give(now_));
                byte_writer{place}.bytes(bytes);
                return place.first(bytes.size());
            }
            if (now_ >= end) {
                return place.first(0);
            }
            pass(std::min<moment>({end - now_, receiver_.due() - now_, 1'000}));
        }
    }

    /// In steps that a drive's clock can tell.
    void pass(moment length)
    {
        constexpr moment longest_step = 500'000;
        for (moment const end = now_ + length;;) {
            now_ = std::min(end, now_ + longest_step);
            said_.now = now_;
            drive_->advance(at());
            if (now_ == end) {
                return;
            }
        }
    }

    template <typename... Args> void say(char const* format, Args... args) const { said_.say(format, args...); }
    far_drive& drive() { return *drive_; }
    moment time() const { return now_; }
    unsigned stop_words() const { return stop_words_; }
    unsigned failed() const { return failed_; }
    moment longest_wait() const { return longest_wait_; }

private:
    instant at() const { return instant{how_.start_count + static_cast<std::uint32_t>(now_)}; }
    /// Of a deadline that was named behind the last look at the clock.
    moment left(instant until) const
    {
        instant const told{how_.start_count + static_cast<std::uint32_t>(told_)};
        moment const end = reached(told, until) ? told_ : told_ + (until - told).microseconds;
        return end > now_ ? end - now_ : 0;
    }

    life_setting const& how_;
    chronicle said_;
    moment now_{0};
    moment told_{0};
    receiver receiver_;
    std::unique_ptr<far_drive> drive_;
    unsigned stop_words_{0}; ///< that were taken
    unsigned failed_{0};     ///< writes
    moment longest_wait_{0};
};

class blocking_life {
public:
    blocking_life(life_setting const& how, tally& counts, bool prints)
        : how_{how}, counts_{counts}, chance_{how.seed * 40'503U + 1U}, habits_{how.seed * 2'246'822'519U + 3U},
          port_{how_, counts, {prints}}, line_{port_, how.timing(), how.options}
    {}

    bool live()
    {
        for (unsigned i = 0; i < how_.moments and not wrong_; ++i) {
            port_.trouble = chance_.below(3) == 0 ? port_trouble{} : any_trouble();
            act();
            port_.trouble = {};
            // Until a unit that was lost may be asked again. What was not written may be on the line all the same: where a late
            // answer comes, it owes one for each of these (docs/engine-rules.md, 18 and 19).
            moment const of_each =
                moment{how_.options.response_timeout.microseconds} + how_.options.late_response.microseconds;
            moment const longest_pause = 40'000'000 + port_.failed() * of_each;
            if (port_.longest_wait() > longest_pause) {
                accuse(breach::waited_longer);
            }
            port_.pass(chance_.below(chance_.below(3) == 0 ? 12'000'000 : 500'000));
        }
        if (wrong_) {
            counts_.note(*wrong_);
        }
        return not wrong_;
    }

private:
    port_trouble any_trouble()
    {
        constexpr std::array<moment, 6> stops{300'000, 2'000'000, 36 * minute, 50 * minute, 71 * minute, 110 * minute};
        constexpr unsigned for_ever = 1'000'000'000;
        port_trouble made;
        made.why = chance_.below(2) == 0 ? errc::device_failed : errc::transmit_stalled;
        if (chance_.below(3) == 0) {
            counts_.note(event::port_reads_failed);
            made.bad_reads = chance_.below(2) == 0 ? for_ever : 1 + chance_.below(4);
        }
        if (chance_.below(3) == 0) {
            counts_.note(event::port_writes_failed);
            made.bad_writes = chance_.below(4) == 0 ? for_ever : 1 + chance_.below(3);
        }
        if (chance_.below(3) == 0) {
            counts_.note(event::program_stopped_in_a_call);
            made.calls_to_stop = 1 + chance_.below(chance_.below(2) == 0 ? 8 : 60);
            made.stop = stops[chance_.below(6)];
        }
        made.has_stale = chance_.below(4) == 0;
        port_.say("the port: %u reads and %u writes fail, stale %d, stopped in call %u", made.bad_reads,
                  made.bad_writes, int{made.has_stale}, made.calls_to_stop);
        return made;
    }

    void act()
    {
        with_device(how_.drive[0].called, [&]<typename Device>(Device) {
            station<Device> const drive = station_of<Device>(how_.drive[0]);
            switch (chance_.below(8)) {
            case 0:
            case 1: return stop_one<Device>();
            case 2: return run_stop(a::broadcast_stop<1>{any_broadcast(), drive}, a::broadcast_stop_options{}.limit);
            case 3: return run_stop(a::broadcast_freewheel<Device>(), {}); // which is written once
            case 4: {
                auto const none = line_.ask(drive.unit(), read_holding_registers{Device::layout.eta, 1});
                return port_.say("a read: %d", static_cast<int>(none.error()));
            }
            default: {
                counts_.note(event::started);
                auto const told =
                    line_.run(make_start<Device>(how_.drive[0], {60, chance_.below(2) == 0}, milliseconds(3'000)));
                return port_.say("a start: %d, error %d", static_cast<int>(told.kind), static_cast<int>(told.error));
            }
            }
        });
    }

    template <typename Device> void stop_one()
    {
        auto const how = static_cast<a::stop_by>(chance_.below(5));
        auto const begin = chance_.below(2) == 0 ? a::stop_begin::at_once : a::stop_begin::look_first;
        duration const limit = milliseconds(chance_.below(3) == 0 ? 300U + chance_.below(2'000) : 30'000U);
        port_.say("way %d, looks first %d", static_cast<int>(how), int{begin == a::stop_begin::look_first});
        run_stop(a::stop{station_of<Device>(how_.drive[0]), how, limit, begin}, limit);
    }

    /// A word was taken where the port took any. Behind writes that failed a stop ends by its `limit`, and words go to a lost
    /// unit for 2 s only: its own time-out ends the rest.
    template <typename Stop> void run_stop(Stop&& stop, duration limit)
    {
        run_once(stop, limit);
        while (not wrong_ and habits_.below(4) == 0) { // it begins anew
            counts_.note(event::used_again);
            port_.pass(habits_.below(12'000'000));
            run_once(stop, limit);
        }
    }

    template <typename Stop> void run_once(Stop& stop, duration limit)
    {
        counts_.note(event::run_stop);
        moment const begun = port_.time();
        unsigned const words = port_.stop_words(), failed = port_.failed();
        port_.say("a stop, limit %u ms", limit.microseconds / 1'000);
        auto const told = line_.run(stop);
        if constexpr (requires { told.kind; }) {
            port_.say("it has ended: %d, error %d", static_cast<int>(told.kind), static_cast<int>(told.error));
        }
        moment const end = begun + std::min(limit, stop_words_after_loss).microseconds;
        bool const may_end = port_.failed() != failed and port_.time() >= end;
        bool const runs = port_.drive().state() == cia402::state::operation_enabled;
        if (port_.stop_words() == words and runs and not may_end and port_.trouble.bad_writes == 0) {
            accuse(breach::stopped_late);
        }
    }

    a::broadcast_stop_options any_broadcast()
    {
        return {
            .freewheel = chance_.below(2) == 0, .cuts_short = chance_.below(4) == 0, .last_after = milliseconds(400)};
    }

    void accuse(breach wrong)
    {
        if (not wrong_) {
            wrong_ = wrong;
            port_.say("BREACH: %s", breach_names[static_cast<std::size_t>(wrong)]);
        }
    }

    static constexpr moment minute = 60'000'000;

    life_setting how_;
    tally& counts_;
    detail::random_source chance_;
    detail::random_source habits_; ///< of who runs a stop again
    failing_port port_;
    blocking_client<failing_port> line_;
    std::optional<breach> wrong_{};
};

} // namespace rtuwire::lives
