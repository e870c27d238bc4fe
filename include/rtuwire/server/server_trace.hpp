// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a server that is traced tells of the frames that pass. In any other server these functions are empty.
// Internal: may change with any version.
#pragma once

#include <cstddef>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/tracing.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The base of a server's engine, which holds all that this looks at.
template <typename Engine, typename Diagnostics> class server_trace {
public:
    /// Hands the frames that pass from here on to a sink, which must outlive the server. For a server `traced_by` it.
    template <typename Sink>
        requires is_traced_by<Diagnostics, Sink>
    constexpr void trace_to(Sink& frames) noexcept { to().trace_to(frames); }

protected:
    /// Traces an undamaged frame.
    [[gnu::always_inline]] constexpr void pass_frame(adu const& heard) noexcept
    {
        if constexpr (is_traced<Diagnostics>) {
            auto const& units = engine().units_;
            bool const is_response = engine().framer_.is_foreign_response() or heard.is_exception();
            bool const is_ours = units.contains(heard.unit()) or heard.unit() == 0;
            frame_verdict const ours = is_response ? frame_verdict::stray : frame_verdict::good;
            to().pass(heard.bytes(), is_response ? frame_role::response : frame_role::request,
                      is_ours ? ours : frame_verdict::foreign);
        }
    }

    /// Traces a damaged one.
    [[gnu::always_inline]] constexpr void pass_damaged() noexcept
    {
        if constexpr (is_traced<Diagnostics>) {
            to().pass(engine().framer_.bytes(), frame_role::unknown, frame_verdict::damaged);
        }
    }

    /// Bytes were taken: traces those that the framer ignored; gives a frame whose end was open its last byte.
    [[gnu::always_inline]] constexpr void pass_taken(byte_view bytes, bool was_open, instant now) noexcept
    {
        if constexpr (is_traced<Diagnostics>) {
            if (bytes.empty()) {
                return;
            }
            to().note_heard(now);
            if (was_open) {
                engine().framer_.keep_zero();
            } else if (engine().framer_.ignores_bytes()) {
                to().pass(bytes, frame_role::unknown, frame_verdict::stray);
            }
        }
    }

    /// Traces a frame that silence ended before a damaged byte, and that is dropped with it.
    [[gnu::always_inline]] constexpr void pass_unpolled(instant now) noexcept
    {
        if constexpr (is_traced<Diagnostics>) {
            auto& framer = engine().framer_;
            if (framer.begin_chunk(1, now)) {
                bool const is_damaged = framer.verdict() != errc::none;
                to().pass(framer.bytes(), frame_role::unknown,
                          is_damaged ? frame_verdict::damaged : frame_verdict::stray);
            }
            to().note_heard(now);
        }
    }

    /// A response begins to leave; bytes arrive while it does; it has left.
    [[gnu::always_inline]] constexpr void pass_leaving() noexcept
    {
        if constexpr (is_traced<Diagnostics>) {
            to().note_leaving();
        }
    }
    [[gnu::always_inline]] constexpr void pass_while_leaving(byte_view bytes, instant now) noexcept
    {
        if constexpr (is_traced<Diagnostics>) {
            to().note_heard(now);
            to().pass_while_leaving(bytes, response_bytes(), frame_role::response);
        }
    }
    [[gnu::always_inline]] constexpr void pass_sent(instant now) noexcept
    {
        if constexpr (is_traced<Diagnostics>) {
            to().pass_own(response_bytes(), frame_role::response, now);
        }
    }

private:
    constexpr Engine& engine() noexcept { return static_cast<Engine&>(*this); }
    constexpr Diagnostics& to() noexcept { return engine().diagnostics_; }
    constexpr byte_view response_bytes() noexcept
    {
        return byte_view{engine().framer_.storage()}.first(std::size_t{engine().pdu_size_} + adu_overhead);
    }
};

} // namespace rtuwire
