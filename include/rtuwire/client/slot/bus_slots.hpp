// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The slots of a bus: which of their units are silent, which one is probed next, and what a probe costs the others.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/client/slot/bus_options.hpp>
#include <rtuwire/core/filled.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/limits.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// How far the visits are since the request left.
enum class visit_stage : std::uint8_t {
    changing, ///< no request is under way, or it has not left
    settling, ///< all slots visit once in a pass that began with the request under way
    settled,  ///< they did, and what is known of silent slots and rests is theirs
};

/// What a bus knows of all slots together. A base of its own, so that it lies in front of the client: small processors
/// reach near members with short instructions.
class bus_state {
protected:
    bool is_idle_{false};          ///< nobody has a turn in this pass
    bool is_new_pass_{false};      ///< a slot's conversation visited since the latest pass that is not idle began
    bool stays_awake_{false};      ///< one that no pass leaves out visited since then
    bool has_silent_{false};       ///< in an idle pass: a slot is silent
    bool is_probe_limited_{false}; ///< silent slots wait until `probe_at_`
    visit_stage stage_{visit_stage::changing};
    instant asked_at_{0};
    instant probe_at_{0};
    deadline wake_{};     ///< the first of the conversations' times
    deadline rest_end_{}; ///< in an idle pass: of the slots that rest
};

/// The slots of a bus and the client that they share; the base of `bus`.
template <std::size_t Slots, typename Statistics> class bus_slots : protected bus_state {
protected:
    struct slot {
        slot_options options{};
        instant not_before{0}; ///< the end of the rest
        instant last_asked{0};
        duration order_gap{}; ///< from one request to the next while its unit is ordered; 0: none
        std::uint8_t unit{0}; ///< of the last request; `failures` and `has_responded` are its
        std::uint8_t failures{0};
        bool is_resting{false};
        bool is_here{false};    ///< came by in this pass
        bool is_present{false}; ///< came by in this pass or the one before, not settled
        bool has_responded{false};
    };

    constexpr bus_slots(line_timing const& its_line, client_options const& its_options,
                        bus_options const& share) noexcept
        : client_{its_line, its_options}, share_{share}
    {
        constexpr std::uint8_t all = 100;
        std::uint8_t const wanted = share.silent_share;
        share_.silent_share = wanted == 0 ? std::uint8_t{1} : wanted < all ? wanted : all;
        for (slot& each : slots_) {
            each.options.with.response_timeout = its_options.response_timeout;
            each.options.with.retries = its_options.retries;
        }
    }

    /// When a conversation has something to do by itself.
    template <typename Conversation> static constexpr deadline wake_of(Conversation const& conversation) noexcept
    {
        if constexpr (timed_conversation<Conversation>) {
            return conversation.poll_deadline();
        } else {
            return {};
        }
    }

    /// Notes a time at which `converse` is to be called again for a conversation; a time that has come needs no note,
    /// because this is that call. One place is enough: `advance` ends all of these times, and those who visit then name
    /// theirs again.
    constexpr void wake_at(deadline const& next, instant now) noexcept
    {
        if (next and not reached(now, *next) and not(wake_ and reached(*next, *wake_))) {
            wake_ = *next;
        }
    }

    constexpr void note_health(slot& own, errc error, instant now) noexcept
    {
        own.not_before = now + own.options.least_idle;
        own.is_resting = own.options.least_idle.microseconds != 0;
        if (client_.asked_unit() == 0) {
            return; // no unit responds to a broadcast
        }
        if (error == errc::none or is_exception(error)) {
            own.failures = 0;
            own.has_responded = true;
        } else if (error != errc::cancelled) {
            own.failures = static_cast<std::uint8_t>(own.failures + (own.failures < 0xFF ? 1 : 0));
            charge(now - asked_at_, now);
        }
    }

    /// Delays the next request to a silent unit by the share of time that the others get for this loss of time.
    constexpr void charge(duration cost, instant now) noexcept
    {
        constexpr std::uint32_t longest_rest = 600'000'000;
        constexpr std::uint32_t longest = 1'800'000'000;
        std::uint32_t const others = 100U - share_.silent_share;
        std::uint32_t const part = cost.microseconds / share_.silent_share + 1;
        std::uint32_t const rest = others == 0 or part <= longest_rest / others ? part * others : longest_rest;
        std::uint32_t const all = rest + (is_probe_limited_ ? (probe_at_ - asked_at_).microseconds : 0);
        probe_at_ = now + microseconds(all < longest ? all : longest);
        is_probe_limited_ = true;
    }

    constexpr bool is_silent(slot const& own) const noexcept
    {
        return own.failures != 0 and (own.failures >= share_.silent_after or not own.has_responded);
    }

    /// A request to a silent unit has no retries.
    constexpr retry_policy own_retry_policy(slot const& own) const noexcept
    {
        retry_policy with = own.options.with;
        with.retries = is_silent(own) ? std::uint8_t{0} : with.retries;
        return with;
    }

    /// Whether a slot must wait; `wake_`, or a time that `poll_deadline` knows, then says until when.
    constexpr bool is_held_back(std::size_t index, instant now) noexcept
    {
        slot& own = slots_[index];
        if (own.is_resting) {
            return true;
        }
        if (not is_silent(own)) {
            return false;
        }
        if (is_probe_limited_) {
            return true;
        }
        if (next_to_probe(index) == index and fits(index, now)) {
            return false;
        }
        // The other slot's conversation may settle later in this pass, or be gone in the next.
        wake_at(now + own.options.with.response_timeout, now);
        return true;
    }

    /// The silent slot whose turn it is: after the last one that was asked, the first for which `converse` is called;
    /// `own` is one of these.
    constexpr std::size_t next_to_probe(std::size_t own) const noexcept
    {
        std::size_t at = last_probed_;
        do {
            at = at + 1 == Slots ? 0 : at + 1;
        } while (at != own and not is_candidate(slots_[at]));
        return at;
    }

    constexpr bool is_candidate(slot const& each) const noexcept
    {
        return each.is_present and not each.is_resting and is_silent(each) and not client_.is_held(each.unit);
    }

    /// Whether the time-out of a silent unit ends before any other unit has to be asked. Other silent units do not
    /// count: two of them would wait for each other for ever.
    constexpr bool fits(std::size_t index, instant now) const noexcept
    {
        instant const end =
            now + slots_[index].options.with.response_timeout + client_.line().characters(2 * max_adu_size);
        for (std::size_t i = 0; i < Slots; ++i) {
            slot const& other = slots_[i];
            bool const matters = i != index and other.is_present and other.unit != 0 and not is_silent(other);
            if (matters and
                (is_before(other, other.options.longest_gap, end) or is_before(other, other.order_gap, end))) {
                return false;
            }
        }
        return true;
    }

    /// Whether a unit has to be asked before `end`, where it may wait no longer than `gap`. It may have been asked an
    /// hour ago.
    static constexpr bool is_before(slot const& other, duration gap, instant end) noexcept
    {
        return gap != duration{} and end - other.last_asked > gap;
    }

    basic_client<Statistics, stored<line_timing>, stored<client_options>, quarantine<Slots>, shared_memory,
                 orders<Slots>>
        client_;
    bus_options share_;
    std::size_t last_probed_{Slots - 1};
    std::array<slot, Slots> slots_{filled<Slots>(slot{})};
};

} // namespace rtuwire
