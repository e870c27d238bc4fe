// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Sets the sources of a drive's command and reference, and reads the settings back. Each of these writes may give the
// motor to the terminals, so each is sent only to a drive that was just read to be at rest, with its run inputs open
// and its control word 0000.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/procedure/inspection/at_rest.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/setting.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// One setting of a channel; an address of 0 leaves it as it is.
/// Internal.
struct channel_word {
    std::uint16_t address{0};
    std::uint16_t word{0};
};

/// Written in this order, a drive is never between two writes in a channel that is neither the old nor the new one:
/// FR1 and CD1 before CHCF, which defines their meaning, and the input that forces local control last.
/// Internal.
using channel_words = std::array<channel_word, 4>;

/// The channels that a drive shall have; a setting that is not named stays as it is.
template <device_type Device> class channel_settings {
    static constexpr safeguard_layout const& at = Device::layout.safeguards;
    static constexpr std::array order{at.fr1, at.cd1, at.chcf, at.flo};

    template <auto const& R> static constexpr std::size_t place_of() noexcept
    {
        std::size_t place = 0;
        while (place < order.size() and order[place] != R.address) {
            ++place;
        }
        return place;
    }

public:
    static_assert(at.chcf != 0, "this device has no channel to set");

    constexpr channel_settings() noexcept = default;

    /// The same with CHCF, CD1, FR1 or FLO set to `value`.
    template <auto const& R> [[nodiscard]] constexpr channel_settings with(setting<R> value) const noexcept
    {
        static_assert(has_register<Device, R>, "this device has no such register");
        static_assert(place_of<R>() < order.size(), "this register chooses no channel");
        channel_settings next = *this;
        next.words_[place_of<R>()] = {R.address, value.word()};
        return next;
    }

    /// Command and reference together over Modbus, and no input that forces local control.
    [[nodiscard]] static constexpr channel_settings by_modbus() noexcept
    {
        channel_settings all;
        all.words_ = {{{at.fr1, 164}, {at.cd1, 10}, {at.chcf, 1}, {at.flo, 0}}};
        return all;
    }

    [[nodiscard]] constexpr channel_words const& words() const noexcept { return words_; }

private:
    channel_words words_{};
};

/// Decides the set-up, word by word: reads all settings before it writes one, checks the drive before each write,
/// reads each setting back, reads all of them again after the last, and reads the drive's status once more.
///
/// | stage           | word read                         | confirmed    | no response  | refused       | limit over   |
/// |-----------------|-----------------------------------|--------------|--------------|---------------|--------------|
/// | comparing       | the next; after the last: looking |              | end: silent  | end: refused  | end: aborted |
/// | comparing again | the next; after the last: wait    |              | end: silent  | end: refused  | end: aborted |
/// |                 | if wrong end: not_taken           |              |              |               |              |
/// | looking         | the check, write CMD or set one   |              | end: silent  | as in a check | end: aborted |
/// | clearing        |                                   | set one      | end: silent  | end: refused  | end: aborted |
/// | setting         |                                   | read it      | end: silent  | end: refused  | end: aborted |
/// | reading_back    | looking; at last: compare again   |              | end: silent  | end: refused  | end: aborted |
/// |                 | if wrong end: not_taken           |              |              |               |              |
/// | confirming      | 7, 8: read LFT                    |              | end: silent  | end: refused  | end: aborted |
/// |                 | 5, 6: write CMD                   |              |              |               |              |
/// |                 | other: end: succeeded             |              |              |               |              |
/// | reading_fault   | end: in_fault                     |              | end: silent  | end: refused  | end: aborted |
/// | taking_back     |                                   | end: started | end: started | end: started  | end: aborted |
///
/// CMD is written 0000: once before the first setting, and to a motor that runs; "started" is `started_by_terminals`.
/// Where no setting is wrong, the first comparison ends as `succeeded`. Exception 02 to a comparison is
/// `unknown_register`. A wait ends with the read of ETA.
/// Internal.
class channel_procedure : public procedure {
public:
    constexpr channel_procedure(drive_layout const& layout, channel_words const& wanted,
                                terminal_options const& options) noexcept
        : procedure{layout}, wanted_{wanted}, options_{options}, look_{layout, options}
    {}

    constexpr action step(event const& what) noexcept
    {
        if (stage_ == stage::looking and what.what != event::kind::late) {
            return check_rest(what);
        }
        switch (what.what) {
        case event::kind::begun: return compare_next(0);
        case event::kind::word_read: return on_response(what.word);
        case event::kind::written: return after_write();
        case event::kind::pause_over: return to_read(layout().eta);
        case event::kind::failed: return go_without(what.error);
        case event::kind::late: break;
        }
        return end(outcome_kind::aborted, errc::timed_out);
    }

    /// The register that the outcome is about, and its value.
    [[nodiscard]] constexpr std::uint16_t address() const noexcept { return address_; }
    [[nodiscard]] constexpr std::uint16_t word() const noexcept { return word_; }

    /// How many settings were written; those that were already right are not written.
    [[nodiscard]] constexpr unsigned written() const noexcept { return written_; }

private:
    enum class stage : std::uint8_t {
        comparing,
        looking,
        clearing, ///< the control word
        setting,
        reading_back,
        confirming, ///< that the drive still stands
        reading_fault,
        taking_back, ///< a motor runs: its command is withdrawn
    };

    constexpr action compare_next(std::size_t from) noexcept
    {
        stage_ = stage::comparing;
        at_ = from;
        while (at_ < wanted_.size() and wanted_[at_].address == 0) {
            ++at_;
        }
        return at_ < wanted_.size() ? read_setting() : is_set_ ? confirm_later() : set_next(0);
    }

