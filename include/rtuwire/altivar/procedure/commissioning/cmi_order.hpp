// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// An order in CMI that replaces a drive's settings: a recall, or the factory settings. It is sent once, to a drive that
// was just read to be at rest, and an order that the drive may have left in CMI is cleared: it would be executed some
// day. After the order, the drive may have another address or rate, so no end says then that it was silent.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/procedure/inspection/at_rest.hpp>
#include <rtuwire/altivar/procedure/procedure.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// One of the orders in CMI, which are those below.
struct cmi_order {
    std::uint16_t bit;
    at_rest_rules rules;      ///< how the drive is checked before it
    bool is_read_back{false}; ///< the drive clears the bit once it has accepted the order, and can still be asked
};

inline constexpr cmi_order factory_order{.bit = 0x0001, .rules = {.accepts_fault = true, .ends_three_wire = true}};
inline constexpr cmi_order recall_order{.bit = 0x0004, .rules = {.ends_three_wire = true}, .is_read_back = true};

/// Decides such an order, word by word. "Undo" writes CMI without any order, and then ends so; "maybe" is
/// `executed_unconfirmed`.
///
/// | stage           | word read                      | confirmed | no response | refused       | limit over   |
/// |-----------------|--------------------------------|-----------|-------------|---------------|--------------|
/// | looking         | the check, read CMI            |           | end: silent | as in a check | end: aborted |
/// | reading_control | write CMI with the order       |           | end: silent | end: refused  | end: aborted |
/// | ordering        |                                | wait      | wait        | end: refused  | end: aborted |
/// | waiting         |                                |           |             |               | undo: maybe  |
/// | confirming      | the bit is 0: end: succeeded   |           | undo: maybe | undo: maybe   | undo: maybe  |
/// |                 | else undo: not_taken           |           |             |               |              |
/// | taking_back     |                                | end: so   | end: so     | end: so       | write again  |
///
/// A wait ends with a read of CMI, or with "undo: maybe" where the order is not read back. A bit that is 0 after no
/// response to the order is "maybe": the order may not have arrived. A unit that is lost gets no further request: it
/// ends as `silent` before the order was sent, and as "maybe" after that.
class cmi_order_procedure : public procedure {
public:
    constexpr cmi_order_procedure(drive_layout const& layout, terminal_options const& options,
                                  cmi_order const& order) noexcept
        : procedure{layout}, look_{layout, options, order.rules}, order_{&order}
    {}

    [[nodiscard]] constexpr cmi_order_procedure anew() const noexcept { return {layout(), look_.anew(), *order_}; }

    constexpr action step(event what) noexcept
    {
        if (stage_ == stage::looking) {
            return check_rest(what);
        }
        switch (what.what()) {
        case event::kind::word_read: return on_response(what.word());
        case event::kind::written: return after_write();
        case event::kind::pause_over: return after_wait();
        case event::kind::failed: return go_without(what.error());
        case event::kind::begun:
        case event::kind::late: break;
        }
        return end_late();
    }

private:
    enum class stage : std::uint8_t { looking, reading_control, ordering, waiting, confirming, taking_back };

    constexpr cmi_order_procedure(drive_layout const& layout, at_rest_procedure const& look,
                                  cmi_order const& order) noexcept
        : procedure{layout}, look_{look}, order_{&order}
    {}

    constexpr action ask(stage next) noexcept
    {
        stage_ = next;
        return to_read(layout().cmi);
    }

    constexpr action check_rest(event what) noexcept
    {
        action const next = run_inside(look_, what);
        return look_.reason().kind == outcome_kind::succeeded ? ask(stage::reading_control) : next;
    }

    constexpr action on_response(std::uint16_t word) noexcept
    {
        if (stage_ == stage::reading_control) {
            // Orders in the word that was read are not repeated: factory settings, save, recall.
            control_ = static_cast<std::uint16_t>(word & ~layout().cmi_orders);
            stage_ = stage::ordering;
            return once(to_rearrange(layout().cmi, static_cast<std::uint16_t>(control_ | order_->bit)));
        }
        if ((word & order_->bit) != 0) {
            return undo(outcome_kind::not_taken);
        }
        return was_confirmed_ ? end(outcome_kind::succeeded) : end(outcome_kind::executed_unconfirmed, error_);
    }

    constexpr action after_write() noexcept
    {
        if (stage_ == stage::taking_back) {
            return end(reason().kind);
        }
        was_confirmed_ = true;
        return wait(errc::none);
    }

    /// After a response to the order, or after none.
    constexpr action wait(errc error) noexcept
    {
        error_ = error;
        stage_ = stage::waiting;
        return to_pause(layout().eeprom_time);
    }

    constexpr action after_wait() noexcept
    {
        return order_->is_read_back ? ask(stage::confirming) : undo(outcome_kind::executed_unconfirmed, error_);
    }

    /// A unit is lost before a request is sent, never while it is under way.
    constexpr action go_without(errc error) noexcept
    {
        bool const is_lost = error == errc::unit_lost;
        switch (stage_) {
        case stage::ordering: return is_lost or is_exception(error) ? end(error) : wait(error);
        case stage::waiting: return end(outcome_kind::executed_unconfirmed, error);
        case stage::confirming:
            return is_lost ? end(outcome_kind::executed_unconfirmed, error)
                           : undo(outcome_kind::executed_unconfirmed, error);
        case stage::looking:
        case stage::reading_control:
        case stage::taking_back: break;
        }
        return end(error); // taking back: the outcome stands already
    }

    constexpr action end_late() noexcept
    {
        if (stage_ == stage::reading_control or stage_ == stage::ordering) {
            return end(outcome_kind::aborted); // the order was not sent
        }
        return undo(outcome_kind::executed_unconfirmed, error_);
    }

    /// Ends, but not with the order in CMI. The first outcome counts.
    constexpr action undo(outcome_kind kind, errc error = errc::none) noexcept
    {
        static_cast<void>(end(kind, error));
        stage_ = stage::taking_back;
        return to_write(layout().cmi, control_);
    }

    at_rest_procedure look_;
    cmi_order const* order_;
    std::uint16_t control_{0};
    errc error_{errc::none};
    stage stage_{stage::looking};
    bool was_confirmed_{false};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
