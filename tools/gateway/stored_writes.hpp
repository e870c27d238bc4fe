// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// When registers were written that their devices store: such a memory bears a limited number of writes. The lines of a gateway
// have one of it, which knows them beyond a line's end and its own.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "state_file.hpp"

namespace tool::gateway {

/// A name of this start of the machine, which no other has; empty where the system has none.
std::string this_boot();

class stored_writes {
public:
    using clock = std::chrono::steady_clock;

    /// Between two writes of a register.
    static constexpr std::chrono::seconds least_interval{60};

    /// `unix_time` in microseconds since 1970, as all times of the calendar here. `boot` names this start of the machine, during
    /// which the calendar of the record does not count; empty: nobody knows. Behind another start a write that the record puts
    /// ahead of now, since the calendar was set back, is taken for one of now. Where the record is damaged all registers are.
    stored_writes(std::string folder, std::string owner, std::uint64_t unix_time, clock::time_point now,
                  std::string boot = {});

    /// Notes the write of registers that is about to leave, on the disk when this returns. Why it may not; empty where it may.
    [[nodiscard]] std::string claim(std::vector<std::string> const& registers, std::uint64_t unix_time,
                                    clock::time_point now);

    /// What was wrong with the record since the last call, a sentence; empty where nothing was.
    [[nodiscard]] std::string take_trouble();

private:
    bool is_too_soon(std::string const& which, clock::time_point now) const;
    void forget_old(clock::time_point now);

    std::mutex guard_{};
    state_file file_;
    std::string boot_;
    std::string trouble_{};
    std::map<std::string, clock::time_point> written_{}; ///< last, by the clock that nobody sets
    clock::time_point unknown_until_{};                  ///< until then none is written: what was, is not known
};

} // namespace tool::gateway
