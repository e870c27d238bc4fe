// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A drive with a mains switch, at a cable that can be cut. An end of a simulated line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "any_drive.hpp"

namespace playground {

/// Borrows the drive, which must outlive it.
class cabled_drive {
public:
    explicit cabled_drive(any_drive& drive) noexcept : drive_{&drive} {}

    // As an end of the line.
    void receive(rtuwire::byte_view bytes, rtuwire::instant now) noexcept
    {
        if (hears()) {
            drive_->receive(bytes, now);
        }
    }
    void receive_error(rtuwire::instant now) noexcept
    {
        if (hears()) {
            drive_->receive_error(now);
        }
    }
    void sent(rtuwire::instant now) noexcept { drive_->sent(now); }
    void advance(rtuwire::instant now) noexcept
    {
        constexpr std::uint32_t most = 3'600'000'000; // the clock wraps a little later
        std::uint32_t const passed = (now - last_).microseconds;
        last_ = now;
        silence_.microseconds = passed < most - silence_.microseconds ? silence_.microseconds + passed : most;
        if (is_on_) {
            std::uint32_t const before = drive_->requests();
            drive_->advance(now);
            bool const is_heard = drive_->requests() != before;
            silence_ = is_heard ? rtuwire::duration{} : silence_;
            has_heard_ = has_heard_ or is_heard;
        }
    }
    rtuwire::byte_view poll_transmit() noexcept
    {
        rtuwire::byte_view const frame = is_on_ ? drive_->poll_transmit() : rtuwire::byte_view{};
        if (is_cut_from_ and not frame.empty()) {
            unheard_.assign(frame.begin(), frame.end());
        }
        return frame;
    }
    rtuwire::deadline poll_deadline() const noexcept { return is_on_ ? drive_->poll_deadline() : rtuwire::deadline{}; }

    /// Its mains. What was not saved in its EEPROM is lost when they go.
    void switch_mains(bool on, rtuwire::instant now) noexcept
    {
        if (on and not is_on_) {
            drive_->power_cycle(now);
        } else if (is_on_ and not drive_->poll_transmit().empty()) {
            drive_->sent(now);
        }
        is_on_ = on;
        has_heard_ = false;
    }
    [[nodiscard]] bool is_on() const noexcept { return is_on_; }

    /// The pair from the drive is cut at the line, `sim::line_faults`; this end only keeps what is lost there.
    void cut(bool towards, bool from) noexcept
    {
        is_cut_towards_ = towards;
        is_cut_from_ = from;
    }
    [[nodiscard]] bool hears() const noexcept { return is_on_ and not is_cut_towards_; }

    /// A response that it sent into a cut cable, once.
    [[nodiscard]] std::vector<std::byte> take_unheard() noexcept { return std::exchange(unheard_, {}); }

    /// For how long it has received no request, from the first one after power-up on; an hour at most.
    [[nodiscard]] bool has_heard() const noexcept { return has_heard_; }
    [[nodiscard]] rtuwire::duration silence() const noexcept { return silence_; }

private:
    any_drive* drive_;
    std::vector<std::byte> unheard_{};
    rtuwire::instant last_{0};
    rtuwire::duration silence_{};
    bool has_heard_{false};
    bool is_on_{false};
    bool is_cut_towards_{false};
    bool is_cut_from_{false};
};

} // namespace playground
