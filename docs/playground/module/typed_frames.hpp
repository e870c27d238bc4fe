// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The end of the line that sends what a person typed, as it is, once the line is free: as a second client would.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <rtuwire/client.hpp>

namespace playground {

class typed_frames {
public:
    /// Bytes that wait for the line to be free; refused while others wait.
    [[nodiscard]] bool give(rtuwire::byte_view bytes)
    {
        bool const is_taken = waiting_.empty();
        if (is_taken) {
            waiting_.assign(bytes.begin(), bytes.end());
        }
        return is_taken;
    }

    /// Says in each pass whether the line is free.
    void note_line(bool is_free) noexcept { is_free_ = is_free; }

    /// Whether it sent these bytes last; true once.
    [[nodiscard]] bool take_sent(rtuwire::byte_view bytes) noexcept
    {
        bool const is_own = not bytes.empty() and rtuwire::byte_view{last_}.size() == bytes.size() and
                            std::equal(bytes.begin(), bytes.end(), last_.begin());
        if (is_own) {
            last_.clear();
        }
        return is_own;
    }

    // As an end of the line.
    void receive(rtuwire::byte_view, rtuwire::instant) noexcept {}
    void receive_error(rtuwire::instant) noexcept {}
    void sent(rtuwire::instant) noexcept {}
    void advance(rtuwire::instant) noexcept {}
    rtuwire::byte_view poll_transmit() noexcept
    {
        if (not is_free_ or waiting_.empty()) {
            return {};
        }
        sending_ = std::exchange(waiting_, {});
        last_ = sending_;
        return sending_;
    }
    static rtuwire::deadline poll_deadline() noexcept { return {}; }

private:
    std::vector<std::byte> waiting_{};
    std::vector<std::byte> sending_{};
    std::vector<std::byte> last_{};
    bool is_free_{false};
};

} // namespace playground
