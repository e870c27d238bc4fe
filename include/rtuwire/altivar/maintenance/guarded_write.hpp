// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One write of a restore: of which family its drive has to be, how that has to stand, and what became of the write.
// Knows no request.
// Internal: may change with any version.
#pragma once

#include <cstdint>
#include <optional>

#include <rtuwire/altivar/maintenance/restore_options.hpp>
#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/altivar/procedure/inspection/at_rest.hpp>
#include <rtuwire/altivar/procedure/procedure.hpp>
#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/serial_line/device_identification.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Decides by the response to a request for the product code.
class identity_check {
public:
    enum class verdict : std::uint8_t {
        same,
        other,       ///< another family; or it told its product code before, and does not now
        not_told,    ///< it has no function 43/14
        not_reached, ///< no response, or one that is none: the error tells
    };

    /// For a drive of one family; the configuration and the map are of another, or of the same.
    constexpr identity_check(drive_family const& its_family, drive_family const& wanted, literal of_map,
                             bool implements_identification) noexcept
        : family_{its_family}, is_meant_{its_family.is_known() and its_family == wanted and
                                         (of_map.size() == 0 or drive_family::of(of_map) == its_family)},
          implements_identification_{implements_identification}
    {}

    /// As it was made.
    [[nodiscard]] constexpr identity_check anew() const noexcept
    {
        identity_check same = *this;
        same.lacks_product_code_ = same.is_identified_ = same.was_told_ = false;
        return same;
    }

    /// Whether configuration and map are for such a drive.
    [[nodiscard]] constexpr bool is_meant() const noexcept { return is_meant_; }

    /// Whether the drive is to be asked for its product code; registers are compared otherwise.
    [[nodiscard]] constexpr bool has_identification() const noexcept
    {
        return implements_identification_ and not lacks_product_code_;
    }

    /// Whether the drive was identified since `expire`.
    [[nodiscard]] constexpr bool holds() const noexcept { return is_identified_; }

    /// The drive is asked again before the next write; one that does not tell who it is, is not.
    constexpr void expire() noexcept { is_identified_ = not has_identification(); }

    /// The registers were compared.
    constexpr void note_same() noexcept { is_identified_ = true; }

    constexpr verdict judge(result<response> const& outcome, errc& error) noexcept
    {
        error = outcome.error();
        if (is_lack(error)) {
            lacks_product_code_ = not was_told_;
            return was_told_ ? verdict::other : verdict::not_told;
        }
        if (not outcome) {
            return verdict::not_reached;
        }
        auto const page = outcome->to<read_device_identification>();
        if (not page) {
            error = page.error();
            return verdict::not_reached;
        }
        auto const product = page->find(product_code);
        bool const is_same = product and drive_family::of(*product) == family_;
        is_identified_ = is_same;
        was_told_ = was_told_ or is_same;
        return is_same ? verdict::same : verdict::other;
    }

    /// Whether a register is compared where the drive does not tell who it is.
    [[nodiscard]] static constexpr bool is_compared(parameter const& row) noexcept
    {
        return not row.is_writable() and row.source() != provenance::doubtful;
    }

private:
    /// Whether a drive that sent this has no function 43/14, or not this object.
    static constexpr bool is_lack(errc error) noexcept
    {
        return error == errc::illegal_function or error == errc::illegal_data_address or
               error == errc::illegal_data_value;
    }

    drive_family family_;
    bool is_meant_;
    bool implements_identification_;
    bool lacks_product_code_{false}; ///< it was asked for that, and has none
    bool is_identified_{false};
    bool was_told_{false}; ///< by the product code, ever
};

/// What a drive has to be like for a write.
enum class write_care : std::uint8_t {
    rest,        ///< it stands without a command
    open_inputs, ///< and is without a fault, its run inputs open: the write may start it by the terminals or by itself
    all_inputs,  ///< these open in three-wire control, too: the write may make a stop contact a run input
};

