// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "check/client_process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "exit_status.hpp"

namespace tool {

namespace {

constexpr std::size_t most_kept = 4'096; ///< of what it complains

/// Values, "ok", "error", or what begins so.
bool is_answer(std::string const& line)
{
    constexpr char const* number = "0123456789 \t\r";
    bool const has_values =
        line.find_first_not_of(number) == line.npos and line.find_first_of("0123456789") != line.npos;
    return has_values or line.starts_with("ok") or line.starts_with("error");
}

} // namespace

client_process::client_process(std::vector<std::string> const& words)
{
    std::array<int, 2> output{}, errors{};
    if (::pipe2(output.data(), O_CLOEXEC) != 0 or ::pipe2(errors.data(), O_CLOEXEC) != 0) {
        throw ended{exit_status::port, std::string{"no pipe for the client: "} + std::strerror(errno)};
    }
    output_ = output[0];
    errors_ = errors[0];
    std::vector<char*> all;
    for (std::string const& each : words) {
        all.push_back(const_cast<char*>(each.c_str()));
    }
    all.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawnattr_t how;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&files, output[1], STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, errors[1], STDERR_FILENO);
    ::posix_spawnattr_init(&how);
    ::posix_spawnattr_setflags(&how, POSIX_SPAWN_SETPGROUP);
    int const wrong = ::posix_spawnp(&pid_, all.front(), &files, &how, all.data(), environ);
    ::posix_spawnattr_destroy(&how);
    ::posix_spawn_file_actions_destroy(&files);
    ::close(output[1]);
    ::close(errors[1]);
    for (int const each : {output_, errors_}) {
        ::fcntl(each, F_SETFL, O_NONBLOCK);
    }
    if (wrong != 0) {
        ::close(output_);
        ::close(errors_);
        refuse_word("the client's command '" + words.front() + "': " + std::strerror(wrong));
    }
}

/// While the number of its group is its own: nobody else has it before its end is taken.
void client_process::end_group()
{
    int status = 0;
    ::kill(-pid_, SIGKILL);
    static_cast<void>(::waitpid(pid_, &status, 0));
    status_ = status;
}

client_process::~client_process()
{
    if (not status_) {
        end_group();
    }
    for (int const each : {output_, errors_}) {
        if (each >= 0) {
            ::close(each);
        }
    }
}

/// False where its end is reached.
bool client_process::take(int& pipe, std::string& text)
{
    std::array<char, 1'024> place;
    while (pipe >= 0) {
        ssize_t const came = ::read(pipe, place.data(), place.size());
        if (came > 0) {
            text.append(place.data(), static_cast<std::size_t>(came));
        } else if (came < 0 and (errno == EAGAIN or errno == EINTR)) {
            return true;
        } else {
            ::close(std::exchange(pipe, -1));
        }
    }
    return false;
}

bool client_process::look()
{
    siginfo_t seen{};
    bool const ends = not status_ and
                      ::waitid(P_PID, static_cast<id_t>(pid_), &seen, WEXITED | WNOHANG | WNOWAIT) == 0 and
                      seen.si_pid == pid_;
    if (ends) {
        end_group();
    }
    bool const has_ended = status_.has_value();
    // What it printed before its end is in the pipes.
    bool const has_more = take(output_, line_);
    static_cast<void>(take(errors_, complaints_));
    if (complaints_.size() > most_kept) {
        complaints_.erase(0, complaints_.size() - most_kept);
    }
    if ((has_ended or not has_more) and not line_.empty() and not line_.ends_with('\n')) {
        line_ += '\n';
    }
    for (std::size_t end = line_.find('\n'); end != line_.npos; end = line_.find('\n')) {
        std::string text = line_.substr(0, end);
        line_.erase(0, end + 1);
        if (is_answer(text)) {
            printed_.push_back({std::chrono::steady_clock::now(), std::move(text)});
        }
    }
    return not has_ended;
}

std::string client_process::last_complaint() const
{
    std::size_t const last = complaints_.find_last_not_of("\r\n ");
    if (last == complaints_.npos) {
        return {};
    }
    std::size_t const before = complaints_.rfind('\n', last);
    std::size_t const from = before == complaints_.npos ? 0 : before + 1;
    return complaints_.substr(from, last + 1 - from);
}

std::string client_process::end() const
{
    if (not status_ or *status_ == 0) {
        return {};
    }
    return WIFSIGNALED(*status_) ? "was ended by signal " + std::to_string(WTERMSIG(*status_))
                                 : "ended with status " + std::to_string(WEXITSTATUS(*status_));
}

} // namespace tool
