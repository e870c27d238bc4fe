// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Modbus TCP as a port of RTU frames: a client writes and reads frames here as on a serial device, and messages with numbers
// pass on the connection. A client so asks a server of Modbus TCP, or the units behind a gateway, by all that it has for a
// line, and nothing of Modbus TCP is in it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/port/mbap.hpp>
#include <rtuwire/port/tcp_stream.hpp>
#include <rtuwire/rtu/line.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Messages that came and were no response to the request under way. None of them was passed on.
struct mbap_dropped {
    std::uint32_t late{0};       ///< responses to requests before it
    duration latest{};           ///< how long behind its request the last of these came
    std::uint32_t other_unit{0}; ///< with its number, of another unit than was asked
    std::uint8_t unit{0};        ///< of the last of these
    std::uint32_t unknown{0};    ///< with a number that nobody waits for: never sent, or answered already

    friend constexpr bool operator==(mbap_dropped const&, mbap_dropped const&) noexcept = default;
};

/// A connection to a server of Modbus TCP, whose RTU frames are its client's affair only: their CRC is made and taken off here.
/// Each request gets a number, and what is passed on as its response has this number, the asked unit, protocol 0 and the length
/// that it says. So a response that is late, however late, is never taken for the response to another request, up to
/// 65 536 requests later. Can be moved; its destructor closes it.
///
/// A unit is what it is on a line, and goes as it was given: 1 to 247 behind a gateway, which sends what is for 0 to all of them.
/// A device that is no gateway takes any unit, or wants 255 or 0, and may answer what was sent to 0: `unit_id::reserved(255)` and
/// `only_unit` ask these. Nothing here puts one in the place of another.
class mbap_stream {
public:
    /// The port of Modbus TCP.
    static constexpr std::uint16_t usual_port = 502;

