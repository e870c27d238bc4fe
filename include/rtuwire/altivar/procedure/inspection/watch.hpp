// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Watches a drive that another source commands: reads its status, its output frequency and its last fault, round after
// round, and never writes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/cia402/state.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/units.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/registers.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// How often a drive is read.
struct watch_options {
    /// From one round to the next; a round is two requests, or three where the registers stand apart.
    duration period{milliseconds(500)};
    /// How many rounds in a row may fail before the link counts as lost.
    std::uint8_t tolerated_misses{1};
    /// What these rounds may take longer than their periods, with their time-outs and the turns of others, before the link
    /// counts as lost: no round fails while the client asks nothing of a unit that another conversation has lost.
    duration longest_delay{milliseconds(3'000)};
};

/// A conversation without an end: give it to a client or a bus in each pass. Its values are those of the last complete
/// round; a round that fails leaves them as they are. **Its requests hold off the drive's own time-out** as any others
/// do: a drive whose controller is gone keeps running while it is watched.
template <device_type Device> class watch : public asker {
    static_assert(drive_check<Device>::passed);
    static constexpr drive_layout const& layout = Device::layout;

public:
    static constexpr conversation_properties properties{.repetition = repetition::never,
                                                        .freshness = freshness::when_free};
    static constexpr function_set asks{function_code::read_holding_registers};

    /// Watches this drive, with the period of the options.
    explicit constexpr watch(station<Device> const& its_drive, watch_options const& its_options = {}) noexcept
        : options_{its_options}, unit_{its_drive.unit()}
    {}

    /// The state that the drive reported; `unknown` before the first complete round.
    [[nodiscard]] constexpr cia402::state state() const noexcept
    {
        return rounds_ == 0 ? cia402::state::unknown : cia402::decode(status());
    }

    /// The status word, ETA; 0 before the first complete round.
    [[nodiscard]] constexpr std::uint16_t status() const noexcept { return seen_[status_at]; }

    /// The output frequency, below zero in reverse.
    [[nodiscard]] constexpr signed_decihertz frequency() const noexcept
    {
        auto const word = static_cast<std::int16_t>(seen_[frequency_at]);
        bool const turns_back = (status() & runs_backwards_bit) != 0;
        // Some drives report the magnitude only.
        bool const is_size_of_reverse = turns_back and word > 0;
        return signed_decihertz{is_size_of_reverse ? static_cast<std::int16_t>(-word) : word};
    }

    /// The present fault, as LFT numbers it; 0 without a fault.
    [[nodiscard]] constexpr std::uint16_t fault() const noexcept
    {
        return cia402::is_in_fault(state()) ? last_fault() : std::uint16_t{0};
    }

    /// The last fault, LFT, which a drive may keep after a reset.
    [[nodiscard]] constexpr std::uint16_t last_fault() const noexcept { return seen_[fault_at]; }

    /// Whether more rounds in a row failed than are tolerated, the last complete one is older than that takes, or none was
    /// complete yet.
    [[nodiscard]] constexpr bool link_lost() const noexcept { return is_old_ or misses_ > options_.tolerated_misses; }

    /// Why the last round failed; `none` where it was complete, `busy` before the first ended.
    [[nodiscard]] constexpr errc error() const noexcept { return error_; }

    /// Complete rounds so far; wraps.
    [[nodiscard]] constexpr std::uint32_t rounds() const noexcept { return rounds_; }

    [[nodiscard]] constexpr unit_id unit() const noexcept { return unit_; }

    constexpr void advance(instant now) noexcept
    {
        instant const at = has_begun_ ? detail::within_reach(now_, now) : now;
        now_ = now;
        if (not has_begun_) {
            has_begun_ = true;
            due_ = now;
        }
        is_due_ = is_due_ or reached(at, due_);
        is_old_ = is_old_ or reached(at, old_);
    }

    constexpr std::optional<request_frame> next() noexcept
    {
        if (not is_due_) {
            return std::nullopt;
        }
        block const& asked = blocks[at_];
        auto const frame = encode_into(frame_, unit_, read_holding_registers{asked.start, asked.count});
        return frame ? std::optional{request_frame{*frame}} : std::nullopt;
    }

    constexpr void accept(result<response> const& outcome) noexcept
    {
        errc const wrong = outcome ? take(outcome->pdu()) : outcome.error();
        if (wrong != errc::none) {
            constexpr std::uint8_t most = 0xFF;
            misses_ = misses_ == most ? most : static_cast<std::uint8_t>(misses_ + 1);
            return end_round(wrong);
        }
        ++at_;
        if (at_ == block_count) {
            misses_ = 0;
            seen_ = incoming_;
            ++rounds_;
            end_round(errc::none);
            is_old_ = false;
            old_ = now_ + options_.period * (options_.tolerated_misses + 1U) + options_.longest_delay;
        }
    }

    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        detail::earliest next;
        if (has_begun_ and not is_due_) {
            next.add(due_);
        }
        if (not is_old_) {
            next.add(old_);
        }
        return next;
    }

    /// Never: it goes on as long as it is given to a client.
    [[nodiscard]] static constexpr bool settled() noexcept { return false; }

private:
    /// Registers that one request reads.
    struct block {
        std::uint16_t start;
        std::uint16_t count;
    };

    static constexpr bool has_frequency_next = layout.rfr == layout.eta + 1;
    static constexpr bool has_fault_before = not has_frequency_next and layout.lft + 1 == layout.eta;
    static constexpr bool is_apart = not has_frequency_next and not has_fault_before;

    /// RFR follows ETA and LFT is separate, or LFT precedes ETA and RFR is separate, or all are.
    static constexpr std::size_t block_count = is_apart ? 3 : 2;
    static constexpr std::size_t status_at = has_fault_before ? 1 : 0;
    static constexpr std::size_t frequency_at = has_fault_before ? 2 : 1;
    static constexpr std::size_t fault_at = has_fault_before ? 0 : 2;
    static constexpr std::array<block, block_count> blocks = [] {
        if constexpr (is_apart) {
            return std::array{block{layout.eta, 1}, block{layout.rfr, 1}, block{layout.lft, 1}};
        } else if constexpr (has_fault_before) {
            return std::array{block{layout.lft, 2}, block{layout.rfr, 1}};
        } else {
            return std::array{block{layout.eta, 2}, block{layout.lft, 1}};
        }
    }();

    constexpr errc take(byte_view pdu) noexcept
    {
        constexpr std::size_t words_from = 2;
        std::size_t const count = blocks[at_].count;
        if (pdu.size() != words_from + 2 * count) {
            return errc::wrong_length;
        }
        std::size_t const first = at_ == 0 ? 0 : at_ + blocks[0].count - 1;
        for (std::size_t i = 0; i < count; ++i) {
            incoming_[first + i] = detail::u16_at(pdu, words_from + 2 * i);
        }
        return errc::none;
    }

    constexpr void end_round(errc error) noexcept
    {
        error_ = error;
        at_ = 0;
        is_due_ = false;
        due_ = now_ + options_.period;
    }

    watch_options options_;
    std::array<std::uint16_t, 3> incoming_{};
    std::array<std::uint16_t, 3> seen_{};
    std::array<std::byte, 8> frame_{};
    instant now_{0};
    instant due_{0};
    instant old_{0}; ///< when the last complete round is too old
    std::size_t at_{0};
    std::uint32_t rounds_{0};
    unit_id unit_;
    errc error_{errc::busy};
    std::uint8_t misses_{0};
    bool has_begun_{false};
    bool is_due_{false};
    bool is_old_{true}; ///< or there was none
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
