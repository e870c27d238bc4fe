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

/// How an order ended; the page shows each in a colour of its own.
enum class ending : std::uint8_t {
    open, ///< it has not ended
    not_done,
    done_otherwise, ///< at the drive's limit, or by another stop than the one ordered
    done,
};

struct noted_order {
    std::uint32_t number;
    std::string what;
    std::string outcome{};
    playground::ending ending{playground::ending::open};
    std::uint64_t given_us{0};
};

class order_log {
public:
    /// The oldest that has ended makes room; an order that is under way stays, so that its end can be told.
    std::uint32_t add(std::string what, std::uint64_t now_us)
    {
        orders_.push_back({.number = next_, .what = std::move(what), .given_us = now_us});
        if (orders_.size() > most) {
            auto oldest = orders_.begin();
            while (oldest->ending == ending::open) {
                ++oldest; // at most one of each kind is under way
            }
            orders_.erase(oldest);
        }
        return next_++;
    }

    void end(std::uint32_t number, std::string outcome, ending how)
    {
        for (noted_order& each : orders_) {
            if (each.number == number) {
                each.outcome = std::move(outcome);
                each.ending = how;
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
            out.put("ending", static_cast<unsigned>(each.ending));
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
