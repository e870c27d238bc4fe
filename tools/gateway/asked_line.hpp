// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the rounds of a line ask of it: on a port, or in simulated time.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "device_slot.hpp"
#include "gateway_file.hpp"
#include "line/exchange_counts.hpp"
#include "serve/serve_counts.hpp"
#include "setting_request.hpp"

namespace tool::gateway {

/// Values of one device that are read together, as often as each other.
struct device_part {
    std::size_t device;
    double every;                      ///< seconds
    std::vector<std::size_t> values{}; ///< of `device_plan::values`
};

std::vector<device_part> parts_of(line_plan const& plan);

/// Of one turn.
struct part_reading {
    bool is_through{true};         ///< else the rest is read in a later turn
    bool has_responded{false};     ///< with a value, or an exception of its own, since its reading began
    bool was_repeated{false};      ///< some response was lost or damaged first
    bool has_fallen_silent{false}; ///< what was asked last has no response
    std::string why{};             ///< it has not
    std::string late{};            ///< of one that was repeated: that its responses come too late, and what would help
    /// As in `device_part::values`, without times; nothing of what was not asked for in this turn.
    std::vector<std::optional<slot_value>> values{};
};

/// Who is at an address.
struct device_finding {
    enum class kind : std::uint8_t {
        right,
        wrong,
        silent,
        open, ///< yet: the rest is asked in a later turn
    };

    kind what{kind::right};
    std::string why{}; ///< or what there is to know of the right one; may be empty
};

struct setting_outcome {
    setting_result result;
    std::string why{};
    bool was_sent{false};    ///< a frame has left that writes
    std::string port_lost{}; ///< why the port failed then; empty where it did not
};

/// Why a setting may not be written after all; nothing where it may.
using setting_look = std::function<std::optional<setting_outcome>()>;

/// All but the clocks end (`ended`, of whatever status) where the port fails.
class asked_line {
public:
    using clock = std::chrono::steady_clock;

    asked_line() = default;
    asked_line(asked_line const&) = delete;
    asked_line& operator=(asked_line const&) = delete;
    virtual ~asked_line() = default;

    /// What is done again and again while a response is waited for, however long that takes.
    void beat_by(std::function<void()> beat) { beat_ = std::move(beat); }

    virtual clock::time_point now() const = 0;
    virtual std::uint64_t unix_time() const = 0; ///< microseconds since 1970
    /// Until then, or so long as it likes; what comes meanwhile is nobody's response.
    virtual void wait(clock::time_point until) = 0;

    /// Answers a request of the line's clients, where one waits, whether or not it is open.
    virtual void serve_one() {}

    /// Whether a device is left alone for a moment, because an answer may come from it yet.
    virtual bool is_left_alone(std::size_t /*device*/) const { return false; }
    /// What is due of it waits for that, and goes before what clients ask of it.
    virtual void keep_turn(std::size_t /*device*/) {}

    virtual void open() = 0;
    virtual void close() = 0;
    /// By one request, sent once, where it is silent as far as anybody knows. In turns, where its responses do not come at once.
    virtual device_finding identify(std::size_t device, bool is_known_silent) = 0;
    virtual part_reading read(std::size_t part) = 0;
    /// Once, where all that `write` looks at allows it, `last_look` has nothing against it when all else is done, and it has not
    /// expired when its frame leaves. In turns, where its device's responses do not come at once: nothing where the rest is for a
    /// later one, and nothing is written yet. The first turn of a request is none that `goes_on`. Where the port fails the outcome
    /// says so.
    virtual std::optional<setting_outcome> write(waiting_setting const& setting, bool goes_on,
                                                 setting_look const& last_look) = 0;
    /// Nothing where it serves none.
    virtual std::optional<client_counts> clients() const { return {}; }
    /// Since it began, over all that was opened.
    virtual exchange_counts const& counts() const = 0;

protected:
    void beat() const
    {
        if (beat_) {
            beat_();
        }
    }

private:
    std::function<void()> beat_{};
};

} // namespace tool::gateway
