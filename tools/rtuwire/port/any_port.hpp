// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A port of whichever kind: a serial device, RTU over TCP, Modbus TCP, simulated drives. A `blocking_client`, `pump`, `serve_once` and
// `receive_from` take it as they take a `host_serial`.
#pragma once

#include <string>
#include <variant>

#include <rtuwire/frames.hpp>
#include <rtuwire/port.hpp>

#include "port/port_word.hpp"
#include "port/simulated_drives.hpp"
#include "words/option_words.hpp"

namespace tool {

/// What a program does while a port waits for bytes.
class port_attendant {
public:
    port_attendant() = default;
    port_attendant(port_attendant const&) = delete;
    port_attendant& operator=(port_attendant const&) = delete;
    virtual ~port_attendant() = default;

    /// Returns once the descriptor can be read, or the deadline has passed.
    virtual void wait(int descriptor, rtuwire::instant until) = 0;
    /// Whether nothing is to be waited for any more, and nothing sent.
    [[nodiscard]] virtual bool is_over() const = 0;
    /// Whether a frame may leave now.
    [[nodiscard]] virtual bool may_send() const { return true; }
};

/// A port. Can be moved; its destructor closes it, and ends the drives that were simulated for it.
class any_port {
public:
    /// Opens what was described; what was open before is closed. The settings are of a serial device. A serial device
    /// server has its own; they tell how long the silence on its wire has to be. Simulated drives have none. On an error nothing is open and `failure()` says why:
    /// those of `host_serial::open`, of `tcp_stream::open` and of `mbap_stream::open`; `device_not_serial` for a capture file.
    rtuwire::result<void> open(port_description const& described, rtuwire::serial_settings const& settings = {});

    void close() noexcept;

    [[nodiscard]] bool is_open() const noexcept;

    /// Whether what answers here is simulated.
    [[nodiscard]] bool is_simulated() const noexcept { return drives_.is_running(); }

    /// Whether it is a connection, which opens wherever somebody listens: what answers there is known by its answers alone.
    [[nodiscard]] bool is_connection() const noexcept
    {
        return not is_simulated() and not std::holds_alternative<rtuwire::host_serial>(port_);
    }

    /// Whether it is known that nobody has an address here: on a line of simulated drives.
    [[nodiscard]] bool is_absent(std::uint8_t unit) const noexcept;

    /// Whether responses come by the number of their request, as of Modbus TCP: nobody else is heard there, and none is late.
    [[nodiscard]] bool has_numbers() const noexcept { return timing_.has_numbers(); }

    /// Wants this silence before each request, where it is longer than the port's own.
    void keep_pause(rtuwire::duration silence) noexcept;

    /// The times that suit the port: of a wire with these settings, behind a USB adapter or not, or of none; with the pause
    /// that was wanted since it was opened.
    [[nodiscard]] rtuwire::line_timing timing() const noexcept { return timing_; }

    /// From here on it waits by this one, which outlives it. Once that is over, reads and writes end with `cancelled`;
    /// so does a write that it does not let leave.
    void attend(port_attendant& attendant) noexcept { attendant_ = &attendant; }

    /// The system's number of it, for `poll`; -1 where none is open.
    [[nodiscard]] int descriptor_number() const noexcept;

    /// A frame as it goes to the system's number, for what writes there itself. `place` has 260 bytes.
    [[nodiscard]] rtuwire::byte_view as_sent(rtuwire::byte_view frame, rtuwire::byte_span place) const noexcept;

    /// The part of a frame that passes here: over Modbus TCP all but its CRC, which is made up.
    [[nodiscard]] rtuwire::byte_view passed(rtuwire::byte_view frame) const noexcept
    {
        return frame.first(frame.size() - (has_numbers() and frame.size() >= rtuwire::min_adu_size ? 2U : 0U));
    }

    /// Its name: a device, "host:4001".
    [[nodiscard]] std::string const& device() const noexcept;

    /// The last failure in words, beginning with the port's name; empty before the first.
    [[nodiscard]] std::string const& failure() const noexcept;

    /// What there is to say of it where a unit did not answer in time: that responses came too late, or of another unit, or
    /// that another protocol may be meant, or which units a simulated line has. Begins with a mark; empty where there is nothing.
    [[nodiscard]] std::string words_of_silence(option_form form = option_form::typed) const;

    /// Sends all bytes. Errors: `transmit_stalled`, `device_not_open`, `device_vanished`, `device_failed`; over
    /// Modbus TCP those of `check_frame`, where it is no frame.
    rtuwire::result<void> write(rtuwire::byte_view bytes, rtuwire::instant until);

    /// Whether the last write was taken whole, and nothing had told before that the other end is gone: a connection takes what
    /// goes nowhere.
    [[nodiscard]] bool has_taken_last() const noexcept { return has_taken_last_; }

    /// Waits for at least one byte until the deadline and reads what is there; empty when there was none. Errors:
    /// `device_not_open`, `device_vanished`, `device_failed`.
    rtuwire::result<rtuwire::byte_span> read(rtuwire::byte_span place, rtuwire::instant until);

    /// Whether a byte arrived damaged right behind the bytes read last; reported once. TCP does not tell.
    [[nodiscard]] bool take_receive_error() noexcept;

    /// How many bytes have come since it was opened, damaged ones as well, whatever became of them.
    [[nodiscard]] std::size_t heard() const noexcept { return heard_; }

    /// Now, on the clock of the deadlines.
    [[nodiscard]] static rtuwire::instant now() noexcept { return rtuwire::steady_now(); }

private:
    rtuwire::result<void> open_one(serial_device const& chosen, rtuwire::serial_settings const& settings);
    rtuwire::result<void> open_one(tcp_address const& chosen, rtuwire::serial_settings const& settings);
    rtuwire::result<void> open_one(mbap_address const& chosen, rtuwire::serial_settings const& settings);
    rtuwire::result<void> open_one(simulated_drives_choice const& chosen, rtuwire::serial_settings const& settings);
    rtuwire::result<void> open_one(capture_file const& chosen, rtuwire::serial_settings const& settings);

    rtuwire::result<rtuwire::byte_span> read_attended(rtuwire::byte_span place, rtuwire::instant until);
    void note_failure(rtuwire::errc why);
    std::string other_protocol() const;
    std::string other_units(option_form form) const;

    simulated_drives drives_{}; ///< outlives the port to them
    std::variant<rtuwire::host_serial, rtuwire::tcp_stream, rtuwire::mbap_stream> port_{};
    rtuwire::line_timing timing_{rtuwire::line_timing::without_wire()};
    std::size_t heard_{0};
    bool has_sent_{false};
    std::uint8_t asked_{0}; ///< the unit of the last frame
    bool has_taken_last_{false};
    bool is_gone_{false};
    bool has_receive_error_{false}; ///< that was taken from the port
    port_attendant* attendant_{nullptr};
    std::string own_failure_{}; ///< where it is not the port's
};

} // namespace tool
