// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which conversation asked last, and which may ask next: in the order in which they come by, beginning behind
// the one that was served last. Knows conversations by the number that each holds; compares no addresses of
// theirs, so that one may be destroyed, moved, or made anew in the same place.
#pragma once

#include <cstdint>

#include <rtuwire/client/conversation.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Who a conversation is that comes by where somebody has asked or others wait.
enum class standing : std::uint8_t {
    waits,
    is_next, ///< waits, and its turn comes before that of all others that wait
    is_last, ///< asked last
};

/// The turns on one line.
class turns {
public:
    constexpr turns() noexcept = default;
    constexpr turns(turns const&) noexcept = default;

    /// A client that is set up anew in its place, for another speed, counts on: else a conversation that asked the
    /// one before would take another's outcome for its own.
    constexpr turns& operator=(turns const&) noexcept
    {
        number_ += asker::step;
        mark_ = 0;
        others_wait_ = false;
        is_missed_ = false;
        reserved_ = reservation::none;
        return *this;
    }

    /// A conversation asks, and has this line's next number; or who asked last gets another one: whoever was marked
    /// so far counts as not marked.
    [[gnu::noinline]] constexpr void renew(asker& who) noexcept
    {
        is_missed_ = false;
        number_ += asker::step;
        give(who, number_);
    }

    /// The same where who asked last is not at hand.
    constexpr void void_marks() noexcept
    {
        mark_ = static_cast<std::uint8_t>((mark_ + marks_step) & (asker::step - marks_step));
    }

    /// Whether it was this conversation that asked last.
    [[nodiscard]] constexpr bool is_own(asker const& who) const noexcept
    {
        return who.ticket_ == number_ and who.turns_ == this;
    }

    /// The same, also where it has given up what it asked. Inlined: 16 bytes less on a Cortex-M0+.
    [[nodiscard, gnu::always_inline]] constexpr bool is_last(asker const& who) const noexcept
    {
        return who.ticket_ - number_ <= asker::given_up and who.turns_ == this;
    }

    /// Whether what this conversation asked was dropped because it did not come by: another has asked since, or
    /// nothing is under way. Told once.
    constexpr bool was_dropped(asker& who, bool is_idle) const noexcept
    {
        bool const is_lost = who.turns_ == this and who.ticket_ % asker::step == 0 and
                             (is_idle or who.ticket_ != number_);
        if (is_lost) {
            who.forget();
        }
        return is_lost;
    }

    /// Others than the one that asked last wait for their turn.
    constexpr void note_waiting() noexcept { others_wait_ = true; }
    [[nodiscard]] constexpr bool others_wait() const noexcept { return others_wait_; }

    /// Somebody comes by who may have to wait. The next in turn is the first that comes by twice, beginning behind the
    /// one that asked, so that nobody is next who is gone in the next pass. It stays so while it comes by; where it
    /// does not, the first that comes by twice meanwhile is. A function of its own, which is smaller.
    [[gnu::noinline]] constexpr standing visit(asker& who) noexcept
    {
        if (is_last(who)) {
            return standing::is_last;
        }
        others_wait_ = true;
        standing place = standing::waits;
        if (who.ticket_ == mark() and who.turns_ == this) {
            void_marks();
            place = standing::is_next;
        }
        give(who, mark());
        return place;
    }

    /// The next in turn finds the one that asked missing. Whether it is for the second time: then the other one had
    /// its chance in between.
    constexpr bool misses_asker() noexcept
    {
        bool const is_second = is_missed_;
        is_missed_ = true;
        return is_second;
    }

    /// Somebody comes by who comes before all others, and may not ask yet: nobody else does before.
    constexpr void reserve(asker& who) noexcept
    {
        reserved_ = reservation::held;
        void_marks();
        if (not is_last(who)) {
            give(who, mark()); // its own stays good
        }
    }
    constexpr void end_reservation() noexcept { reserved_ = reservation::none; }
    [[nodiscard]] constexpr bool is_reserved() const noexcept { return reserved_ != reservation::none; }

    /// Another comes by while the line is reserved. Whether it does for the second time since the other one did: that
    /// one is gone, and the reservation with it.
    constexpr bool misses_reserver(asker& who) noexcept
    {
        standing const at = visit(who);
        if (at == standing::is_next or (at == standing::is_last and reserved_ == reservation::missed)) {
            reserved_ = reservation::none;
            return true;
        }
        if (at == standing::is_last) {
            reserved_ = reservation::missed;
        }
        return false;
    }

    /// Whether one of this standing may ask now, where the line is free and others wait. The one that was served last
    /// opens the turn for those that come by after it; where it does not come, it is that of the next.
    constexpr bool take(standing at) noexcept
    {
        others_wait_ = at == standing::waits;
        return at == standing::is_next;
    }

private:
    constexpr void give(asker& who, std::uint32_t number) const noexcept
    {
        who.ticket_ = number;
        who.turns_ = this;
    }

    /// One that giving up does not change.
    constexpr std::uint32_t mark() const noexcept { return number_ + mark_ + (marks_step - 1U); }

    static constexpr std::uint8_t marks_step = 4;

    /// Of the line, for one that comes before all others; `missed` where another came by since that one did.
    enum class reservation : std::uint8_t { none, held, missed };

    std::uint32_t number_{0}; ///< of a question, in steps; one behind it marks who came by since
    std::uint8_t mark_{0};
    bool others_wait_{false};
    bool is_missed_{false};
    reservation reserved_{reservation::none};
};

} // namespace rtuwire