/// A write of the supervision may take away what holds a motor back that a terminal commands.
[[nodiscard]] constexpr write_care care_for(parameter_role role) noexcept
{
    bool const may_be_started =
        role == parameter_role::supervision or role == parameter_role::restart or role == parameter_role::channel;
    bool const may_be_rewired = role == parameter_role::macro or role == parameter_role::run_input;
    return may_be_rewired ? write_care::all_inputs : may_be_started ? write_care::open_inputs : write_care::rest;
}

/// Decides the check, word by word. A drive in fault stands, too; a write that needs more care then needs the whole check
/// of `at_rest_procedure`, which ends this one as it ends.
///
/// | read of  | answer            | next                             |
/// |----------|-------------------|----------------------------------|
/// | ETA      | 2, 3, 4, 8        | read CMD                         |
/// |          | 5, 6, 7           | end: refused_while_running       |
/// |          | 1, or no state    | end: aborted                     |
/// | CMD      | 0                 | read RFR                         |
/// |          | other             | end: overwritten                 |
/// | RFR      | 0                 | end: succeeded; or at_rest       |
/// |          | other             | end: refused_while_running       |
/// | anything | no response       | end: silent                      |
/// |          | refused otherwise | end: refused                     |
///
/// ETA is read with its neighbour: see `procedure::look`. A command of 0006 moves nothing either, but it is somebody's: a drive
/// that another master holds ready is not restored.
class write_guard : public procedure {
public:
    constexpr write_guard(drive_layout const& layout, terminal_options const& options) noexcept
        : procedure{layout}, rest_{layout, options}, options_{options}
    {}

    /// Starts a check.
    constexpr action begin(write_care care) noexcept
    {
        *this = write_guard{layout(), options_};
        rest_ = at_rest_procedure{layout(), options_, {.ends_three_wire = care == write_care::all_inputs}};
        care_ = care;
        return look();
    }

    constexpr action step(event what) noexcept
    {
        if (asked_ == asked::rest) {
            action const next = run_inside(rest_, what);
            return what_of(next) == action_kind::end and reason().kind == outcome_kind::pending
                       ? end(outcome_kind::succeeded)
                       : next;
        }
        if (what.what() == event::kind::word_read) {
            return judge(what);
        }
        return what.what() == event::kind::failed ? end(what.error()) : end(outcome_kind::aborted);
    }

private:
    enum class asked : std::uint8_t { status, command, speed, rest };

    constexpr action judge(event what) noexcept
    {
        std::uint16_t const word = what.word();
        switch (asked_) {
        case asked::status: return judge_state(note(status_in(what)));
        case asked::command:
            asked_ = asked::speed;
            return word == 0 ? to_read(layout().rfr) : end(outcome_kind::overwritten);
        case asked::speed:
        case asked::rest: break;
        }
        if (word != 0) {
            return end(outcome_kind::refused_while_running);
        }
        if (care_ == write_care::rest) {
            return end(outcome_kind::succeeded);
        }
        asked_ = asked::rest;
        return rest_.step({event::kind::begun});
    }

    constexpr action judge_state(cia402::state at) noexcept
    {
        if (stands(at) or at == cia402::state::fault) {
            asked_ = asked::command;
            return to_read(layout().cmd);
        }
        bool const may_turn = cia402::has_power(at) or at == cia402::state::fault_reaction_active;
        return end(may_turn ? outcome_kind::refused_while_running : outcome_kind::aborted);
    }

    at_rest_procedure rest_;
    terminal_options options_;
    asked asked_{asked::status};
    write_care care_{write_care::rest};
};