    /// As `tcp_stream::open`, with its errors.
    result<void> open(std::string const& host, std::uint16_t port = usual_port,
                      duration time_limit = milliseconds(3'000))
    {
        *this = mbap_stream{};
        return line_.open(host, port, time_limit);
    }

    void close() noexcept { line_.close(); }

    /// Whether a connection was made and not closed by this end.
    [[nodiscard]] bool is_open() const noexcept { return line_.is_open(); }

    /// The system's number of the open socket, for `poll`, or for a signal handler, which writes messages (`message_of`); -1
    /// where none is open.
    [[nodiscard]] int descriptor_number() const noexcept { return line_.descriptor_number(); }

    /// Host and port: "plc-7:502".
    [[nodiscard]] std::string const& device() const noexcept { return line_.device(); }

    /// The last failure in words, beginning with host and port; empty before the first.
    [[nodiscard]] std::string const& failure() const noexcept { return failure_.empty() ? line_.failure() : failure_; }

    /// Times for a client: responses have numbers.
    [[nodiscard]] static constexpr line_timing timing() noexcept { return line_timing::numbered(); }

    /// Sends a frame as a message with the next number. Errors: those of `check_frame`, of what is no frame: nothing is sent;
    /// `transmit_stalled` (the other end takes nothing), behind which nothing more is sent, since a part of it may have gone;
    /// `device_not_open`, `device_vanished`, `device_failed`.
    result<void> write(byte_view frame, instant until)
    {
        if (errc const wrong = check_frame(frame); wrong != errc::none) {
            return failed(wrong, "what was to be sent is no frame");
        }
        failure_.clear();
        if (is_cut_) {
            return failed(errc::device_vanished, "a request was not taken in time: the connection is given up");
        }
        drop_early();
        sending const next{static_cast<std::uint16_t>(last_.number + 1U), detail::to_u8(frame[0]), true, now()};
        std::array<std::byte, max_mbap_size> place{};
        auto const written = line_.write(message_of(frame, next.number, place), until);
        if (written) {
            last_ = next;
            sent_[next.number % sent_.size()] = next;
        }
        is_cut_ = not written and written.error() == errc::transmit_stalled;
        return written;
    }

    /// Waits until the deadline for the response to the last request, and gives it as a frame; empty where none came. In parts
    /// where `place` is smaller than it. Messages that are none are dropped, and counted; behind some of them it is empty before
    /// the deadline, so that whoever sends them without end keeps nobody from his clock. Errors: `device_not_open`,
    /// `device_vanished`, `device_failed`; the last also where what came is no Modbus TCP, at each read from then on.
    result<byte_span> read(byte_span place, instant until)
    {
        for (bool has_read = false; not take_all(last_.number); has_read = true) {
            if (came_.fault() != mbap_fault::none) {
                return failed(errc::device_failed, words_of_fault()).error();
            }
            if (has_read and reached(now(), until)) {
                break;
            }
            auto const bytes = line_.read(came_.room(), until);
            if (not bytes) {
                return lost(bytes.error()).error();
            }
            if (bytes->empty()) {
                break;
            }
            came_.add(bytes->size());
        }
        return part_of_response(place);
    }

    /// Bytes that came last: of a message that is not whole, or of none.
    [[nodiscard]] byte_view begun() const noexcept { return came_.bytes(); }

    /// What came besides, since it was opened.
    [[nodiscard]] mbap_dropped const& dropped() const noexcept { return dropped_; }

    /// A frame as the message that goes, with a number; `place` has 260 bytes. The frame is whole: its CRC is not looked at.
    [[nodiscard]] static byte_view message_of(byte_view frame, std::uint16_t number, byte_span place) noexcept
    {
        bool const is_frame = frame.size() >= min_adu_size;
        auto const message = write_mbap(place, {number, frame.first(is_frame ? frame.size() - detail::crc_size : 0)});
        return message ? *message : byte_view{};
    }

    /// Now, on the clock of the deadlines.
    [[nodiscard]] static instant now() noexcept { return steady_now(); }

private:
    struct sending {
        std::uint16_t number{0};
        std::uint8_t unit{0};
        bool is_awaited{false};
        instant at{0};
    };

    /// What came before a request was sent is no response to it, whatever its number.
    void drop_early()
    {
        constexpr int most = 64; // each as much as there is room for
        left_ = 0;
        for (int i = 0; i < most and came_.fault() == mbap_fault::none; ++i) {
            static_cast<void>(take_all(std::nullopt));
            auto const bytes = line_.read(came_.room(), now());
            if (not bytes or bytes->empty()) {
                break; // where the connection is gone, the write finds that
            }
            came_.add(bytes->size());
        }
        static_cast<void>(take_all(std::nullopt));
    }

    /// The messages that are whole, up to the response to the request with this number; whether there was any.
    bool take_all(std::optional<std::uint16_t> awaited)
    {
        bool has_taken = left_ != 0;
        for (; left_ == 0; came_.drop_first()) {
            auto const message = came_.first();
            if (not message) {
                break;
            }
            take(*message, awaited);
            has_taken = true;
        }
        return has_taken;
    }

    /// A message of the other end.
    void take(mbap_message const& message, std::optional<std::uint16_t> awaited)
    {
        sending& asked = sent_[message.number % sent_.size()];
        if (asked.number != message.number or not asked.is_awaited) {
            ++dropped_.unknown;
        } else if (detail::to_u8(message.body[0]) != asked.unit) {
            ++dropped_.other_unit;
            dropped_.unit = detail::to_u8(message.body[0]);
        } else {
            asked.is_awaited = false;
            if (message.number == awaited) {
                size_ = left_ = rtu_frame_of(message, response_).size();
            } else {
                ++dropped_.late;
                dropped_.latest = now() - asked.at;
            }
        }
    }

    byte_span part_of_response(byte_span place) noexcept
    {
        std::size_t const count = std::min(place.size(), left_);
        std::copy_n(response_.begin() + static_cast<std::ptrdiff_t>(size_ - left_), count, place.begin());
        left_ -= count;
        return place.first(count);
    }

    std::string words_of_fault() const
    {
        std::string const what =
            came_.fault() == mbap_fault::protocol ? "its protocol is not 0" : "its length is not 2 to 254";
        std::string words = "what came is no Modbus TCP: " + what + ":";
        constexpr char digits[] = "0123456789ABCDEF";
        for (std::byte const each : came_.bytes().first(std::min<std::size_t>(came_.bytes().size(), 24))) {
            words.append({' ', digits[detail::to_u8(each) >> 4U], digits[detail::to_u8(each) & 0xFU]});
        }
        return words;
    }

    result<void> failed(errc error, std::string const& what)
    {
        failure_ = device() + ": " + what;
        return error;
    }

    /// The connection is gone; a part of a message may have come before.
    result<void> lost(errc error)
    {
        failure_.clear();
        std::size_t const begun = came_.bytes().size();
        if (error == errc::device_vanished and begun > 0) {
            failure_ =
                line_.failure() + ", in the middle of a message of which " + std::to_string(begun) + " bytes had come";
        }
        return error;
    }

    tcp_stream line_{};
    std::string failure_{};
    mbap_cutter came_{};
    std::array<std::byte, max_adu_size> response_{};
    std::size_t size_{0}; ///< of the response
    std::size_t left_{0}; ///< how many of its bytes are to be read
    sending last_{};
    std::array<sending, 64> sent_{}; ///< the last requests, each at its number
    mbap_dropped dropped_{};
    bool is_cut_{false}; ///< a message may have left in part
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
