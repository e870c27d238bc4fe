// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A procedure decides and `procedure_runner` acts: what happened goes in as an event, what to do next comes out as an
// action. So each start, stop or reset is a small function of words, without frames or clocks. An action is one number: a
// 32-bit processor returns that in two registers, and a class of the same size through memory.
// Internal: may change with any version.
#pragma once

#include <cstdint>
#include <utility>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/procedure/outcome.hpp>
#include <rtuwire/ask/commander.hpp>
#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// What happened. Two words, which go in two registers.
class event {
public:
    enum class kind : std::uint8_t {
        begun,      ///< `word` is not 0 where this client has ordered the motor to run
        word_read,  ///< `word` is what was read
        written,    ///< the drive confirmed the write
        failed,     ///< a read or write failed; `error` tells why
        pause_over, ///< the pause that was requested has passed
        late,       ///< the time limit has passed; the last request was not sent, and one more is allowed
    };

    /// `second` is the word behind it, where two were to be read.
    constexpr event(kind what = kind::begun, std::uint16_t word = 0, errc error = errc::none,
                    std::uint16_t second = 0) noexcept
        : bits_{static_cast<std::uint64_t>(what) | static_cast<std::uint64_t>(word) << 16U |
                static_cast<std::uint64_t>(error) << 32U | static_cast<std::uint64_t>(second) << 48U}
    {}

    [[nodiscard]] constexpr kind what() const noexcept { return static_cast<kind>(bits_ & 0xFFU); }
    [[nodiscard]] constexpr std::uint16_t word() const noexcept { return static_cast<std::uint16_t>(bits_ >> 16U); }
    [[nodiscard]] constexpr errc error() const noexcept { return static_cast<errc>(bits_ >> 32U & 0xFFU); }
    [[nodiscard]] constexpr std::uint16_t second() const noexcept { return static_cast<std::uint16_t>(bits_ >> 48U); }

private:
    std::uint64_t bits_;
};

enum class action_kind : std::uint8_t { read, write, pause, end };

/// What to do next.
///
/// | bits   | what                                                        | of              |
/// |--------|-------------------------------------------------------------|-----------------|
/// | 0..1   | `action_kind`                                               | all             |
/// | 2      | two neighbouring words are read, not one                    | a read          |
/// | 3      | it is sent once                                             | a request       |
/// | 4..6   | `effect`                                                    | a write         |
/// | 7      | it fails if it cannot be sent for `longest_gap_in_presence` | a write         |
/// | 16..31 | address                                                     | a request       |
/// | 32..47 | word                                                        | a write         |
/// | 32..63 | length in microseconds; a read fails if it cannot be sent for so long, unless that is 0 | a pause, a read |
enum class action : std::uint64_t {};

[[nodiscard]] constexpr action_kind what_of(action of) noexcept
{
    return static_cast<action_kind>(static_cast<unsigned>(of) & 3U);
}
[[nodiscard]] constexpr std::uint8_t count_of(action of) noexcept
{
    return (static_cast<unsigned>(of) & 4U) == 0 ? 1 : 2;
}
[[nodiscard]] constexpr repetition repetition_of(action of) noexcept
{
    return (static_cast<unsigned>(of) & 8U) == 0 ? repetition::allowed : repetition::never;
}
[[nodiscard]] constexpr detail::effect effect_of(action of) noexcept
{
    return static_cast<detail::effect>(static_cast<unsigned>(of) >> 4U & 7U);
}
/// Whether its effect is `stopping`, by the one bit of that: no other effect has it.
[[nodiscard]] constexpr bool does_stop(action of) noexcept
{
    static_assert(static_cast<unsigned>(detail::effect::stopping) == 4);
    return (static_cast<unsigned>(of) & 0x40U) != 0;
}
[[nodiscard]] constexpr std::uint16_t address_of(action of) noexcept
{
    return static_cast<std::uint16_t>(static_cast<std::uint32_t>(of) >> 16U);
}
[[nodiscard]] constexpr std::uint16_t word_of(action of) noexcept
{
    return static_cast<std::uint16_t>(static_cast<std::uint64_t>(of) >> 32U);
}
[[nodiscard]] constexpr duration length_of(action of) noexcept
{
    if (what_of(of) == action_kind::write) {
        return (static_cast<unsigned>(of) & 0x80U) == 0 ? duration{} : detail::longest_gap_in_presence;
    }
    return duration{static_cast<std::uint32_t>(static_cast<std::uint64_t>(of) >> 32U)};
}

} // namespace altivar

