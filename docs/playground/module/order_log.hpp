// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The orders that were given, the newest last, and how each of them ended.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "json.hpp"

namespace playground {

struct noted_order {
    std::uint32_t number;
    std::string what;
    std::string outcome{}; ///< empty until it has ended
    bool is_done{false};   ///< it ended as it was meant to
    std::uint64_t given_us{0};
};

class order_log {
public:
    std::uint32_t add(std::string what, std::uint64_t now_us)
    {
        orders_.push_back({.number = next_, .what = std::move(what), .given_us = now_us});
        if (orders_.size() > most) {
            orders_.erase(orders_.begin());
        }
        return next_++;
    }

    void end(std::uint32_t number, std::string outcome, bool is_done)
    {
        for (noted_order& each : orders_) {
            if (each.number == number) {
                each.outcome = std::move(outcome);
                each.is_done = is_done;
            }
        }
    }

    void put(json_text& out) const
    {
        out.open_list("orders");
        for (noted_order const& each : orders_) {
            out.open_object();
            out.put("number", each.number);
            out.put("what", each.what);
            out.put("outcome", each.outcome);
            out.put("ended", not each.outcome.empty());
            out.put("done", each.is_done);
            out.put("given", each.given_us);
            out.close_object();
        }
        out.close_list();
    }

private:
    static constexpr std::size_t most = 12;

    std::vector<noted_order> orders_{};
    std::uint32_t next_{0};
};

} // namespace playground
