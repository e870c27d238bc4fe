// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 08 of a server (Application Protocol 6.8): the loop-back alone, or with the counters of the
// serial line and the listen-only mode.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/server/pdu_place.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/pdu/diagnostics.hpp>

namespace rtuwire {

/// What a server notes that counts nothing.
struct no_counts {
    static constexpr void note_message() noexcept {}
    static constexpr void note_error() noexcept {}
    static constexpr void note_overrun() noexcept {}
    static constexpr void note_request() noexcept {}
    static constexpr void note_silence() noexcept {}
    static constexpr void note_exception(errc) noexcept {}
    [[nodiscard]] static constexpr bool is_listen_only() noexcept { return false; }
};

/// A server without function 08.
struct no_diagnostics : no_counts {
    [[nodiscard]] static constexpr errc answer(pdu_place&) noexcept
    {
        return errc::illegal_function;
    }
};

/// A server that counts nothing: sub-function 0.
struct loop_back : no_counts {
    [[nodiscard]] static constexpr errc answer(pdu_place& pdu) noexcept
    {
        byte_view const request_pdu = pdu.view();
        if (request_pdu.size() >= 3 and u16_at(request_pdu, 1) != 0) {
            return errc::illegal_function;
        }
        if (not diagnostics::decode(request_pdu)) {
            return errc::illegal_data_value;
        }
        return errc::none;
    }
};

/// A server that counts what it sees, each modulo 65 536, and can be told to listen only.
class serial_diagnostics {
public:
    /// Answers function 08, or not. Exceptions: 01 for a reserved sub-function, 03 for
    /// data that it does not allow.
    [[nodiscard]] constexpr errc answer(pdu_place& pdu) noexcept
    {
        byte_view const request_pdu = pdu.view();
        auto const asked = diagnostics::decode(request_pdu);
        if (is_listen_only_) {
            if (asked and asked->what == subfunction::restart_communications and is_legal(*asked)) {
                *this = {};
            }
            pdu.size = 0;
            return errc::none;
        }
        if (request_pdu.size() >= 3 and not is_known(u16_at(request_pdu, 1))) {
            return errc::illegal_function;
        }
        if (not asked or not is_legal(*asked)) {
            return errc::illegal_data_value;
        }
        if (std::uint16_t const* const count = count_of(asked->what); count != nullptr) {
            constexpr std::size_t data_at = 3;
            put_u16(pdu.octets.data() + data_at, *count);
        }
        act(asked->what);
        pdu.size = is_listen_only_ ? 0 : pdu.size;
        return errc::none;
    }

    /// A frame with a good CRC passed, whoever it was for.
    constexpr void note_message() noexcept { ++messages_; }
    /// A frame was damaged.
    constexpr void note_error() noexcept { ++errors_; }
    /// The receiver lost an octet.
    constexpr void note_overrun() noexcept { ++overruns_; }
    /// A request to this server, or to everyone.
    constexpr void note_request() noexcept { ++requests_; }
    /// It was not answered.
    constexpr void note_silence() noexcept { ++silences_; }
    /// It was refused.
    constexpr void note_exception(errc code) noexcept
    {
        ++exceptions_;
        naks_ = static_cast<std::uint16_t>(naks_ + (code == errc::negative_acknowledge ? 1 : 0));
        busy_ = static_cast<std::uint16_t>(busy_ + (code == errc::server_device_busy ? 1 : 0));
    }

    /// Whether it neither acts nor answers until it is restarted.
    [[nodiscard]] constexpr bool is_listen_only() const noexcept { return is_listen_only_; }

private:
    static constexpr bool is_known(std::uint16_t number) noexcept
    {
        constexpr std::uint16_t last_of_first = 0x04, first_count = 0x0A, last_count = 0x12,
                                clear_overrun = 0x14;
        return number <= last_of_first or (number >= first_count and number <= last_count) or
               number == clear_overrun;
    }

    static constexpr bool is_legal(diagnostics const& asked) noexcept
    {
        constexpr std::uint16_t clear_log = 0xFF00, low_octet = 0x00FF;
        std::uint16_t const data = asked.data[0];
        switch (asked.what) {
        case subfunction::return_query_data: return true;
        case subfunction::restart_communications: return data == 0 or data == clear_log;
        case subfunction::change_ascii_delimiter: return (data & low_octet) == 0;
        case subfunction::return_diagnostic_register:
        case subfunction::force_listen_only:
        case subfunction::clear_counters:
        case subfunction::bus_message_count:
        case subfunction::bus_communication_error_count:
        case subfunction::bus_exception_error_count:
        case subfunction::server_message_count:
        case subfunction::server_no_response_count:
        case subfunction::server_nak_count:
        case subfunction::server_busy_count:
        case subfunction::bus_character_overrun_count:
        case subfunction::clear_overrun_counter: break;
        }
        return data == 0;
    }

    /// What a sub-function returns; null where it returns its data.
    constexpr std::uint16_t const* count_of(subfunction what) const noexcept
    {
        switch (what) {
        case subfunction::return_diagnostic_register: return &register_;
        case subfunction::bus_message_count: return &messages_;
        case subfunction::bus_communication_error_count: return &errors_;
        case subfunction::bus_exception_error_count: return &exceptions_;
        case subfunction::server_message_count: return &requests_;
        case subfunction::server_no_response_count: return &silences_;
        case subfunction::server_nak_count: return &naks_;
        case subfunction::server_busy_count: return &busy_;
        case subfunction::bus_character_overrun_count: return &overruns_;
        case subfunction::return_query_data:
        case subfunction::restart_communications:
        case subfunction::change_ascii_delimiter:
        case subfunction::force_listen_only:
        case subfunction::clear_counters:
        case subfunction::clear_overrun_counter: break;
        }
        return nullptr;
    }

    constexpr void act(subfunction what) noexcept
    {
        if (what == subfunction::restart_communications or what == subfunction::clear_counters) {
            *this = {};
        } else if (what == subfunction::force_listen_only) {
            is_listen_only_ = true;
        } else if (what == subfunction::clear_overrun_counter) {
            overruns_ = 0;
        }
    }

    std::uint16_t register_{0}; ///< nothing of ours to say
    std::uint16_t messages_{0};
    std::uint16_t errors_{0};
    std::uint16_t exceptions_{0};
    std::uint16_t requests_{0};
    std::uint16_t silences_{0};
    std::uint16_t naks_{0};
    std::uint16_t busy_{0};
    std::uint16_t overruns_{0};
    bool is_listen_only_{false};
};

} // namespace rtuwire