namespace detail {

constexpr altivar::action with(altivar::action what, std::uint64_t bits, unsigned at) noexcept
{
    return altivar::action{static_cast<std::uint64_t>(what) | bits << at};
}

constexpr altivar::action to_write(std::uint16_t address, std::uint16_t word, effect does) noexcept
{
    constexpr altivar::action write{static_cast<std::uint64_t>(altivar::action_kind::write)};
    return with(with(with(write, static_cast<std::uint64_t>(does), 4), address, 16), word, 32);
}

} // namespace detail

namespace altivar {

[[nodiscard]] constexpr action to_read(std::uint16_t address) noexcept
{
    return detail::with(action{static_cast<std::uint64_t>(action_kind::read)}, address, 16);
}
/// Two neighbouring words, by one request.
[[nodiscard]] constexpr action to_read_two(std::uint16_t address) noexcept
{
    return detail::with(to_read(address), 1, 2);
}
[[nodiscard]] constexpr action to_write(std::uint16_t address, std::uint16_t word) noexcept
{
    return detail::to_write(address, word, detail::effect::none);
}
[[nodiscard]] constexpr action to_pause(duration length) noexcept
{
    return detail::with(action{static_cast<std::uint64_t>(action_kind::pause)}, length.microseconds, 32);
}
inline constexpr action to_end{static_cast<std::uint64_t>(action_kind::end)};

/// A write after which a motor at rest may turn, or a turning one may turn differently.
[[nodiscard]] constexpr action to_enable(std::uint16_t address, std::uint16_t word) noexcept
{
    return detail::to_write(address, word, detail::effect::enabling);
}
/// The same for a drive in fault.
[[nodiscard]] constexpr action to_reset(std::uint16_t address, std::uint16_t word) noexcept
{
    return detail::to_write(address, word, detail::effect::resetting);
}
/// A write after which another source may command the motor, or words have another meaning.
[[nodiscard]] constexpr action to_rearrange(std::uint16_t address, std::uint16_t word) noexcept
{
    return detail::to_write(address, word, detail::effect::rearranging);
}
/// A control word that takes the motor's power or its speed away.
[[nodiscard]] constexpr action to_stop(std::uint16_t address, std::uint16_t word) noexcept
{
    return detail::to_write(address, word, detail::effect::stopping);
}
/// The same action, sent once: where no response comes, the procedure gets the failure.
[[nodiscard]] constexpr action once(action what) noexcept { return detail::with(what, 1, 3); }
/// The same read, which fails if it cannot be sent for so long.
[[nodiscard]] constexpr action within(action read, duration length) noexcept
{
    return detail::with(read, length.microseconds, 32);
}
/// The same write, which fails if it cannot be sent before its drive may have lost its power unnoticed.
[[nodiscard]] constexpr action in_presence(action write) noexcept { return detail::with(write, 1, 7); }

/// The pause between two reads of a word that has to change.
inline constexpr duration status_period = milliseconds(50);

/// How long a stop may look what its words mean: the motor keeps turning meanwhile.
inline constexpr duration longest_look_of_a_stop = milliseconds(100);

/// Whether a word of a stop other than 0000 may be sent to a drive that runs by it in an I/O profile. The first word of a stop
/// that its user orders rests on what was read before. Each later one, and each one that withdraws an order, is sent behind a
/// read of CHCF: the drive may have lost its power, and its profile with it, and no response told that.
class stop_look {
public:
    explicit constexpr stop_look(bool is_ordered) noexcept : is_ordered_{is_ordered} {}

