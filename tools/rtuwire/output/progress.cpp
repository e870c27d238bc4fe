// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "output/progress.hpp"

#include "../support/platform.hpp"
#include "output/passing_text.hpp"

namespace tool {

std::string time_in_words(std::chrono::seconds time)
{
    auto const seconds = time.count();
    auto const text = [](auto number, char const* unit) { return std::to_string(number) + unit; };
    if (seconds < 60) {
        return text(seconds, " s");
    }
    if (seconds < 3'600) {
        return text(seconds / 60, " min ") + text(seconds % 60, " s");
    }
    return text(seconds / 3'600, " h ") + text(seconds / 60 % 60, " min");
}

progress::progress(std::size_t steps) : steps_{steps}, is_terminal_{is_terminal(STDERR_FILENO)} {}

progress::~progress() { clear(); }

std::string progress::line_of(std::size_t done, std::string const& note) const
{
    std::string text = std::to_string(done) + " of " + std::to_string(steps_) + note;
    if (done > first_ and done < steps_) {
        auto const spent = std::chrono::steady_clock::now() - began_;
        auto const left = spent / static_cast<long>(done - first_) * static_cast<long>(steps_ - done);
        text += ", " + time_in_words(std::chrono::ceil<std::chrono::seconds>(left)) + " left";
    }
    return text;
}

void progress::show(std::size_t done, std::string const& note)
{
    if (not has_begun_) {
        has_begun_ = true;
        first_ = done;
        began_ = std::chrono::steady_clock::now();
    }
    std::size_t const tenths = steps_ == 0 ? 10 : done * 10 / steps_;
    if (is_terminal_) {
        tell_at_once('\r' + line_of(done, note) + "\x1b[K");
        is_on_screen_ = true;
    } else if (tenths != shown_tenths_) {
        shown_tenths_ = tenths;
        tell_at_once(line_of(done, note) + '\n');
    }
}

void progress::clear()
{
    if (is_on_screen_) {
        tell_at_once("\r\x1b[K");
        is_on_screen_ = false;
    }
}

} // namespace tool
