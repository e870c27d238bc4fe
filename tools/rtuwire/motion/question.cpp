// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/question.hpp"

#include <chrono>

#include <poll.h>
#include <unistd.h>

#include "../support/say.hpp"
#include "../support/signals.hpp"
#include "motion/typed_lines.hpp"
#include "output/plain_text.hpp"
#include "words/words.hpp"

namespace tool {

bool is_asked(permissions const& allowed) { return not allowed.is_confirmed and ::isatty(STDIN_FILENO) == 1; }

bool is_answered_yes(char const* question)
{
    constexpr int look_every = 100; // ms
    constexpr std::size_t longest = 256;
    forget_typed();
    error_output.put(std::string{question} + " (y/n) ");
    pollfd watched{STDIN_FILENO, POLLIN, 0};
    bool is_shown = false;
    std::string answer;
    while (noted.end == 0 and noted.suspend == 0 and error_output.failure() == 0 and answer.size() < longest) {
        if (not is_shown) { // a terminal that was stopped (Ctrl-S) must not keep this program from ending
            is_shown = error_output.finish(std::chrono::milliseconds{look_every});
            if (not is_shown) {
                forget_typed();
            }
        } else if (::poll(&watched, 1, look_every) > 0) {
            char place[longest];
            auto const size = ::read(STDIN_FILENO, place, sizeof place);
            if (size <= 0) {
                return false;
            }
            answer.append(place, static_cast<std::size_t>(size));
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
