// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The kernel's switching of an RS-485 transceiver (Linux: TIOCGRS485, TIOCSRS485). What a driver has by its device tree is
// read first; what was asked for is changed, read back, and put back at the end.
#pragma once

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

#ifdef __linux__
#include <linux/serial.h>
#include <sys/ioctl.h>
#endif

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Whether the kernel's driver shall switch the RS-485 transceiver's direction.
enum class rs485_mode : std::uint8_t {
    leave,      ///< as the device is: for adapters that switch by themselves
    if_offered, ///< where the driver can
    required,   ///< `device_setting_refused` where it cannot
};

/// The level of RTS, which is the transceiver's driver enable, while a frame is sent; it has the other one else.
enum class rts_polarity : std::uint8_t { high_to_send, low_to_send };

/// How the driver switches the transceiver, where `rs485_mode` lets it. What is left out stays as the driver has it; where it
/// has no polarity yet, RTS is high to send.
struct transceiver_settings {
    std::optional<rts_polarity> polarity{};
    std::optional<duration> before_send{}; ///< from RTS to the first start bit, in whole milliseconds, rounded up
    std::optional<duration> after_send{};  ///< from the last stop bit to RTS, in whole milliseconds, rounded up
    std::optional<bool> receives_while_sending{}; ///< the line's echo: see `client_options::has_line_echo`
};

namespace detail {

/// What was changed of a driver's settings, to be put back. A call gets or sets them: `call(request, settings)` returns
/// whether it did, and sets errno where not.
class transceiver_control {
public:
    /// Sets what was asked for. `device_setting_refused` where that was required, or asked of a driver that switches, and
    /// is not kept; `why` then says what. What was changed by then is put back by `restore`.
    template <typename Driver>
    result<void> set([[maybe_unused]] Driver&& call, rs485_mode mode,
                     [[maybe_unused]] transceiver_settings const& asked, std::string& why)
    {
        if (mode == rs485_mode::leave) {
            return {};
        }
        bool is_offered = false;
#ifdef TIOCSRS485
        serial_rs485 found{};
        if (call(TIOCGRS485, found)) {
            serial_rs485 const wanted = with(found, asked);
            if (is_same(found, wanted)) {
                return {};
            }
            serial_rs485 kept = wanted;
            if (call(TIOCSRS485, kept)) {
                before_ = found;
                why = call(TIOCGRS485, kept) ? difference(kept, wanted, asked) : std::strerror(errno);
                bool const is_off = (kept.flags & SER_RS485_ENABLED) == 0;
                if (not why.empty() and is_off and mode == rs485_mode::if_offered) {
                    restore(call);
                    return {};
                }
                return why.empty() ? result<void>{} : errc::device_setting_refused;
            }
            is_offered = (found.flags & SER_RS485_ENABLED) != 0;
        }
        why = std::string{"its driver does not switch an RS-485 transceiver so ("} + std::strerror(errno) + ")";
#else
        why = "this system does not switch RS-485 transceivers";
#endif
        if (mode == rs485_mode::required or is_offered) {
            return errc::device_setting_refused;
        }
        return {};
    }

    /// Whether something is to be put back.
    [[nodiscard]] bool is_changed() const noexcept
    {
#ifdef TIOCSRS485
        return before_.has_value();
#else
        return false;
#endif
    }

    /// Puts back what the driver had; once.
    template <typename Driver> void restore([[maybe_unused]] Driver&& call) noexcept
    {
#ifdef TIOCSRS485
        if (before_) {
            static_cast<void>(call(TIOCSRS485, *before_));
            before_.reset();
        }
#endif
    }

    /// Forgets what was changed: somebody else puts it back.
    void release() noexcept { *this = {}; }

#ifdef TIOCSRS485
private:
    static constexpr std::uint32_t high_on_send = SER_RS485_RTS_ON_SEND;
    static constexpr std::uint32_t high_after_send = SER_RS485_RTS_AFTER_SEND;
    static constexpr std::uint32_t both_levels = high_on_send | high_after_send;

    static std::uint32_t in_milliseconds(duration time) noexcept
    {
        return time.microseconds / 1'000 + (time.microseconds % 1'000 != 0 ? 1U : 0U);
    }

    static serial_rs485 with(serial_rs485 settings, transceiver_settings const& asked) noexcept
    {
        std::uint32_t const level = settings.flags & both_levels;
        bool const has_polarity = level == high_on_send or level == high_after_send;
        settings.flags |= SER_RS485_ENABLED;
        if (asked.polarity or not has_polarity) {
            settings.flags &= ~both_levels;
            settings.flags |= asked.polarity == rts_polarity::low_to_send ? high_after_send : high_on_send;
        }
        if (asked.before_send) {
            settings.delay_rts_before_send = in_milliseconds(*asked.before_send);
        }
        if (asked.after_send) {
            settings.delay_rts_after_send = in_milliseconds(*asked.after_send);
        }
        if (asked.receives_while_sending) {
            settings.flags &= ~std::uint32_t{SER_RS485_RX_DURING_TX};
            settings.flags |= *asked.receives_while_sending ? std::uint32_t{SER_RS485_RX_DURING_TX} : 0U;
        }
        return settings;
    }

    static bool is_same(serial_rs485 const& one, serial_rs485 const& other) noexcept
    {
        return one.flags == other.flags and one.delay_rts_before_send == other.delay_rts_before_send and
               one.delay_rts_after_send == other.delay_rts_after_send;
    }

    /// What was asked for and not kept, for people; empty where all of it was.
    static std::string difference(serial_rs485 const& kept, serial_rs485 const& wanted,
                                  transceiver_settings const& asked)
    {
        std::uint32_t const other = kept.flags ^ wanted.flags;
        auto const delay = [](std::string const& which, std::uint32_t has, std::uint32_t asks) {
            return "its driver keeps " + std::to_string(has) + " ms " + which + " sending, not " +
                   std::to_string(asks) + " ms";
        };
        if ((other & SER_RS485_ENABLED) != 0) {
            return "its driver does not switch an RS-485 transceiver";
        }
        if ((other & both_levels) != 0) {
            bool const is_high = (wanted.flags & high_on_send) != 0;
            return std::string{"its driver does not keep RTS "} + (is_high ? "high" : "low") + " to send";
        }
        if (asked.before_send and kept.delay_rts_before_send != wanted.delay_rts_before_send) {
            return delay("before", kept.delay_rts_before_send, wanted.delay_rts_before_send);
        }
        if (asked.after_send and kept.delay_rts_after_send != wanted.delay_rts_after_send) {
            return delay("after", kept.delay_rts_after_send, wanted.delay_rts_after_send);
        }
        if (asked.receives_while_sending and (other & SER_RS485_RX_DURING_TX) != 0) {
            return *asked.receives_while_sending ? "its driver does not receive while it sends"
                                                 : "its driver receives while it sends";
        }
        return {};
    }

    std::optional<serial_rs485> before_{};
#endif
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
