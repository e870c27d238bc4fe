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

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/procedure/commissioning/last_look.hpp>
#include <rtuwire/altivar/procedure/inspection/at_rest.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/setting.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

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
    static constexpr safeguard_layout const& at = drive_check<Device>::layout.safeguards;
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

    /// No channel to set yet.
    constexpr channel_settings() noexcept = default;

    /// The same with CHCF, CD1, FR1 or FLO set to `value`.
    template <auto const& R> [[nodiscard]] constexpr channel_settings with(setting<R> value) const noexcept
    {
        static_assert(detail::has_register<Device, R>, "this device has no such register");
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
/// | stage           | word read                         | confirmed | no response | refused       | limit over   |
/// |-----------------|-----------------------------------|-----------|-------------|---------------|--------------|
/// | comparing       | the next; after the last: looking |           | end: silent | end: refused  | end: aborted |
/// | comparing again | the next; after the last: wait    |           | end: silent | end: refused  | end: aborted |
/// |                 | if wrong end: not_taken           |           |             |               |              |
/// | looking         | the check, write CMD or set one   |           | end: silent | as in a check | end: aborted |
/// | clearing        |                                   | set one   | end: silent | end: refused  | end: aborted |
/// | setting         |                                   | read it   | end: silent | end: refused  | end: aborted |
/// | reading_back    | looking; at last: compare again   |           | end: silent | end: refused  | end: aborted |
/// |                 | if wrong end: not_taken           |           |             |               |              |
///
/// Once a setting was sent, each "end" is a `last_look` (closing) that writes 0000 to a motor that runs, and then ends
/// so; a wait ends with one, too, and then with `succeeded`. CMD is written 0000 once before the first setting. Where no
/// setting is wrong, the first comparison ends as `succeeded`. Exception 02 to a comparison is `unknown_register`.
/// Internal.
class channel_procedure : public procedure {
public:
    /// The time to look once more at a drive whose terminals may have started its motor.
    static constexpr duration grace{milliseconds(3'000)};
    static constexpr bool gives_way_to_order = true;

    constexpr channel_procedure(drive_layout const& layout, channel_words const& wanted,
                                terminal_options const& options) noexcept
        : procedure{layout}, wanted_{wanted}, options_{options}, look_{layout, options}, last_{layout, 0}
    {}

    [[nodiscard]] constexpr channel_procedure anew() const noexcept { return {layout(), wanted_, options_}; }

    constexpr action step(event what) noexcept
    {
        if (stage_ == stage::closing) {
            return see(what);
        }
        if (stage_ == stage::looking) {
            return check_rest(what);
        }
        switch (what.what()) {
        case event::kind::begun: return compare_next(0);
        case event::kind::word_read: return on_response(what.word());
        case event::kind::written: return after_write();
        case event::kind::pause_over: return close({outcome_kind::succeeded});
        case event::kind::failed: return go_without(what.error());
        case event::kind::late: break;
        }
        return close({outcome_kind::aborted});
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
        waiting,
        closing, ///< the last look
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
        word_ = 0;
        stage_ = stage::waiting;
        return to_pause(status_period);
    }

    constexpr action check_rest(event what) noexcept
    {
        action const next = follow(look_, what);
        if (look_.reason().kind == outcome_kind::succeeded) {
            // A control word left from before would take effect once Modbus commands.
            stage_ = is_cleared_ ? stage::setting : stage::clearing;
            return is_cleared_ ? write_setting() : to_rearrange(layout().cmd, 0);
        }
        if (what_of(next) != action_kind::end) {
            return next;
        }
        address_ = look_.address();
        word_ = look_.word();
        return close(look_.reason());
    }

    constexpr action write_setting() noexcept
    {
        address_ = wanted_[at_].address;
        word_ = 0;
        is_given_ = true;
        return to_rearrange(address_, wanted_[at_].word);
    }

    constexpr action after_write() noexcept
    {
        if (stage_ == stage::clearing) {
            is_cleared_ = true;
            stage_ = stage::setting;
            return write_setting();
        }
        ++written_;
        stage_ = stage::reading_back;
        return read_setting();
    }

    constexpr action on_response(std::uint16_t word) noexcept
    {
        word_ = word;
        if (stage_ == stage::comparing) {
            return compare(word);
        }
        return word == wanted_[at_].word ? set_next(at_ + 1) : close({outcome_kind::not_taken});
    }

    constexpr action compare(std::uint16_t word) noexcept
    {
        bool const is_right = word == wanted_[at_].word;
        if (is_set_ and not is_right) {
            return close({outcome_kind::not_taken});
        }
        is_wrong_ |= is_right ? 0U : 1U << at_;
        return compare_next(at_ + 1);
    }

    constexpr action go_without(errc error) noexcept
    {
        bool const is_missing = error == errc::illegal_data_address and stage_ == stage::comparing;
        return close({is_missing ? outcome_kind::unknown_register : kind_for(error), error});
    }

    /// Ends, but once a setting was sent not without a last look. A motor that the check found running, and that stood
    /// at the check before, needs no other look.
    constexpr action close(altivar::reason const& so) noexcept
    {
        if (not is_given_) {
            return end_as(so);
        }
        stage_ = stage::closing;
        note_taking_back();
        return so.kind == outcome_kind::refused_while_running ? last_.begin_cut(reason().state)
                                                              : last_.begin(so, reason().state);
    }

    constexpr action see(event what) noexcept
    {
        action const next = follow(last_, what);
        if (what_of(next) != action_kind::end) {
            return next;
        }
        if (last_.reason().kind == outcome_kind::started_by_terminals) {
            address_ = layout().eta;
            word_ = last_.status() != 0 ? last_.status() : word_; // else it is that of the check
        }
        return end_as(last_.reason());
    }

    channel_words wanted_;
    terminal_options options_;
    at_rest_procedure look_;
    last_look last_;
    std::size_t at_{0};
    unsigned is_wrong_{0}; ///< settings to be written, a bit each
    unsigned written_{0};
    std::uint16_t address_{0};
    std::uint16_t word_{0};
    stage stage_{stage::comparing};
    bool is_cleared_{false};
    bool is_set_{false};   ///< each was written and read back once
    bool is_given_{false}; ///< a setting was sent, confirmed or not
};

/// Sets the channels of a drive in states 2, 3 or 4. Done where each setting reads back as requested, and the drive
/// stands after the last; `not_taken` where one does not, `run_input_closed` and `refused_while_running` with nothing
/// more set, `unknown_register` where a setting or the inputs cannot be read. `address()` names the register, and
/// `word()` its value.
///
/// What cannot be read: the inputs of an ATV310, a command of the keypad, and an input that is closed between the check
/// and the write. A motor that runs after a write is sent 0000 once and reported as `started_by_terminals`: stop it
/// where it was started. It looks for that at every end after the first write, up to 3 s after its limit; where that
/// look fails, 0000 is sent, too. Nothing is saved; `save_to_eeprom` does that.
class set_channel : public procedure_runner<channel_procedure> {
public:
    /// Sets what is wanted on this drive; it ends after `limit` at the latest, but for the last look.
    template <device_type Device>
    constexpr set_channel(station<Device> const& its_drive, channel_settings<Device> const& wanted,
                          terminal_options const& its_options = {}, duration its_limit = milliseconds(10'000)) noexcept
        : procedure_runner{its_drive.unit(), its_limit, drive_check<Device>::layout, wanted.words(), its_options}
    {}

    /// The register that the outcome is about; 0 for none.
    [[nodiscard]] constexpr std::uint16_t address() const noexcept { return told().address(); }
    /// Its value; 0 where it was not read.
    [[nodiscard]] constexpr std::uint16_t word() const noexcept { return told().word(); }
    /// How many settings were written.
    [[nodiscard]] constexpr unsigned written() const noexcept { return told().written(); }
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
