// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Starts a drive: read ETA, write CMD, and again until operation is enabled. The reference goes before
// the command that enables, so that the motor never turns at an older one. A drive that falls back on
// the way, say because somebody pressed STOP, is not pushed up again.
#pragma once

#include <cstdint>
#include <type_traits>

#include <rtuwire/altivar/drive_talk.hpp>
#include <rtuwire/altivar/reference.hpp>
#include <rtuwire/cia402/way.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Decides a start, word by word.
class start_script : public script {
public:
    constexpr start_script(drive_profile const& profile, reference_write reference,
                           heading way) noexcept
        : script{profile}, reference_{reference}, extra_bits_{way == heading::reverse
                                                                  ? reverse_bit
                                                                  : std::uint16_t{0}}
    {}

    constexpr wish step(event const& what) noexcept
    {
        switch (what.what) {
        case event::kind::begun:
        case event::kind::pause_over: return to_read(profile().eta);
        case event::kind::word_read:
            return stage_ == stage::reading_fault ? end_in_fault(what.word) : look(what.word);
        case event::kind::written: return after_write();
        case event::kind::failed:
            return withdraw(is_exception(what.error) ? ending::refused : ending::silent,
                            what.error);
        case event::kind::late: break;
        }
        return withdraw(ending::stuck);
    }

private:
    enum class stage : std::uint8_t { climbing, referring, enabled, reading_fault, withdrawing };

    constexpr wish look(std::uint16_t status) noexcept
    {
        cia402::state const at = note(status);
        if (cia402::is_in_fault(at)) {
            stage_ = stage::reading_fault;
            return to_read(profile().lft);
        }
        if ((status & remote_bit) == 0) {
            return withdraw(ending::local_control);
        }
        int const height = cia402::height_of(at);
        if (has_commanded_ and height < height_) {
            return withdraw(ending::stuck);
        }
        height_ = height;
        if (at == cia402::state::operation_enabled) {
            return run(status);
        }
        return climb(at);
    }

    constexpr wish climb(cia402::state at) noexcept
    {
        cia402::command const next = cia402::toward_running(at);
        if (next == cia402::command::none or next == given_) {
            return to_pause(look_period);
        }
        if (next == cia402::command::enable_operation) {
            return refer();
        }
        return give(next);
    }

    constexpr wish refer() noexcept
    {
        stage_ = stage::referring;
        return to_write(reference_.address, reference_.word);
    }

    constexpr wish give(cia402::command next) noexcept
    {
        given_ = next;
        has_commanded_ = true;
        return to_write(profile().cmd,
                        static_cast<std::uint16_t>(cia402::word_of(next) | extra_bits_));
    }

    /// In operation: with our reference, or before it where the drive was running already.
    constexpr wish run(std::uint16_t status) noexcept
    {
        if (stage_ != stage::enabled) {
            return refer();
        }
        return end((status & reference_limited_bit) != 0 ? ending::reference_limited
                                                         : ending::succeeded);
    }

    constexpr wish after_write() noexcept
    {
        if (stage_ == stage::withdrawing) {
            return end(ending::stuck);
        }
        if (stage_ == stage::referring) {
            stage_ = stage::enabled;
            return give(cia402::command::enable_operation);
        }
        return to_read(profile().eta);
    }

    /// Ends, but takes back a command to run that the drive may hold.
    constexpr wish withdraw(ending how, errc error = errc::none) noexcept
    {
        wish const over = end(how, error);
        if (given_ != cia402::command::enable_operation or stage_ == stage::withdrawing) {
            return over;
        }
        stage_ = stage::withdrawing;
        return to_write(profile().cmd, cia402::word_of(cia402::command::shutdown));
    }

    reference_write reference_;
    std::uint16_t extra_bits_;
    int height_{0};
    stage stage_{stage::climbing};
    cia402::command given_{cia402::command::none};
    bool has_commanded_{false};
};

/// Starts a drive at a reference. `station`, then 1500_rpm or 50_Hz, then the direction. It settles once
/// operation is enabled, without waiting for the ramp.
class start : public drive_talk<start_script> {
public:
    template <device_type Device>
    constexpr start(station<Device> const& drive, std::type_identity_t<reference<Device>> const& at,
                    heading way = heading::forward, duration limit = milliseconds(3'000)) noexcept
        : drive_talk{drive.unit(), start_script{Device::profile, at.write(), way}, limit}
    {}

    /// Whether the motor runs as asked, or at the limit nearest to it.
    [[nodiscard]] constexpr bool running() const noexcept
    {
        return succeeded() or reason().how == ending::reference_limited;
    }
};

} // namespace rtuwire::altivar