    /// A stop is ordered, or an order to run, which a stop may withdraw.
    constexpr void note_order(bool is_stop) noexcept
    {
        is_ordered_ = is_stop;
        has_said_ = false;
        at_ = at_ == stage::under_way ? at_ : stage::none;
    }
    constexpr void begin() noexcept { at_ = stage::under_way; }
    constexpr void give_up() noexcept { at_ = stage::none; }
    constexpr void end(bool is_drive_profile) noexcept { at_ = is_drive_profile ? stage::known : stage::in_vain; }
    constexpr void note_word() noexcept
    {
        has_said_ = true;
        at_ = at_ == stage::known ? stage::none : at_;
    }

    [[nodiscard]] constexpr bool is_under_way() const noexcept { return at_ == stage::under_way; }
    /// Whether a word was sent; whether a look is under way that ends when its time is over, as one before the first word does.
    [[nodiscard]] constexpr bool has_said() const noexcept { return has_said_; }
    [[nodiscard]] constexpr bool is_limited() const noexcept { return is_under_way() and not has_said_; }
    /// Whether CHCF, which was read as the drive profile, has to be read before the next word; `does_no_more`: that does not
    /// count any more.
    [[nodiscard]] constexpr bool is_due(bool does_no_more) const noexcept
    {
        return at_ == stage::none and (does_no_more or not is_first());
    }
    /// Whether the next word may be another one than 0000.
    [[nodiscard]] constexpr bool allows_word(bool counts) const noexcept
    {
        return at_ == stage::known or (counts and is_first());
    }

private:
    enum class stage : std::uint32_t { none, under_way, known, in_vain };

    constexpr bool is_first() const noexcept { return is_ordered_ and not has_said_; }

    stage at_{stage::none};
    detail::in_word<bool> is_ordered_;
    detail::in_word<bool> has_said_{false};
};

/// What a response to a read of CHCF shows: the address of the control word that has its usual meaning, `other_meaning`, or 0.
[[nodiscard]] constexpr std::uint16_t meaning_in(result<response> const& outcome, std::uint16_t control_word) noexcept
{
    constexpr std::size_t size_of_one = 4;
    if (not outcome or outcome->pdu().size() != size_of_one) {
        return 0;
    }
    return is_drive_profile(detail::u16_at(outcome->pdu(), 2)) ? control_word : detail::other_meaning;
}

/// What a state shows of the motor's power.
[[nodiscard]] constexpr detail::power_seen power_in(cia402::state at) noexcept
{
    bool const waits = at == cia402::state::ready_to_switch_on or at == cia402::state::switched_on;
    return waits                    ? detail::power_seen::waits
           : cia402::is_at_rest(at) ? detail::power_seen::off
           : cia402::has_power(at)  ? detail::power_seen::on
                                    : detail::power_seen::nothing;
}

/// What every procedure has: the drive's layout, and the reason why it ended. Each also has an `anew()`, itself as it was
/// made.
class procedure {
public:
    /// How much longer than its limit a procedure may take to leave the drive safe; zero: one more request.
    static constexpr duration grace{};

    [[nodiscard]] constexpr altivar::reason const& reason() const noexcept { return reason_; }

    /// Whether it orders its drive to run; this replaces any earlier order.
    static constexpr bool is_order = false;

    /// Whether all that it does serves an order to move the motor: a later stop by another conversation ends it.
    static constexpr bool follows_order = false;

    /// Whether it is already withdrawing its own command.
    [[nodiscard]] constexpr bool takes_back() const noexcept { return takes_back_; }

    /// Whether it stops its drive by the user's order, and holds the drive until it ends.
    static constexpr bool is_stop = false;

