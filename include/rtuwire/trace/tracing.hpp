// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Between an engine and the sink that takes its frames: beside what a client or a server counts of its line. An engine
// that is not traced holds no byte of this and runs no instruction for it.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/traced_frame.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Whether an engine that counts by `Counts` is traced; and by that sink.
template <typename Counts> inline constexpr bool is_traced = requires { typename Counts::traced_by; };
template <typename Counts, typename Sink> inline constexpr bool is_traced_by = requires(Counts& counts, Sink& sink)
{
    counts.trace_to(sink);
};

/// What an engine counts, and the sink of its frames. Without a sink nothing is traced.
template <frame_sink Sink, typename Counts> class tracing : public Counts {
public:
    using traced_by = Sink;

    constexpr void trace_to(Sink& frames) noexcept { sink_ = &frames; }

    /// Bytes have arrived: what passes from here on ended then.
    constexpr void note_heard(instant at) noexcept { heard_ = at; }

    /// A frame has arrived, or bytes that belong to none.
    constexpr void pass(byte_view bytes, frame_role role, frame_verdict verdict) noexcept
    {
        hand({bytes, heard_, role, verdict, false});
    }

    /// The same of bytes that nobody asked for; those behind the start of a late response belong to it.
    constexpr void pass_stray(byte_view bytes, bool is_start, bool is_late) noexcept
    {
        is_late_ = is_start ? is_late : is_late_;
        pass(bytes, is_late_ ? frame_role::response : frame_role::unknown,
             is_late_ ? frame_verdict::late : frame_verdict::stray);
    }

    /// A frame of this end has left.
    constexpr void pass_own(byte_view bytes, frame_role role, instant at) noexcept
    {
        hand({bytes, at, role, frame_verdict::good, true});
    }

    /// A frame of this end begins to leave.
    constexpr void note_leaving() noexcept { echoed_ = 0; }

    /// Bytes have arrived while `own` leaves: the next ones of its echo, or others. After others no more are its echo.
    constexpr void pass_while_leaving(byte_view bytes, byte_view own, frame_role role) noexcept
    {
        bool const is_echo =
            bytes.size() <= own.size() - echoed_ and same_bytes(bytes, own.subspan(echoed_, bytes.size()));
        echoed_ = is_echo ? echoed_ + bytes.size() : own.size();
        is_echo ? pass_echo(bytes, role) : pass(bytes, frame_role::unknown, frame_verdict::stray);
    }

    /// It came back, or a part of it.
    constexpr void pass_echo(byte_view bytes, frame_role role) noexcept
    {
        hand({bytes, heard_, role, frame_verdict::echo, true});
    }

private:
    constexpr void hand(traced_frame const& frame) noexcept
    {
        if (sink_ != nullptr and not frame.bytes.empty()) {
            sink_->take(frame);
        }
    }

    Sink* sink_{nullptr};
    instant heard_{0};
    std::size_t echoed_{0}; ///< how many bytes of the frame that leaves have come back
    bool is_late_{false};
};

template <typename Counts> struct without_trace {
    using type = Counts;
};
template <typename Sink, typename Counts> struct without_trace<tracing<Sink, Counts>> {
    using type = Counts;
};

/// What an engine counts by, traced or not.
template <typename Counts> using counted_by = typename without_trace<Counts>::type;

} // namespace rtuwire
