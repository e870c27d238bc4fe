// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a server does with the bytes that arrive. server/server_engine.hpp has the table of its phases.
// Internal: may change with any version.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/server/server_trace.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// What a server waits for: a request; `serve`; the silence before its response; the end of that.
enum class server_phase : std::uint8_t { listening, asked, responding, transmitting };

/// The base of a server's engine, which holds all that this looks at.
template <typename Engine, typename Diagnostics> class server_reception : public server_trace<Engine, Diagnostics> {
public:
    /// Receives bytes that had arrived by `now`, in chunks of any size. Drops a request that waits for `serve`, or
    /// its response, and decodes the next frame. While a response is sent, bytes are ignored; they only keep the line
    /// from being silent.
    constexpr void receive(byte_view bytes, instant now) noexcept
    {
        if (engine().phase_ == server_phase::transmitting and not bytes.empty()) {
            this->pass_while_leaving(bytes, now);
            return receive_error(now);
        }
        while (not bytes.empty()) {
            engine().drop_request();
            [[maybe_unused]] bool const was_open = engine().framer_.has_open_end();
            std::size_t const taken = engine().framer_.receive(bytes, now);
            this->pass_taken(bytes.first(taken), was_open, now);
            bytes = bytes.subspan(taken);
            engine().take_frame();
        }
    }

    /// The same of one byte, for a receiver that hands over each as it arrives: a program that calls only this has no code
    /// for chunks.
    constexpr void receive(std::same_as<std::byte> auto byte, instant now) noexcept
    {
        if (engine().phase_ == server_phase::transmitting) {
            this->pass_while_leaving({&byte, 1}, now);
            return receive_error(now);
        }
        for (bool is_taken = false; not is_taken;) {
            engine().drop_request();
            [[maybe_unused]] bool const was_open = engine().framer_.has_open_end();
            is_taken = engine().framer_.receive(byte, now);
            this->pass_taken({&byte, is_taken ? 1U : 0U}, was_open, now);
            engine().take_frame();
        }
    }

    /// Reports a byte that arrived damaged (parity, framing, overrun): its frame is dropped. After a request, where
    /// the line's turnaround often produces one, it only delays the response; bytes after it are ignored up to a
    /// silence of `frame_end`, and still drop the request. A frame that silence ended before it, and no `advance` has
    /// processed, is dropped.
    constexpr void receive_error(instant now) noexcept
    {
        if (engine().phase_ == server_phase::listening) {
            this->pass_unpolled(now);
            engine().framer_.receive_error(now);
        } else {
            // After so long a pause the time limit would come to lie ahead again.
            if (engine().framer_.within_reach_of_line(now) != now) {
                engine().end_overdue(now);
            }
            static_cast<void>(engine().framer_.begin_chunk(1, now));
            engine().framer_.resynchronise();
        }
    }

    /// The same, where the receiver reports that it lost a byte.
    constexpr void receive_overrun(instant now) noexcept
    {
        engine().diagnostics_.note_overrun();
        receive_error(now);
    }

private:
    constexpr Engine& engine() noexcept { return static_cast<Engine&>(*this); }
};

} // namespace rtuwire
