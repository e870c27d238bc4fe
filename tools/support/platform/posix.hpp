// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// POSIX: standard input and outputs, waiting, the time zone, and frames past the port.
#pragma once

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include <arpa/inet.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <pwd.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

namespace tool {

/// A program may be started with its standard input, output or error output closed. Whatever it opens first then gets that
/// number, and its text would go there. So something is put in each of the three places that is empty: reading from it and
/// writing to it fail, as they would with the closed one, and whoever prints is told that nobody gets it.
inline void keep_standard_descriptors() noexcept
{
    for (int const place : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(place, F_GETFD) < 0) {
            // The lowest free number is this one: those below are taken.
            ::open("/dev/null", place == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        }
    }
}

inline bool is_terminal(int descriptor) noexcept { return ::isatty(descriptor) == 1; }

/// Waits at most so long for bytes of a descriptor, and reads what is there: how many; 0 where nobody can write any more,
/// -1 where nothing came.
inline std::ptrdiff_t read_within(int descriptor, std::span<char> place, std::chrono::milliseconds limit) noexcept
{
    pollfd watched{descriptor, POLLIN, 0};
    if (::poll(&watched, 1, static_cast<int>(limit.count())) <= 0) {
        return -1;
    }
    return std::max<std::ptrdiff_t>(::read(descriptor, place.data(), place.size()), 0);
}

/// In the background the terminal is somebody else's. One that controls nothing has no foreground.
inline bool is_terminal_own() noexcept
{
    pid_t const foreground = ::tcgetpgrp(STDIN_FILENO);
    return foreground == -1 or foreground == ::getpgrp();
}

/// Throws away what was typed on the terminal of the standard input, and nobody has read.
inline void flush_typed() noexcept { ::tcflush(STDIN_FILENO, TCIFLUSH); }

/// As ::write.
inline std::ptrdiff_t write_some(int descriptor, std::string_view text) noexcept
{
    return ::write(descriptor, text.data(), text.size());
}

/// Writes all of a text, however long that takes: 0, or the system's number of the failure.
inline int write_blocking(int descriptor, std::string_view text) noexcept
{
    while (not text.empty()) {
        ssize_t const count = ::write(descriptor, text.data(), text.size());
        if (count >= 0) {
            text.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno == EAGAIN) {
            pollfd watched{descriptor, POLLOUT, 0};
            ::poll(&watched, 1, -1);
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

/// Writes as much as is taken at once; whether that was all. A signal handler may call it. Does not change the descriptor's
/// flags, which others share.
inline bool write_at_once(int descriptor, std::string_view text) noexcept
{
    // A pipe that can be written takes PIPE_BUF bytes; of a terminal only the next character is known to be taken.
    struct stat found {};
    bool const is_terminal = ::fstat(descriptor, &found) == 0 and S_ISCHR(found.st_mode);
    std::size_t const most = is_terminal ? 1 : PIPE_BUF;
    while (not text.empty()) {
        pollfd watched{descriptor, POLLOUT, 0};
        int const ready = ::poll(&watched, 1, 0);
        bool const is_interrupted = ready < 0 and errno == EINTR;
        if (not is_interrupted and (ready <= 0 or (watched.revents & POLLOUT) == 0)) {
            return false;
        }
        ssize_t const count = is_interrupted ? 0 : ::write(descriptor, text.data(), std::min(text.size(), most));
        if (count < 0 and errno != EINTR) {
            return false;
        }
        text.remove_prefix(count < 0 ? 0 : static_cast<std::size_t>(count));
    }
    return true;
}

/// Whether the write that failed just now had nobody who reads.
inline bool is_reader_gone() noexcept { return errno == EPIPE; }

/// Lets time pass, all of it; a signal handler may call it.
inline void pause_for(std::chrono::milliseconds time) noexcept
{
    timespec left{static_cast<std::time_t>(time.count() / 1'000), static_cast<long>(time.count() % 1'000) * 1'000'000};
    while (::nanosleep(&left, &left) != 0 and errno == EINTR) {
    }
}

/// Writes a frame straight to a port, past whatever has it open; a signal handler may call it. The port does not block: what
/// it does not take is lost.
inline void write_past_port(int line, std::span<std::byte const> frame) noexcept
{
    while (::write(line, frame.data(), frame.size()) < 0 and errno == EINTR) {
    }
}

/// A moment in the zone of this system, and how far that is east of UTC, in seconds.
inline std::tm local_time(std::time_t at, long& offset) noexcept
{
    std::tm local{};
    ::localtime_r(&at, &local);
    offset = local.tm_gmtoff;
    return local;
}

/// While it lives, this thread and those that it starts get no signals: they are for the threads that the program knows.
class without_signals {
public:
    without_signals() noexcept
    {
        sigset_t all{};
        sigfillset(&all);
        ::pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    without_signals(without_signals const&) = delete;
    without_signals& operator=(without_signals const&) = delete;
    ~without_signals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

private:
    sigset_t before_{};
};

/// The system's number of a port; -1 where none is open.
template <typename Port> int number_of(Port const& port) noexcept { return port.descriptor_number(); }

inline pollfd watched_port(int line, short events) noexcept { return {line, events, 0}; }

/// Waits for ports as ::poll does, at most so long.
inline int poll_ports(std::span<pollfd> ports, std::chrono::milliseconds limit) noexcept
{
    return ::poll(ports.data(), static_cast<nfds_t>(ports.size()), static_cast<int>(limit.count()));
}

/// The signals that end `serve`, which are seen where it waits, and nowhere else.
class ending_seen_in_wait {
public:
    /// Until it begins, its thread's waits let through what the thread does.
    ending_seen_in_wait() noexcept { ::pthread_sigmask(SIG_BLOCK, nullptr, &unblocked_); }

    void begin() noexcept
    {
        sigset_t ending{};
        sigemptyset(&ending);
        for (int const each : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
            sigaddset(&ending, each);
        }
        ::sigprocmask(SIG_BLOCK, &ending, &unblocked_);
    }

    /// Waits as ::ppoll does, at most so long.
    int wait(std::span<pollfd> ports, std::chrono::nanoseconds limit) const noexcept
    {
        auto const seconds = std::chrono::duration_cast<std::chrono::seconds>(limit);
        timespec const left{static_cast<std::time_t>(seconds.count()), static_cast<long>((limit - seconds).count())};
        return ::ppoll(ports.data(), static_cast<nfds_t>(ports.size()), &left, &unblocked_);
    }

private:
    sigset_t unblocked_{};
};

/// What a connection takes at once; nothing where it is gone.
inline std::optional<std::size_t> send_at_once(int line, std::span<std::byte const> bytes) noexcept
{
#ifdef MSG_NOSIGNAL
    constexpr int how = MSG_NOSIGNAL | MSG_DONTWAIT;
#else
    constexpr int how = MSG_DONTWAIT; // SIGPIPE is ignored
#endif
    ssize_t const count = ::send(line, bytes.data(), bytes.size(), how);
    if (count >= 0) {
        return static_cast<std::size_t>(count);
    }
    return errno == EAGAIN or errno == EINTR ? std::optional<std::size_t>{0} : std::nullopt;
}

/// Reads what a connection has: how many bytes, 0 where there are none now; nothing where the other end is gone.
inline std::optional<std::size_t> receive_at_once(int line, std::span<std::byte> place) noexcept
{
    ssize_t const count = ::recv(line, place.data(), place.size(), 0);
    if (count > 0) {
        return static_cast<std::size_t>(count);
    }
    return count < 0 and (errno == EAGAIN or errno == EINTR) ? std::optional<std::size_t>{0} : std::nullopt;
}

/// A stream of a file, which no other program inherits.
inline std::FILE* open_stream(std::string const& path, std::string const& mode) noexcept
{
    return std::fopen(path.c_str(), (mode + 'e').c_str());
}

/// The same of a file of bytes that is there. Nor does one wait for more, as /proc/kmsg does, which calls itself a regular
/// file.
inline std::FILE* stream_to_read(std::string const& path) noexcept
{
    int const descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    return descriptor < 0 ? nullptr : ::fdopen(descriptor, "rb");
}

/// The same of a new file, of bytes; nothing where there is one of that name already.
inline std::FILE* new_stream(std::string const& path) noexcept
{
    int const descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NONBLOCK | O_CLOEXEC, 0666);
    return descriptor < 0 ? nullptr : ::fdopen(descriptor, "wb");
}

/// Keeps room for so many bytes behind the end of a file, where its file system can. Why not, by the system's number; 0 where
/// nothing is known to speak against it.
inline int reserve_room(std::FILE* stream, off_t end, std::size_t size) noexcept
{
    rlimit most{};
    if (::getrlimit(RLIMIT_FSIZE, &most) == 0 and most.rlim_cur != RLIM_INFINITY and
        static_cast<rlim_t>(end) + size > most.rlim_cur) {
        return EFBIG;
    }
#ifdef FALLOC_FL_KEEP_SIZE
    if (::fallocate(::fileno(stream), FALLOC_FL_KEEP_SIZE, end, static_cast<off_t>(size)) != 0 and
        (errno == ENOSPC or errno == EDQUOT or errno == EFBIG)) { // others cannot keep room
        return errno;
    }
#endif
    return 0;
}

/// Whether a word is the name of a port that no file system has.
inline bool is_port_name(std::string_view) noexcept { return false; }

/// What names the place of states.
#define TOOL_HOME "HOME or XDG_STATE_HOME"

/// Where the configuration is, in words.
#define TOOL_CONFIGURATION "$XDG_CONFIG_HOME/rtuwire.toml"

/// What a serial port is called here.
constexpr char const* example_port = "/dev/ttyUSB0";

/// A text for people whose examples are those of this system: its ports, and words as its shells take them.
inline std::string with_own_words(std::string text) { return text; }

/// A word as a shell takes it.
inline std::string quoted(std::string const& word)
{
    constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_/.:,=@%+-";
    if (not word.empty() and word.find_first_not_of(plain) == std::string::npos) {
        return word;
    }
    std::string text{"'"};
    for (char const each : word) {
        text += each == '\'' ? std::string{"'\\''"} : std::string{each};
    }
    return text + "'";
}

/// Where a user's own things of that kind are: settings, states, data.
enum class user_folder { configuration, state, data };

/// Empty where there is none. A relative one is left out, as the XDG Base Directory Specification says, but of the
/// configuration.
inline std::string folder_of_user(user_folder which)
{
    auto const variable = [](char const* name) {
        char const* const value = std::getenv(name);
        return value == nullptr ? std::string{} : std::string{value};
    };
    bool const is_configuration = which == user_folder::configuration;
    std::string const named = variable(is_configuration              ? "XDG_CONFIG_HOME"
                                       : which == user_folder::state ? "XDG_STATE_HOME"
                                                                     : "XDG_DATA_HOME");
    if (is_configuration ? not named.empty() : named.starts_with('/')) {
        return named;
    }
    std::string const home = variable("HOME");
    return home.empty() ? home
                        : home + (is_configuration              ? "/.config"
                                  : which == user_folder::state ? "/.local/state"
                                                                : "/.local/share");
}

/// This program's own file; empty where the system does not tell.
inline std::string own_path()
{
    std::error_code failure;
    return std::filesystem::read_symlink("/proc/self/exe", failure).string();
}

inline std::string name_of_user()
{
    passwd const* const entry = ::getpwuid(::getuid());
    return entry == nullptr ? std::to_string(::getuid()) : std::string{entry->pw_name};
}

} // namespace tool
