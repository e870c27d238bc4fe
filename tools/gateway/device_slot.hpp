// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a line's thread knows of a device, for whoever publishes it: the newest round is there, whether or not the one before
// was taken. Both sides only change a pointer under the lock, so that the line never waits for a broker.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "output/record.hpp"

namespace tool::gateway {

enum class value_state : std::uint8_t {
    not_read, ///< since the gateway began, or since the device was lost: there is no value
    valid,
    invalid, ///< the device says that it has no value, or it is outside its limits
    failed,  ///< the device refused it, or its response was damaged
};

struct slot_value {
    value_state state{value_state::not_read};
    cell value{};          ///< nothing where it is not valid
    std::uint64_t time{0}; ///< microseconds since 1970, when its round began; 0: of none
    std::uint64_t seq{0};  ///< of its round
    std::string why{};     ///< it has no value, for people; empty of a valid one
};

struct slot_content {
    std::uint64_t time{0}; ///< of the last change
    std::uint64_t seq{0};  ///< of the last change: rises by one for each, of each device by itself, and never falls
    bool is_available{false};
    std::string why{};                ///< it is not; empty while it is
    std::vector<slot_value> values{}; ///< as in `device_plan::values`
};

class device_slot {
public:
    using content = std::shared_ptr<slot_content const>;

    explicit device_slot(std::size_t values) : newest_{std::make_shared<slot_content const>(empty(values))} {}

    /// By the line.
    void put(content newest)
    {
        std::scoped_lock const held{guard_};
        newest_.swap(newest);
    } // the one before ends behind the lock

    /// What there is now, `seq` 0 before the first round. A value is newer than what was published before where its `seq` is
    /// above that one's.
    [[nodiscard]] content newest() const
    {
        std::scoped_lock const held{guard_};
        return newest_;
    }

private:
    static slot_content empty(std::size_t values)
    {
        slot_content nothing{.why = "not read yet"};
        nothing.values.resize(values);
        return nothing;
    }

    mutable std::mutex guard_{};
    content newest_;
};

} // namespace tool::gateway
