// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The request that a client's transaction is for: whom it asks, how long it and its longest response are on the line; how often
// it was sent, and whether it may be sent once more. Knows no phase.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/client/needs.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/functions.hpp>
#include <rtuwire/wire/limits.hpp>
#include <rtuwire/wire/response.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// The last request, to these functions. Its bytes stand in front of the response's, in the memory of the frame.
template <typename Functions> class kept_request {
public:
    /// Copies a request to the front of the memory; the framer receives behind it. Errors: those of `check_request`;
    /// `buffer_too_small` where the request and its response do not fit together.
    template <typename Cutter>
    [[gnu::always_inline]] constexpr errc keep(byte_view frame, Cutter& framer, typename Cutter::memory& in) noexcept
    {
        if (errc const wrong = check_request<Functions>(frame); wrong != errc::none) {
            return wrong;
        }
        constexpr std::size_t room = sizeof(in.bytes);
        if (room < max_adu_size and frame.size() > room) {
            return errc::buffer_too_small;
        }
        framer.receive_behind(frame.size());
        longest_ = longest_response<Functions>(frame);
        if (longest_.size() > framer.room()) {
            return errc::buffer_too_small;
        }
        std::size_t i = frame.size();
        do { // backwards: 8 bytes less
            --i;
            in.bytes[i] = frame[i];
        } while (i != 0);
        size_ = static_cast<std::uint16_t>(frame.size());
        unit_ = to_u8(frame[0]);
        return errc::none;
    }

    /// Its unit; 0 for a broadcast.
    [[nodiscard]] constexpr std::uint8_t unit() const noexcept { return unit_; }

    template <typename Memory> [[nodiscard]] constexpr byte_view bytes(Memory const& in) const noexcept
    {
        return {in.bytes.data(), size_};
    }

    /// How long it takes to leave.
    [[nodiscard]] constexpr duration time_to_send(line_timing const& line) const noexcept
    {
        return line.characters(size_);
    }

    /// How long its longest response takes on the line; with the silence that ends it, where only silence does.
    [[nodiscard]] constexpr duration time_to_respond(line_timing const& line) const noexcept
    {
        duration const silence = longest_.is_final() ? duration{} : line.frame_end();
        return line.with_characters(silence, longest_.size());
    }

private:
    std::uint16_t size_{0};
    length_hint longest_{}; ///< of its responses; stored, which saves 57 instructions of a read
    std::uint8_t unit_{0};
};

/// The attempts at one request.
class retry_state {
public:
    /// A new request; one that may not be repeated gets a single attempt.
    constexpr void begin(retry_policy const& with, bool may_repeat) noexcept
    {
        retries_ = may_repeat ? with.retries : std::uint8_t{0};
        busy_retries_ = may_repeat ? with.busy_retries : std::uint8_t{0};
        failures_ = 0;
        pauses_ = 0;
        unanswered_ = 0;
        response_timeout_ = with.response_timeout;
        pause_ = with.pause;
        busy_pause_ = with.busy_pause < with.pause ? with.pause : with.busy_pause;
    }

    /// Takes one repetition after silence or damage; returns false where none is left.
    constexpr bool take_retry() noexcept
    {
        bool const is_left = failures_ < retries_;
        failures_ = static_cast<std::uint8_t>(failures_ + (is_left ? 1 : 0));
        return is_left;
    }

    /// Allows no further repetition.
    constexpr void end_retries() noexcept
    {
        retries_ = 0;
        busy_retries_ = 0;
    }

    /// Whether the unit asks for time, and a pause is left.
    [[nodiscard, gnu::always_inline]] constexpr bool may_pause(errc response) const noexcept
    {
        bool const asks = response == errc::acknowledge or response == errc::server_device_busy;
        return asks and pauses_ < busy_retries_;
    }

    /// Takes one repetition after a pause, and returns the pause. The next one is twice as long.
    constexpr duration take_pause() noexcept
    {
        constexpr std::uint8_t most_doublings = 6;
        duration const pause = busy_pause_;
        if (pauses_ < most_doublings and pause < duration{longest_duration.microseconds / 2}) {
            busy_pause_.microseconds *= 2;
        }
        ++pauses_;
        return pause;
    }

    /// The request has left once more, which takes `sending` on the line. Its unit answers it at most `each` after it could
    /// begin: from here on, or when it has answered the requests before.
    [[gnu::always_inline]] constexpr void note_sent(instant at, duration sending, duration each) noexcept
    {
        if (unanswered_ == 0) {
            first_sent_ = at;
            owed_until_ = at;
            longest_ = duration{};
        }
        owed_until_ = at + ((owed_until(at) - at) + each);
        // The two sums of 35 minutes fit.
        longest_ = longest_ + duration{response_timeout_.microseconds + sending.microseconds + each.microseconds};
        ++unanswered_;
    }

    /// Lets time pass: what was owed by then is not owed later.
    constexpr void advance(instant now, instant at) noexcept { keep_over(owed_until_, now, at); }

    /// Until when responses may come, where none has come. Never before `now`, so that it can be compared with other
    /// times that lie ahead, nor longer than for all sendings together, whatever the clock shows.
    [[nodiscard]] constexpr instant owed_until(instant now) const noexcept
    {
        return reached(now, owed_until_) ? now : now + shorter(owed_until_ - now, longest_);
    }

    /// A response to one of the sendings has come, whole or damaged.
    constexpr void note_response() noexcept { --unanswered_; }

    /// The unit's pause, and how long the responses to all other sendings may take, once one has come at `now`: each as long
    /// as the first may have taken, plus `late`. A program that was stopped meanwhile counts no longer than its request may take.
    [[nodiscard]] constexpr duration all_that_follow(instant now, duration late) const noexcept
    {
        duration const each = shorter(now - first_sent_, longest_) + late;
        duration length = pause_;
        for (unsigned i = 0; i < unanswered_; ++i) {
            length = length + each;
        }
        return length;
    }

    /// How many sendings have no response.
    [[nodiscard]] constexpr std::uint16_t unanswered() const noexcept { return unanswered_; }

    [[nodiscard]] constexpr bool is_first() const noexcept { return failures_ + pauses_ == 0; }

    [[nodiscard]] constexpr duration response_timeout() const noexcept { return response_timeout_; }

    /// What its unit gets behind a response, and before a repetition.
    [[nodiscard]] constexpr duration pause() const noexcept { return pause_; }

private:
    static constexpr duration shorter(duration one, duration other) noexcept { return one < other ? one : other; }

    std::uint8_t retries_{0};
    std::uint8_t busy_retries_{0};
    std::uint8_t failures_{0};
    std::uint8_t pauses_{0};
    duration response_timeout_{};
    duration busy_pause_{}; ///< the next one
    duration pause_{};
    instant first_sent_{0};
    instant owed_until_{0};
    duration longest_{};          ///< what the time limits leave from the first of the unanswered sendings on
    std::uint16_t unanswered_{0}; ///< at the end, so that no bytes are left before its holder's next member
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
