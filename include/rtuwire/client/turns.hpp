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

/// The turns on one line.
class turns {
public:
    /// A conversation asks: it has this line's next number, and nobody waits.
    constexpr void begin(asker& who) noexcept
    {
        others_wait_ = false;
        renew(who);
    }

    /// Gives who asked last another number: whoever was marked so far counts as not marked.
    constexpr void renew(asker& who) noexcept
    {
        is_missed_ = false;
        number_ += step;
        give(who, number_);
    }

    /// The same where who asked last is not at hand.
    constexpr void void_marks() noexcept
    {
        mark_ = mark_ + 1 == marks ? std::uint8_t{0} : static_cast<std::uint8_t>(mark_ + 1);
    }

    /// Whether it was this conversation that asked last.
    [[nodiscard]] constexpr bool is_own(asker const& who) const noexcept
    {
        return who.ticket_ == number_ and who.turns_ == this;
    }

    /// The same, also where it has given up what it asked.
    [[nodiscard]] constexpr bool is_last(asker const& who) const noexcept
    {
        return (who.ticket_ == number_ or who.ticket_ == number_ + asker::given_up) and
               who.turns_ == this;
    }

    /// Whether what this conversation asked was dropped because it did not come by. Told once.
    constexpr bool was_dropped(asker& who) const noexcept
    {
        bool const is_lost =
            who.turns_ == this and who.ticket_ % step == 0 and who.ticket_ != number_;
        if (is_lost) {
            who.forget();
        }
        return is_lost;
    }

    /// Others than the one that asked last wait for their turn.
    constexpr void note_waiting() noexcept { others_wait_ = true; }
    [[nodiscard]] constexpr bool others_wait() const noexcept { return others_wait_; }

    /// Somebody comes by who cannot ask now. Whether it is the one that asked last, or the next in turn.
    constexpr bool waits(asker& who) noexcept
    {
        others_wait_ = others_wait_ or not is_last(who);
        return is_next(who);
    }

    /// Such a one finds that only the one that asked is missing. Whether it takes that one's place: at once where it
    /// is its own request, which it has given up; else for the second time, and the other had its chance in between.
    constexpr bool takes_over(asker& who) noexcept
    {
        bool const is_sure = is_missed_ or is_last(who);
        is_missed_ = true;
        if (is_sure and not is_last(who)) {
            number_ += step;
            give(who, mark());
        }
        return is_sure;
    }

    /// Whether this conversation may ask now, where the line is free. Where others wait, the one that was served
    /// last opens the turn for those that come by after it; where it does not come, it is that of the next.
    constexpr bool take(asker& who) noexcept
    {
        if (not others_wait_) {
            return true;
        }
        others_wait_ = not is_next(who);
        return not others_wait_ and not is_last(who);
    }

private:
    /// The next in turn is the first that comes by twice, beginning behind the one that asked, so that nobody is
    /// next who is gone in the next pass. It stays so while it comes by; where it does not, the first that comes by
    /// twice meanwhile is.
    constexpr bool is_next(asker& who) noexcept
    {
        if (is_last(who)) {
            return true;
        }
        bool const is_second = who.ticket_ == mark() and who.turns_ == this;
        if (is_second) {
            void_marks();
        }
        give(who, mark());
        return is_second;
    }

    constexpr void give(asker& who, std::uint32_t number) const noexcept
    {
        who.ticket_ = number;
        who.turns_ = this;
    }

    /// An odd number, so that a conversation that is given up keeps it.
    constexpr std::uint32_t mark() const noexcept { return number_ + 3U + 2U * mark_; }

    static constexpr std::uint32_t step = asker::tickets;
    static constexpr std::uint8_t marks = (step - 2) / 2;

    std::uint32_t number_{0}; ///< of a question, in steps; one of those behind it marks who came by since
    std::uint8_t mark_{0};
    bool others_wait_{false};
    bool is_missed_{false};
};

} // namespace rtuwire
