// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line on the standard error for each change, and with --json an object on standard output. What is not taken at once is
// dropped: nothing waits for who reads it.
#pragma once

#include <cstdint>
#include <string>

namespace tool::gateway {

struct gateway_event {
    std::string name;   ///< "broker_lost"
    std::string text;   ///< for people
    std::string line{}; ///< empty where it is of none
    std::string device{};
    std::uint64_t time{0}; ///< microseconds since 1970; 0: now
};

class gateway_log {
public:
    explicit gateway_log(bool has_json) noexcept : has_json_{has_json} {}

    void tell(gateway_event const& event) const;

private:
    bool has_json_;
};

} // namespace tool::gateway