    constexpr action read_setting() noexcept
    {
        address_ = wanted_[at_].address;
        word_ = 0;
        return to_read(address_);
    }

    constexpr action set_next(std::size_t from) noexcept
    {
        at_ = from;
        while (at_ < wanted_.size() and ((is_wrong_ >> at_) & 1U) == 0) {
            ++at_;
        }
        if (at_ < wanted_.size()) {
            stage_ = stage::looking;
            look_ = at_rest_procedure{layout(), options_};
            return check_rest({event::kind::begun});
        }
        if (written_ == 0) {
            address_ = 0;
            return end(outcome_kind::succeeded);
        }
        is_set_ = true;
        return compare_next(0); // read all again: a drive that lost its power meanwhile has lost the settings
    }

    constexpr action confirm_later() noexcept
    {
        address_ = 0;
        stage_ = stage::confirming;
        return to_pause(status_period);
    }

    constexpr action check_rest(event const& what) noexcept
    {
        action const next = run_inside(look_, what);
        if (look_.reason().kind == outcome_kind::succeeded) {
            // A control word left from before would take effect once Modbus commands.
            stage_ = is_cleared_ ? stage::setting : stage::clearing;
            return is_cleared_ ? write_setting() : to_rearrange(layout().cmd, 0);
        }
        if (next.what == action::kind::end) {
            address_ = look_.address();
            word_ = look_.word();
        }
        return next;
    }

    constexpr action write_setting() noexcept
    {
        address_ = wanted_[at_].address;
        word_ = 0;
        return to_rearrange(address_, wanted_[at_].word);
    }

    constexpr action after_write() noexcept
    {
        if (stage_ == stage::clearing) {
            is_cleared_ = true;
            stage_ = stage::setting;
            return write_setting();
        }
        if (stage_ == stage::taking_back) {
            return end(outcome_kind::started_by_terminals);
        }
        ++written_;
        stage_ = stage::reading_back;
        return read_setting();
    }

    constexpr action on_response(std::uint16_t word) noexcept
    {
        word_ = word;
        switch (stage_) {
        case stage::comparing: return compare(word);
        case stage::reading_back: return word == wanted_[at_].word ? set_next(at_ + 1) : end(outcome_kind::not_taken);
        case stage::reading_fault: return end_in_fault(word);
        case stage::looking:
        case stage::clearing:
        case stage::setting:
        case stage::confirming:
        case stage::taking_back: break;
        }
        return confirm(note(word));
    }

    constexpr action compare(std::uint16_t word) noexcept
    {
        bool const is_right = word == wanted_[at_].word;
        if (is_set_ and not is_right) {
            return end(outcome_kind::not_taken);
        }
        is_wrong_ |= is_right ? 0U : 1U << at_;
        return compare_next(at_ + 1);
    }

    constexpr action confirm(cia402::state at) noexcept
    {
        if (cia402::is_in_fault(at)) {
            stage_ = stage::reading_fault;
            return to_read(layout().lft);
        }
        if (cia402::has_power(at)) {
            address_ = layout().eta;
            // The line may no longer command it, but without sending this is not known.
            stage_ = stage::taking_back;
            return to_stop(layout().cmd, 0);
        }
        return end(outcome_kind::succeeded);
    }

    constexpr action go_without(errc error) noexcept
    {
        if (stage_ == stage::taking_back) {
            return end(outcome_kind::started_by_terminals, error);
        }
        bool const is_missing = error == errc::illegal_data_address;
        return is_missing and stage_ == stage::comparing ? end(outcome_kind::unknown_register, error) : end(error);
    }

    channel_words wanted_;
    terminal_options options_;
    at_rest_procedure look_;
    std::size_t at_{0};
    unsigned is_wrong_{0}; ///< settings to be written, a bit each
    unsigned written_{0};
    std::uint16_t address_{0};
    std::uint16_t word_{0};
    stage stage_{stage::comparing};
    bool is_cleared_{false};
    bool is_set_{false}; ///< each was written and read back once
};

/// Sets the channels of a drive in states 2, 3 or 4. Done where each setting reads back as requested, and the drive
/// stands after the last; `not_taken` where one does not, `run_input_closed` and `refused_while_running` with nothing
/// more written, `unknown_register` where a setting or the inputs cannot be read. `address()` names the register, and
/// `word()` its value.
///
/// What cannot be read: the inputs of an ATV310, a command of the keypad, and an input that is closed between the check
/// and the write. A motor that runs after a write is sent 0000 once and reported as `started_by_terminals`: stop it
/// where it was started. Nothing is saved; `save_to_eeprom` does that.
class set_channel : public procedure_runner<channel_procedure> {
public:
    template <device_type Device>
    constexpr set_channel(station<Device> const& drive, channel_settings<Device> const& wanted,
                          terminal_options const& options = {}, duration limit = milliseconds(10'000)) noexcept
        : procedure_runner{drive.unit(), channel_procedure{Device::layout, wanted.words(), options}, limit}
    {}

    /// The register that the outcome is about; 0 for none.
    [[nodiscard]] constexpr std::uint16_t address() const noexcept { return told().address(); }
    /// Its value; 0 where it was not read.
    [[nodiscard]] constexpr std::uint16_t word() const noexcept { return told().word(); }
    /// How many settings were written.
    [[nodiscard]] constexpr unsigned written() const noexcept { return told().written(); }
};

} // namespace rtuwire::altivar
