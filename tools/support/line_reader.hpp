// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lines from a descriptor, read without waiting for them.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include "platform.hpp"

namespace tool {

class line_reader {
public:
    explicit line_reader(int descriptor) : descriptor_{descriptor} {}

    /// The next line without its end, if there is a whole one.
    std::optional<std::string> next()
    {
        read_on();
        auto const end = text_.find('\n');
        if (end == std::string::npos) {
            return std::nullopt;
        }
        std::string line = text_.substr(0, end);
        text_.erase(0, end + 1);
        return line;
    }

    /// Whether nobody can write any more.
    bool has_ended() const { return has_ended_; }

private:
    void read_on()
    {
        if (has_ended_) {
            return;
        }
        char some[128];
        std::ptrdiff_t const count = read_within(descriptor_, some, std::chrono::milliseconds{0});
        if (count < 0) {
            return;
        }
        has_ended_ = count == 0;
        text_.append(some, static_cast<std::size_t>(count));
    }

    int descriptor_;
    std::string text_{};
    bool has_ended_{false};
};

} // namespace tool
