// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A script decides, `drive_talk` acts: what happened goes in as an event, what to do next comes out as
// a wish. So each start, stop or reset is a small function of words, without frames and clocks.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/profile.hpp>
#include <rtuwire/altivar/reason.hpp>
#include <rtuwire/client/commander.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// What happened.
struct event {
    enum class kind : std::uint8_t {
        begun,
        word_read,  ///< `word` is what was read
        written,    ///< the drive confirmed the write
        failed,     ///< `error` tells why a read or write was not
        pause_over, ///< the pause that was wished for
        late,       ///< the time limit; one more wish is granted
    };
    kind what;
    std::uint16_t word{0};
    errc error{errc::none};
};

/// What to do next.
struct wish {
    enum class kind : std::uint8_t { read, write, pause, end };
    kind what;
    std::uint16_t address{0};
    std::uint16_t word{0};
    duration length{}; ///< of a pause; or after it a question fails that could not be asked, where it is not zero
    repetition again{repetition::allowed};
    effect does{effect::none}; ///< to a motor
};

[[nodiscard]] constexpr wish to_read(std::uint16_t address) noexcept
{
    return {wish::kind::read, address};
}
[[nodiscard]] constexpr wish to_write(std::uint16_t address, std::uint16_t word) noexcept
{
    return {wish::kind::write, address, word};
}
[[nodiscard]] constexpr wish to_pause(duration length) noexcept
{
    return {wish::kind::pause, 0, 0, length};
}
/// A write after which the motor may turn that did not, or turn otherwise.
[[nodiscard]] constexpr wish to_enable(std::uint16_t address, std::uint16_t word) noexcept
{
    wish what = to_write(address, word);
    what.does = effect::enabling;
    return what;
}
/// The same in a fault.
[[nodiscard]] constexpr wish to_reset(std::uint16_t address, std::uint16_t word) noexcept
{
    wish what = to_write(address, word);
    what.does = effect::resetting;
    return what;
}
/// A write after which something else may command the motor, or words mean something else.
[[nodiscard]] constexpr wish to_rearrange(std::uint16_t address, std::uint16_t word) noexcept
{
    wish what = to_write(address, word);
    what.does = effect::rearranging;
    return what;
}
/// A control word that takes the motor's power or its speed away.
[[nodiscard]] constexpr wish to_stop(std::uint16_t address, std::uint16_t word) noexcept
{
    wish what = to_write(address, word);
    what.does = effect::stopping;
    return what;
}
/// The same wish, asked once: where no answer comes, the script hears of it.
[[nodiscard]] constexpr wish once(wish what) noexcept
{
    what.again = repetition::never;
    return what;
}

/// Between two looks at a word that has to change.
inline constexpr duration look_period = milliseconds(50);

/// What every script has: the drive's profile, and why it ended.
class script {
public:
    /// How much longer than its limit a script may take to leave the drive safe; without any, one question.
    static constexpr duration grace{};

    [[nodiscard]] constexpr altivar::reason const& reason() const noexcept { return reason_; }

    /// Whether it orders its drive to run, in the place of any order before.
    static constexpr bool is_order = false;

    /// Whether it takes back already what it gave.
    [[nodiscard]] static constexpr bool takes_back() noexcept { return false; }

    /// Whether it stops its drive because the user said so, and holds it until it ends.
    static constexpr bool is_stop = false;

    /// Ends a script because of a stop that somebody ordered later: the drive is that one's.
    constexpr wish yield() noexcept { return end(ending::overruled); }

    /// Whether the drive was read to be without power, and whether in fault; told once for each time.
    constexpr bool take_rest() noexcept { return take(has_read_rest_); }
    constexpr bool take_fault() noexcept { return take(has_read_fault_); }

    /// How long the drive goes on without any request.
    [[nodiscard]] constexpr duration drive_timeout() const noexcept { return profile_->longest_silence; }

    /// Ends a script that wishes on after its limit.
    constexpr wish give_up() noexcept { return end(ending::stuck); }

protected:
    explicit constexpr script(drive_profile const& profile) noexcept : profile_{&profile} {}

    [[nodiscard]] constexpr drive_profile const& profile() const noexcept { return *profile_; }

    /// Ends; the first ending counts.
    constexpr wish end(ending how, errc error = errc::none) noexcept
    {
        if (reason_.how == ending::pending) {
            reason_.how = how;
            reason_.error = error;
        }
        return {wish::kind::end};
    }

    /// Ends because a question failed.
    constexpr wish end(errc error) noexcept { return end(ending_for(error), error); }

    static constexpr ending ending_for(errc error) noexcept
    {
        if (error == errc::too_many_ordered) {
            return ending::no_place;
        }
        return is_exception(error) ? ending::refused : ending::silent;
    }

    /// Keeps the state that a status word tells.
    constexpr cia402::state note(std::uint16_t status) noexcept
    {
        reason_.state = cia402::decode(status);
        has_read_rest_ = cia402::is_at_rest(reason_.state);
        has_read_fault_ = cia402::is_in_fault(reason_.state);
        return reason_.state;
    }

    constexpr void note_state(cia402::state at) noexcept { reason_.state = at; }

    /// What a script inside this one has read counts for this one.
    constexpr void note_readings_of(script& inner) noexcept
    {
        has_read_rest_ = inner.take_rest();
        has_read_fault_ = inner.take_fault();
    }
    constexpr void note_other_stop() noexcept { reason_.is_other_stop = true; }

    /// Goes on with a script inside this one; what it reads counts for this one. Where it ends without success this one
    /// ends so, too: the caller goes on only behind one that succeeded.
    template <typename Inner> constexpr wish run_inside(Inner& inner, event const& what) noexcept
    {
        wish const next = inner.step(what);
        note_readings_of(inner);
        if (next.what != wish::kind::end) {
            return next;
        }
        altivar::reason const found = inner.reason();
        note_state(found.state);
        if (found.how == ending::succeeded) {
            return next;
        }
        return found.how == ending::in_fault ? end_in_fault(found.fault) : end(found.how, found.error);
    }

    constexpr wish end_in_fault(std::uint16_t code) noexcept
    {
        reason_.fault = code;
        return end(ending::in_fault);
    }

private:
    static constexpr bool take(bool& mark) noexcept
    {
        bool const is_set = mark;
        mark = false;
        return is_set;
    }

    drive_profile const* profile_;
    altivar::reason reason_{};
    bool has_read_rest_{false};
    bool has_read_fault_{false};
};

} // namespace rtuwire::altivar