    /// Whether it stops no drive that another conversation ordered to run meanwhile: its stop is against the terminals.
    static constexpr bool gives_way_to_order = false;

    /// Ends a procedure because a stop was ordered later, or an order to run: the drive now belongs to that.
    constexpr action yield() noexcept { return end(outcome_kind::overruled); }

    /// It goes on although it had ended.
    constexpr void forget_end() noexcept
    {
        reason_.kind = outcome_kind::pending;
        reason_.fault = 0;
    }

    /// What the status read showed of the motor's power; what was read of CHCF, as for `commander::note_meaning`; whether the
    /// status showed a fault. Each call clears what it returns.
    constexpr detail::power_seen take_power() noexcept
    {
        return std::exchange(power_seen_, detail::power_seen::nothing);
    }
    constexpr std::uint16_t take_meaning() noexcept { return std::exchange(read_meaning_, std::uint16_t{0}); }
    [[nodiscard]] constexpr std::uint16_t control_word() const noexcept { return layout_->cmd; }
    [[nodiscard]] constexpr std::uint16_t chcf() const noexcept { return layout_->safeguards.chcf; }
    /// Whether CHCF tells whether its words stop it.
    [[nodiscard]] constexpr bool tells_meaning() const noexcept
    {
        return may_have_io_profile(*layout_) and layout_->safeguards.chcf != 0;
    }
    constexpr bool take_fault() noexcept { return take(has_read_fault_); }

    /// Whether the word of a stop may run the drive, which is not known to take the words of all stops as such: 0000 is sent
    /// instead, and the reason says so.
    constexpr bool is_harmful(std::uint16_t word, bool is_known) noexcept
    {
        bool const is_other = word != 0 and not is_known and may_have_io_profile(*layout_);
        reason_.is_other_stop = reason_.is_other_stop or is_other;
        return is_other;
    }

    /// How long the drive keeps running without any request.
    [[nodiscard]] constexpr duration drive_timeout() const noexcept { return layout_->longest_silence; }

    /// Where the drive is known to take the words of all stops as such; told before each step.
    constexpr void note_known(bool is_known) noexcept { is_known_ = is_known; }

    /// Ends a procedure that asks for further actions after its limit.
    constexpr action give_up() noexcept { return end(outcome_kind::aborted); }

    [[nodiscard]] constexpr drive_layout const& layout() const noexcept { return *layout_; }

protected:
    // Of members that are set to 0 as -Weffc++ wants it GCC makes a call of memset: 166 bytes.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"
    explicit constexpr procedure(drive_layout const& layout) noexcept : layout_{&layout} {}
#pragma GCC diagnostic pop

    /// Ends; the first outcome counts.
    [[gnu::noinline]] constexpr action end(outcome_kind kind, errc error = errc::none) noexcept
    {
        if (reason_.kind == outcome_kind::pending) {
            reason_.kind = kind;
            reason_.error = error;
        }
        return to_end;
    }

    /// A response was lost, and it goes on: the error, for an end at its limit.
    constexpr void note_lost(errc error) noexcept { reason_.error = error; }

    /// Ends because a limit of the drive forbids a reference.
    constexpr action end_beyond(outcome_kind found, std::uint16_t limit) noexcept
    {
        note_limit(limit);
        return end(found);
    }
    constexpr void note_limit(std::uint16_t limit) noexcept { reason_.limit = limit; }

    /// Ends because a request failed.
    constexpr action end(errc error) noexcept { return end(kind_for(error), error); }

    /// Whether the motor is known to stand until an order or a reset: not where the drive is "not ready to switch on".
    static constexpr bool stands(cia402::state at) noexcept
    {
        return cia402::is_at_rest(at) and at != cia402::state::not_ready_to_switch_on;
    }

