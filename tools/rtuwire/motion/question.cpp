// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/question.hpp"

#include <chrono>
#include <cstddef>

#include "../support/platform.hpp"
#include "../support/say.hpp"
#include "../support/signals.hpp"
#include "motion/typed_lines.hpp"
#include "output/plain_text.hpp"
#include "words/words.hpp"

namespace tool {

bool is_asked(permissions const& allowed) { return not allowed.is_confirmed and is_terminal(STDIN_FILENO); }

bool is_answered_yes(char const* question)
{
    constexpr std::chrono::milliseconds look_every{100};
    constexpr std::size_t longest = 256;
    forget_typed();
    error_output.put(std::string{question} + " (y/n) ");
    bool is_shown = false;
    std::string answer;
    while (noted.end == 0 and noted.suspend == 0 and error_output.failure() == 0 and answer.size() < longest) {
        if (not is_shown) { // a terminal that was stopped (Ctrl-S) must not keep this program from ending
            is_shown = error_output.finish(look_every);
            if (not is_shown) {
                forget_typed();
            }
        } else {
            char place[longest];
            std::ptrdiff_t const size = read_within(STDIN_FILENO, place, look_every);
            if (size == 0) {
                return false;
            }
            answer.append(place, size > 0 ? static_cast<std::size_t>(size) : 0);
            if (std::size_t const end = answer.find_first_of("\r\n"); end != std::string::npos) {
                forget_typed();
                answer = lower(answer.substr(0, end));
                return answer == "y" or answer == "yes";
            }
        }
    }
    forget_typed();
    return false;
}

bool may_go_on(permissions const& allowed, std::string const& what, char const* question)
{
    error_output.put(plain_text(what) + "\n");
    if (is_asked(allowed)) {
        return is_answered_yes(question);
    }
    error_output.finish(std::chrono::milliseconds{300});
    return noted.end == 0;
}

} // namespace tool
