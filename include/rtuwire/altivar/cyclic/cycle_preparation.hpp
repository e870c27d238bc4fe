// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a cycle reads before it writes, and again after everything that could have changed it: whether the drive may
// be commanded, and whether its scanner holds the words of the cycle. The last word is the drive's status.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/cyclic/cycle_frames.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/registers.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The reads of one drive, request by request.
template <drive_type Device> class cycle_preparation {
    using words = cycle_layout<Device>;

public:
    explicit constexpr cycle_preparation(supervision_options const& its_options) noexcept
        : options_{its_options}, check_{Device::layout, its_options, words::is_by_speed}
    {}

    /// Discards the result: everything is read again.
    constexpr void renew() noexcept
    {
        finding_ = outcome_kind::pending;
        is_begun_ = false;
    }

    /// `pending` while there is something to read, then `succeeded`, or the reason against an order.
    [[nodiscard]] constexpr outcome_kind finding() const noexcept { return finding_; }
    [[nodiscard]] constexpr bool succeeded() const noexcept { return finding_ == outcome_kind::succeeded; }

    /// The report of the last check that was completed.
    [[nodiscard]] constexpr supervision_report const& report() const noexcept { return report_; }

    /// What was read of CHCF, as for `commander::note_meaning`; reported once.
    constexpr std::uint16_t take_meaning() noexcept { return check_.take_meaning(); }

    /// The next read.
    [[nodiscard]] constexpr read_holding_registers request() noexcept
    {
        if (not is_begun_) {
            begin();
            action_ = check_.step({event::kind::begun});
        }
        switch (stage_) {
        case stage::inputs: return {words::scanner.input_addresses, words::inputs};
        case stage::outputs: return {words::scanner.output_addresses, words::outputs};
        case stage::safeguards: break;
        }
        return {address_of(action_), 1};
    }

    /// Takes the response. `in_use` has a bit for each output slot that may be active.
    constexpr void take(register_view read, std::uint32_t in_use) noexcept
    {
        switch (stage_) {
        case stage::safeguards: return examine({event::kind::word_read, read[0]});
        case stage::inputs: return note_slots(are_inputs(read), stage::outputs);
        case stage::outputs: break;
        }
        note_slots(are_outputs(read, in_use), stage::safeguards);
    }

    /// The drive answered with an exception.
    constexpr void take_exception(errc error) noexcept
    {
        if (stage_ == stage::safeguards) {
            return examine({event::kind::failed, 0, error});
        }
        note_slots(false, stage::safeguards);
    }

private:
    enum class stage : std::uint8_t { inputs, outputs, safeguards };

    /// Not inlined: what it makes on the stack is gone before the check's first step.
    [[gnu::noinline]] constexpr void begin() noexcept
    {
        is_begun_ = true;
        stage_ = words::has_scanner ? stage::inputs : stage::safeguards;
        holds_words_ = true;
        check_ = supervision_procedure{Device::layout, options_, words::is_by_speed};
    }

    constexpr void examine(event what) noexcept
    {
        action_ = check_.step(what);
        if (what_of(action_) != action_kind::end) {
            return;
        }
        report_ = check_.report();
        outcome_kind const found = check_.reason().kind;
        finding_ = found == outcome_kind::succeeded and not holds_words_ ? outcome_kind::misconfigured : found;
    }

    /// A scanner that holds other words is told last: what the drive's control words mean counts for the stop, too.
    constexpr void note_slots(bool are_right, stage next) noexcept
    {
        holds_words_ = holds_words_ and are_right;
        stage_ = next;
    }

    static constexpr bool are_inputs(register_view addresses) noexcept
    {
        return addresses[words::status_at] == Device::layout.eta and addresses[words::speed_at] == words::words.speed;
    }

    static constexpr bool are_outputs(register_view addresses, std::uint32_t in_use) noexcept
    {
        bool is_right = addresses[words::command_at] == Device::layout.cmd and
                        addresses[words::reference_at] == words::reference.address;
        for (std::size_t slot = 0; slot < words::outputs; ++slot) {
            bool const is_in_use = ((in_use >> slot) & 1U) != 0;
            is_right = is_right and (is_in_use or not words::is_free(slot) or addresses[slot] == 0);
        }
        return is_right;
    }

    // Small processors reach what is near with short instructions.
    action action_{to_pause({})};
    outcome_kind finding_{outcome_kind::pending};
    stage stage_{stage::safeguards};
    bool holds_words_{true}; ///< the scanner
    bool is_begun_{false};
    supervision_options options_;
    supervision_procedure check_;
    supervision_report report_{};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
