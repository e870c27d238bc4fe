// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What stands between a client and a server and plays faults. It knows neither ports nor a clock: bytes and times come in,
// bytes and what is told of them go out, in simulated time as on a line.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rtuwire/trace.hpp>

#include "chaos/frame_cutter.hpp"
#include "chaos/line_fault.hpp"
#include "chaos/request_guard.hpp"

namespace tool {

/// What is played, and what has to be known of the line for that.
struct fault_plan {
    std::vector<line_fault> faults;
    std::uint32_t seed{1};
    rtuwire::duration time_out{};  ///< the client's
    rtuwire::duration character{}; ///< of the wire that a USB adapter listens to
    rtuwire::duration silence{};   ///< ends what has no length
};

/// Where it goes.
struct line_outlets {
    std::function<void(frame_way, rtuwire::byte_view)> send;
    /// A frame, or a part of one, as it came or left, and what was done to it.
    std::function<void(rtuwire::traced_frame const&, std::string const&)> tell;
};

struct fault_counts {
    std::uint32_t frames{0};
    std::uint32_t untouched{0};
    std::uint32_t kept_back{0}; ///< would have been a request that nobody sent
    std::map<std::string, std::uint32_t> met{};
};

class disturbed_line {
    template <typename Pair> static auto& at(Pair& pair, frame_way way) { return pair[static_cast<std::size_t>(way)]; }

public:
    disturbed_line(fault_plan plan, line_outlets outlets);

    /// Bytes that the client (`request`) or the server (`answer`) sent, or none.
    void receive(frame_way way, rtuwire::byte_view bytes, rtuwire::instant now);
    /// Time has passed: sends what is due.
    void advance(rtuwire::instant now);
    [[nodiscard]] rtuwire::deadline poll_deadline() const;

    [[nodiscard]] fault_counts const& counts(frame_way way) const { return at(counts_, way); }

    /// Of one direction: a frame that comes while so many bytes wait is lost.
    static constexpr std::size_t most_waiting = 65'536;

private:
    /// More bytes without sense, which are made when it is their turn.
    struct babble_lumps {
        rtuwire::sim::random_source random;
        rtuwire::instant began;
        std::uint32_t number; ///< of the last
        std::uint32_t count;
        std::string told;
    };
    /// What goes out at a time, or when what stands before it has gone.
    struct outgoing {
        std::vector<std::byte> bytes;
        rtuwire::instant at;
        rtuwire::frame_verdict verdict;
        bool is_frame; ///< a request or an answer, as a whole
        bool is_own;   ///< not as it came
        std::string told;
        std::optional<babble_lumps> goes_on{};

        /// When the last of it goes.
        [[nodiscard]] rtuwire::instant end() const;
    };
    /// The frame that is on its way through, and what it meets.
    struct passing_frame;

    void take(frame_way way, rtuwire::byte_view frame, rtuwire::instant now);
    void give_back(passing_frame const& it);
    void put_babble(passing_frame const& it, line_fault const& fault);
    static void take_next(outgoing& babble);
    rtuwire::instant put_foreign(passing_frame const& it, line_fault const& fault);
    void put_disturbed(passing_frame& it);
    void put_pieces(passing_frame const& it, outgoing whole);
    void put(frame_way way, outgoing piece);
    void release(frame_way way, rtuwire::instant now);
    void send(frame_way way, outgoing const& piece, rtuwire::instant now);
    void tell(frame_way way, rtuwire::byte_view bytes, rtuwire::instant now, outgoing const& what) const;

    fault_plan plan_;
    line_outlets outlets_;
    std::array<frame_cutter, 2> cutters_;
    std::array<request_guard, 2> guards_{request_guard{frame_way::request}, request_guard{frame_way::answer}};
    std::array<std::deque<outgoing>, 2> queues_{};
    std::array<std::size_t, 2> waiting_{}; ///< bytes
    std::array<fault_counts, 2> counts_{};
};

} // namespace tool