/// Decides one write, step by step. Each write is sent once, to a drive that was just checked; after no response it is
/// read back, and sent again after another check. What follows each step:
///
/// | step         | what came               | next      | told as                                        |
/// |--------------|-------------------------|-----------|------------------------------------------------|
/// | check failed |                         | end       | not_reached                                    |
/// | write        | confirmed               | read back |                                                |
/// |              | confirmed, of the link  | the next  | not_read_back                                  |
/// |              | exception               | read back |                                                |
/// |              | no response             | read back |                                                |
/// |              | never sent              | end       | not_reached                                    |
/// |              | other                   | end       | unconfirmed                                    |
/// | read back    | the wanted word         | the next  | written                                        |
/// |              | another, confirmed      | the next  | differs                                        |
/// |              | another, refused        | the next  | refused                                        |
/// |              | another, no response    | check     | the fifth time: end, not_reached               |
/// |              | exception               | the next  | refused where the write was; else as below     |
/// |              | other                   | end       | confirmed where the write was, or unconfirmed  |
class row_write {
public:
    enum class verdict : std::uint8_t {
        read_back,
        check_again, ///< and write again
        next,        ///< the parameter is told
        end,         ///< it is told, and the restore ends
    };

    constexpr row_write() noexcept = default;

    /// A write of `wanted` to a register that holds `held`; one of the link is not read back.
    constexpr row_write(std::uint16_t wanted, std::uint16_t held, bool is_of_link) noexcept
        : report_{restore_outcome::not_reached, held}, wanted_{wanted}, is_of_link_{is_of_link}
    {}

    /// The word that is sent.
    [[nodiscard]] constexpr std::uint16_t wanted() const noexcept { return wanted_; }

    /// The drive may not be written to, or the write was never sent.
    constexpr verdict stop(errc error) noexcept { return tell(restore_outcome::not_reached, error, verdict::end); }

    constexpr verdict confirm() noexcept
    {
        is_confirmed_ = true;
        error_ = errc::none;
        return is_of_link_ ? tell(restore_outcome::not_read_back, errc::none, verdict::next) : verdict::read_back;
    }

    /// The write was sent, and failed.
    constexpr verdict fail(errc error) noexcept
    {
        error_ = error;
        return is_exception(error) or is_silence(error) ? verdict::read_back : lose(error);
    }

    /// It was read back.
    constexpr verdict compare(std::uint16_t word) noexcept
    {
        report_.held = word;
        if (word == wanted_) {
            return tell(restore_outcome::written, errc::none, verdict::next);
        }
        if (is_confirmed_) {
            return tell(restore_outcome::differs, errc::none, verdict::next);
        }
        if (is_exception(error_)) {
            return tell(restore_outcome::refused, error_, verdict::next);
        }
        constexpr std::uint8_t most_attempts = 5;
        return ++attempts_ < most_attempts ? verdict::check_again : stop(error_);
    }

    /// It could not be read back.
    constexpr verdict go_without(errc error) noexcept
    {
        if (not is_exception(error)) {
            return lose(error);
        }
        if (is_exception(error_)) {
            return tell(restore_outcome::refused, error_, verdict::next);
        }
        return tell_unknown(error, verdict::next);
    }

    [[nodiscard]] constexpr restore_report const& report() const noexcept { return report_; }

    /// Whether it was confirmed, or read back as wanted.
    [[nodiscard]] constexpr bool has_written() const noexcept
    {
        return report_.outcome == restore_outcome::written or report_.outcome == restore_outcome::not_read_back;
    }

private:
    /// Whether it is worth asking the drive; not where its user gave it up.
    static constexpr bool is_silence(errc error) noexcept
    {
        error_category const of = category_of(error);
        bool const is_given_up = error == errc::cancelled;
        return not is_given_up and (of == error_category::no_response or of == error_category::reception);
    }

    constexpr verdict lose(errc error) noexcept { return tell_unknown(error, verdict::end); }

    /// It was sent, and what the drive holds since was not read.
    constexpr verdict tell_unknown(errc error, verdict next) noexcept
    {
        report_.held = std::nullopt;
        return tell(is_confirmed_ ? restore_outcome::confirmed : restore_outcome::unconfirmed, error, next);
    }

    constexpr verdict tell(restore_outcome outcome, errc error, verdict next) noexcept
    {
        report_.outcome = outcome;
        report_.error = error;
        return next;
    }

    restore_report report_{restore_outcome::not_reached};
    std::uint16_t wanted_{0};
    std::uint8_t attempts_{0};
    errc error_{errc::none}; ///< of the write
    bool is_confirmed_{false};
    bool is_of_link_{false};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
