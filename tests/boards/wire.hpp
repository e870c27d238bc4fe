// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The line behind a board that is none: microseconds that somebody lets pass, a transmitter and a receiver of 11 bits a
// character, the pin of the driver, and who is at the other end. It shares no code with the library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

namespace stand_in {

/// What a receiver says of a byte. An overrun is one that is not there any more.
enum class arrival { good, parity, framing, noise, overrun };

/// The byte of a receiver that says nothing of damage.
inline std::uint8_t as_it_comes(std::uint8_t byte, arrival how)
{
    return how == arrival::good ? byte : static_cast<std::uint8_t>(byte ^ 0x10U);
}

/// Ends the program of a board, which never returns, where it waits and sends nothing.
struct time_is_over {};

class wire {
public:
    using time = std::uint64_t;
    static constexpr time character = 573; // at 19 200 bit/s

    [[nodiscard]] time now() const { return now_; }
    [[nodiscard]] std::uint32_t now_32() const { return static_cast<std::uint32_t>(now_); }

    // The board's side.
    void drive(bool is_on)
    {
        if (is_on_ and not is_on and shifting_) {
            ++let_go_early;
        }
        last_bit_ = is_on and not is_on_ ? 0 : last_bit_;
        is_on_ = is_on;
    }
    [[nodiscard]] bool is_driven() const { return is_on_; }
    void put(std::uint8_t byte)
    {
        leaving_.push_back(byte);
        start_next();
    }
    [[nodiscard]] std::size_t waiting() const { return leaving_.size(); }
    [[nodiscard]] bool is_idle() const { return leaving_.empty() and not shifting_; }
    std::function<void(std::uint8_t, arrival)> on_byte; ///< the receiver's
    std::function<void()> on_room;                      ///< the transmitter takes another byte
    std::function<void()> on_last_bit;

    // The other end's side.
    std::function<void(std::uint8_t)> heard;
    std::function<void()> on_time; ///< each quarter of a millisecond

    /// Each byte arrives a character after the one before it, the first `after` the last.
    void speak(std::vector<std::uint8_t> const& frame, time after, std::size_t bad_at = ~std::size_t{0},
               arrival how = arrival::good)
    {
        time at = now_ + after;
        for (std::size_t i = 0; i < frame.size(); ++i) {
            at += character;
            arriving_.push_back({at, frame[i], i == bad_at ? how : arrival::good});
        }
    }
    void fall_silent() { arriving_.clear(); }

    /// Lets time pass. Whatever happens on the line meanwhile happens at its time.
    void pass(time length)
    {
        time const end = now_ + length;
        while (step(end)) {
        }
        now_ = end;
        if (now_ >= over_at and not is_on_) {
            throw time_is_over{};
        }
    }
    /// Until something happened on the line, at most so long.
    void pass_to_event(time longest)
    {
        time const end = now_ + longest;
        if (not step(end)) {
            now_ = end;
        }
        if (now_ >= over_at and not is_on_) {
            throw time_is_over{};
        }
    }

    time over_at{~time{0}};
    unsigned let_go_early{0};  ///< the driver was switched off within a character
    unsigned sent_undriven{0}; ///< characters that left, or began to, without the driver
    unsigned collisions{0};    ///< characters that came in while the driver was on
    unsigned held_long{0};     ///< transmissions after which it stayed on for more than 2 characters

private:
    struct coming {
        time at;
        std::uint8_t byte;
        arrival how;
    };

    void start_next()
    {
        if (shifting_ or leaving_.empty()) {
            return;
        }
        shifting_ = true;
        ends_ = now_ + character;
        sent_undriven += is_on_ ? 0 : 1;
        byte_ = leaving_.front();
        leaving_.pop_front();
    }

    /// The next thing that happens before `end`.
    bool step(time end)
    {
        time const tick = now_ - now_ % 250 + 250;
        time next = tick;
        if (shifting_ and ends_ <= next) {
            next = ends_;
        }
        if (not arriving_.empty() and arriving_.front().at < next) {
            next = arriving_.front().at;
        }
        if (next > end) {
            return false;
        }
        now_ = next;
        if (shifting_ and ends_ == next) {
            end_character();
        } else if (not arriving_.empty() and arriving_.front().at == next) {
            coming const each = arriving_.front();
            arriving_.pop_front();
            collisions += is_on_ ? 1 : 0;
            on_byte(each.byte, each.how);
        } else {
            if (on_time) {
                on_time();
            }
            held_long += is_on_ and is_idle() and last_bit_ != 0 and now_ - last_bit_ > character * 2 ? 1U : 0U;
            return step(end); // nothing that an interrupt would tell
        }
        return true;
    }

    void end_character()
    {
        shifting_ = false;
        sent_undriven += is_on_ ? 0 : 1;
        last_bit_ = now_;
        std::uint8_t const byte = byte_;
        start_next();
        if (leaving_.empty() and on_room) {
            on_room();
        }
        if (heard) {
            heard(byte);
        }
        if (is_idle() and on_last_bit) {
            on_last_bit();
        }
    }

    time now_{0xFFF0'0000}; // 32 bits of microseconds wrap in a second
    time last_bit_{0};
    time ends_{0};
    bool is_on_{false};
    bool shifting_{false};
    std::uint8_t byte_{0};
    std::deque<std::uint8_t> leaving_{};
    std::deque<coming> arriving_{};
};

inline wire line;

} // namespace stand_in
