// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How an act ends that must end the program: it is done in a child process, and looked at from outside.
#pragma once

#include <csignal>
#include <initializer_list>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace rtuwire::test {

/// Where a hook of the test's program can leave a word before the program ends: the write end of a pipe, -1
/// outside of a child.
inline int last_words = -1;

/// How a child ended.
struct end {
    bool is_trap{false};   ///< killed by the signal that a trap raises
    bool is_return{false}; ///< it lived on and left
    int left{-1};          ///< the byte written to `last_words`, -1 for none
    std::string said{};    ///< what it wrote to its standard error
};

/// Does `act` in a child. Its signals are the system's, not those of the test's runner.
template <typename Act> end end_of(Act act)
{
    int ends[2];
    int words[2];
    if (pipe(ends) != 0 or pipe(words) != 0) {
        return {};
    }
    pid_t const child = fork();
    if (child == 0) {
        for (int const each : {SIGILL, SIGTRAP, SIGABRT, SIGSEGV, SIGBUS, SIGFPE}) {
            std::signal(each, SIG_DFL);
        }
        close(ends[0]);
        dup2(words[1], STDERR_FILENO);
        last_words = ends[1];
        act();
        _exit(0);
    }
    close(ends[1]);
    close(words[1]);
    end found;
    unsigned char byte = 0;
    if (::read(ends[0], &byte, 1) == 1) {
        found.left = byte;
    }
    close(ends[0]);
    char text[256];
    for (ssize_t size = 0; (size = ::read(words[0], text, sizeof text)) > 0;) {
        found.said.append(text, static_cast<std::size_t>(size));
    }
    close(words[0]);
    int status = 0;
    if (child < 0 or waitpid(child, &status, 0) != child) {
        return {};
    }
    found.is_trap = WIFSIGNALED(status) and (WTERMSIG(status) == SIGILL or WTERMSIG(status) == SIGTRAP);
    found.is_return = WIFEXITED(status) and WEXITSTATUS(status) == 0;
    return found;
}

} // namespace rtuwire::test
