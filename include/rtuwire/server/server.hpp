// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The server on a line (SL 2.4.2): receives requests to its unit and broadcasts, responds to the former, and sends
// nothing else. Owns neither the wire, nor a clock, nor the registers.
#pragma once

#include <cstdint>
#include <optional>

#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/server/server_engine.hpp>
#include <rtuwire/server/units/bank_at.hpp>
#include <rtuwire/trace/tracing.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The unit address of a server that has one; 0 for none.
/// Internal.
struct one_unit {
    std::uint8_t number;

    [[nodiscard]] constexpr bool contains(std::uint8_t unit) const noexcept { return unit == number; }

    /// Executes a request on its bank; returns the exception, or none.
    template <typename Functions, typename Bank, typename Diagnostics>
    static constexpr errc execute_on(std::uint8_t, request_head const& asked, pdu_buffer& pdu, Bank& bank,
                                     server_profile const& profile, Diagnostics& line) noexcept
    {
        return asked.has_effect<Functions>() ? execute<Functions>(asked.function, pdu, bank, profile, line)
                                             : errc::illegal_function;
    }
};

/// A server of several unit addresses, from server/units/several_units.hpp.
/// Internal.
template <typename Diagnostics, typename Functions, typename... Entries> class several_units;

/// Serves one unit address. In each pass call `receive` with what arrived, `sent` when the last stop bit of a
/// response was sent, `advance`, `serve`; then send what `poll_transmit` returns. Sleep no longer than until
/// `poll_deadline`; whoever comes later, even by hours, finds over what was in force. `now` never goes back.
///
/// How frames end. Bytes are ignored until the line was silent for `frame_end` once; before the first `advance`, time
/// is not known and all bytes are ignored. Then a frame begins with the next byte. It ends
/// - at the size that the request's length rule gives (wire/frame_length.hpp), with a correct CRC;
/// - where the last good frame was a request to another unit and the first two bytes are that unit and that function,
///   with or without 80: also at the size that the response's rule gives, whichever size comes first with a correct
///   CRC. For functions 01 to 04 the size of a request does not count where the fifth byte is above 7 (01, 02) or
///   above 0 (03, 04): such a quantity is not allowed. Where the other rule gives one byte more (or for function 43
///   is applied again there) and the fifth byte allows a request, the end is open: a byte 00 that comes next is part
///   of the frame, which then ended by the other rule; any other byte, or t3.5 of silence, ends it. Where both rules
///   give the size, it ended by the request's;
/// - otherwise after a silence of `frame_end`. It is then good if its CRC is correct and it has 4 to 256 bytes.
/// A chunk of n bytes passed at `now` follows a silence of s where `now` is at least s + n characters after the last
/// byte before it. A frame with a wrong CRC, with a byte that was reported damaged, too short or too long is dropped,
/// and ends by silence only.
///
/// What a good frame means. To this unit or to 0, with a function below 80: it is a request and waits for `serve`. To
/// another unit, with a function below 80, and not ended at the size of an expected response: a request to another
/// unit. Any other frame is ignored, and no response is expected any longer. A frame is looked for only at its first
/// byte. Another unit's response to a request that was not received is decoded as a request; its CRC is then wrong,
/// and the next silence ends it.
///
/// Which requests are executed. `serve` executes a request if no undamaged byte was received after it and `now` is
/// before its time limit. Otherwise it is neither executed nor answered: its client may have timed out and sent
/// another request. This holds for broadcasts too: call `serve` within the client's turnaround delay. The bytes after
/// a request are decoded as the next frame, which may be the newer request. A response is sent when t3.5 has passed
/// since the last byte, damaged or not; it is dropped if an undamaged byte arrives before `poll_transmit` returns it,
/// or at the time limit. The request was executed even then.
/// Internal.
template <typename Diagnostics, typename Functions = register_functions>
class basic_server : public server_engine<Diagnostics, one_unit> {
    using engine = server_engine<Diagnostics, one_unit>;

public:
    /// The same with other functions: `server::with<function_list<read_coils>>`; `public_functions` are all.
    template <typename Others> using with = basic_server<Diagnostics, Others>;

    /// The same, of which a sink takes the frames as they pass, from `trace_to(sink)` on:
    /// `server::traced_by<trace_ring<4096>>`. One of several units is `server::traced_by<Sink>::for_units(...)`.
    template <frame_sink Sink> using traced_by = basic_server<tracing<Sink, Diagnostics>, Functions>;

    /// A server of several unit addresses, each with a bank of its own, that have one line and one frame's memory in
    /// common: `auto node = server::for_units(timing, bank_at{unit_id{3}, io}, bank_at{unit_id{4}, meter})`. It is
    /// served by `node.serve(now)`.
    template <typename... Banks>
    [[nodiscard]] static constexpr auto for_units(line_timing const& timing, Banks&&... banks) noexcept
    {
        return several_units<Diagnostics, Functions, unit_entry<Banks>...>{timing, unit_entry<Banks>{banks}...};
    }

    /// Listens as `unit`; the profile, and the objects in it, must outlive the server.
    constexpr basic_server(unit_id its_unit, line_timing const& its_timing, server_profile const& its_profile) noexcept
        : engine{one_unit{its_unit.byte()}, its_timing, its_profile}
    {}

    /// Listens as `unit` with every function and the specification's limits, without identification.
    constexpr basic_server(unit_id its_unit, line_timing const& its_timing) noexcept
        : basic_server{its_unit, its_timing, engine::default_profile}
    {}

    basic_server(unit_id, line_timing const&, server_profile&&) = delete;

    /// Calls `advance`; then executes the waiting request on the registers and prepares the response. A broadcast is
    /// executed for writes only (functions 05, 06, 15, 16, 21 and 22), and never answered.
    template <typename Bank> constexpr void serve(Bank& bank, instant now) noexcept
    {
        this->template serve_by<Functions>(bank, now);
    }

    /// Listens to another address from the next frame on; without one, to broadcasts only. A waiting response is
    /// still sent.
    constexpr void listen_as(std::optional<unit_id> unit) noexcept
    {
        this->set_units({unit ? unit->byte() : std::uint8_t{0}});
    }
};

/// A server whose function 08 is the loopback (sub-function 0) only, with functions 03, 06, 08, 16, 23 and 43.
using server = basic_server<loopback_only>;

/// A server with the counters and the listen-only mode of function 08.
using counting_server = basic_server<serial_diagnostics>;

} // namespace rtuwire