    /// Ends because the motor is not known to stand: it runs, or the state that was read does not tell.
    constexpr action end_running() noexcept
    {
        return end(cia402::has_power(reason_.state) ? outcome_kind::refused_while_running : outcome_kind::aborted);
    }

    static constexpr outcome_kind kind_for(errc error) noexcept
    {
        if (error == errc::too_many_ordered) {
            return outcome_kind::no_place;
        }
        return is_exception(error) ? outcome_kind::refused : outcome_kind::silent;
    }

    /// Reads the status word and its neighbour, RFR behind it or LFT before it: no late answer to a read of one register is
    /// taken for them. Of a drive whose registers stand apart, the status word alone.
    [[nodiscard]] constexpr action look() const noexcept
    {
        std::uint16_t const from = has_fault_before() ? layout_->lft : layout_->eta;
        bool const are_two = has_fault_before() or has_frequency_behind();
        return detail::with(to_read(from), are_two ? 1 : 0, 2);
    }
    [[nodiscard]] constexpr bool has_frequency_behind() const noexcept { return layout_->rfr == layout_->eta + 1; }
    [[nodiscard]] constexpr bool has_fault_before() const noexcept { return layout_->lft + 1 == layout_->eta; }
    [[nodiscard]] constexpr std::uint16_t status_in(event what) const noexcept
    {
        return has_fault_before() ? what.second() : what.word();
    }

    /// Keeps the state that a status word shows.
    constexpr cia402::state note(std::uint16_t status) noexcept
    {
        reason_.state = cia402::decode(status);
        power_seen_ = power_in(reason_.state);
        has_read_fault_ = cia402::is_in_fault(reason_.state);
        return reason_.state;
    }

    /// Whether the drive is known to take the words of all stops as such.
    [[nodiscard]] constexpr bool is_known() const noexcept { return is_known_; }
    constexpr void note_state(cia402::state at) noexcept { reason_.state = at; }
    constexpr void note_taking_back() noexcept { takes_back_ = true; }

    /// Takes over what a procedure inside this one has read.
    constexpr void note_readings_of(procedure& inner) noexcept
    {
        power_seen_ = inner.take_power();
        has_read_fault_ = inner.take_fault();
        read_meaning_ = inner.take_meaning();
    }
    constexpr void note_other_stop() noexcept { reason_.is_other_stop = true; }
    constexpr void note_meaning(std::uint16_t control_word) noexcept { read_meaning_ = control_word; }

    /// Runs the next step of a procedure inside this one, and takes over what it reads.
    template <typename Inner> constexpr action follow(Inner& inner, event what) noexcept
    {
        action const next = inner.step(what);
        note_readings_of(inner);
        if (what_of(next) == action_kind::end) {
            note_state(inner.reason().state);
        }
        return next;
    }

    /// The same. If the inner one fails, this one ends with the same outcome: the caller continues only after a success.
    template <typename Inner> constexpr action run_inside(Inner& inner, event what) noexcept
    {
        action const next = follow(inner, what);
        bool const goes_on = what_of(next) != action_kind::end or inner.reason().kind == outcome_kind::succeeded;
        return goes_on ? next : end_as(inner.reason());
    }

    /// Ends as another procedure did.
    constexpr action end_as(altivar::reason const& found) noexcept
    {
        return found.kind == outcome_kind::in_fault ? end_in_fault(found.fault) : end(found.kind, found.error);
    }

    constexpr action end_in_fault(std::uint16_t code) noexcept
    {
        reason_.fault = code;
        return end(outcome_kind::in_fault);
    }

private:
    static constexpr bool take(bool& mark) noexcept
    {
        bool const is_set = mark;
        mark = false;
        return is_set;
    }

    drive_layout const* layout_;
    altivar::reason reason_;
    detail::power_seen power_seen_{detail::power_seen::nothing};
    bool has_read_fault_{false};
    std::uint16_t read_meaning_{0};
    bool takes_back_{false};
    bool is_known_{false};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
