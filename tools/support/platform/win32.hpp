// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Windows: what platform/posix.hpp has, in its order.
#pragma once

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

// These first: <windows.h> would bring the first Winsock.
#include <winsock2.h>
#include <ws2tcpip.h>

#include <windows.h>

#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>

#include <unistd.h>

namespace tool {

namespace platform {

/// The numbers of ports are those of handles and sockets, which fit in an int.
inline HANDLE handle_of(int line) noexcept { return reinterpret_cast<HANDLE>(std::intptr_t{line}); }
inline SOCKET socket_of(int line) noexcept { return static_cast<SOCKET>(line); }

inline HANDLE handle_of_descriptor(int descriptor) noexcept
{
    return reinterpret_cast<HANDLE>(::_get_osfhandle(descriptor));
}

inline bool is_socket(int line) noexcept
{
    int kind = 0;
    int size = sizeof kind;
    return ::getsockopt(socket_of(line), SOL_SOCKET, SO_TYPE, reinterpret_cast<char*>(&kind), &size) == 0;
}

/// The console as it was before, which outlives this program.
class console {
public:
    console() noexcept
    {
        if (code_page_ != 0) {
            ::SetConsoleOutputCP(CP_UTF8);
        }
        for (screen& each : screens_) {
            each.is_console = ::GetConsoleMode(each.handle, &each.mode) != 0;
            if (each.is_console) {
                ::SetConsoleMode(each.handle, each.mode | ENABLE_PROCESSED_OUTPUT | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
            }
        }
        restored_ = this;
        std::atexit([] { restored_->restore(); });
        // Asked last of all handlers: where none keeps the program from its end.
        ::SetConsoleCtrlHandler(
            [](DWORD) -> BOOL {
                restored_->restore();
                return FALSE;
            },
            TRUE);
    }

    void restore() const noexcept
    {
        for (screen const& each : screens_) {
            if (each.is_console) {
                ::SetConsoleMode(each.handle, each.mode);
            }
        }
        if (code_page_ != 0) {
            ::SetConsoleOutputCP(code_page_);
        }
    }

private:
    struct screen {
        HANDLE handle;
        DWORD mode{0};
        bool is_console{false};
    };

    static inline console* restored_ = nullptr;
    UINT code_page_{::GetConsoleOutputCP()};
    std::array<screen, 2> screens_{screen{::GetStdHandle(STD_OUTPUT_HANDLE)}, screen{::GetStdHandle(STD_ERROR_HANDLE)}};
};

/// What comes on standard input, read by a thread of its own: no wait of Windows tells that a line is there. The thread is
/// never joined, and what it uses lives as long as it does.
class input_thread {
public:
    std::ptrdiff_t read_within(std::span<char> place, std::chrono::milliseconds limit)
    {
        begin();
        std::unique_lock hold{shared_->lock};
        shared_->news.wait_for(hold, limit, [this] { return not shared_->text.empty() or shared_->has_ended; });
        std::size_t const size = std::min(place.size(), shared_->text.size());
        std::copy_n(shared_->text.begin(), size, place.begin());
        shared_->text.erase(0, size);
        return size > 0 ? static_cast<std::ptrdiff_t>(size) : shared_->has_ended ? 0 : -1;
    }

    void forget()
    {
        ::FlushConsoleInputBuffer(::GetStdHandle(STD_INPUT_HANDLE));
        std::lock_guard const hold{shared_->lock};
        shared_->text.clear();
    }

private:
    struct shared {
        std::mutex lock{};
        std::condition_variable news{};
        std::string text{};
        bool has_ended{false};
    };

    void begin()
    {
        if (not std::exchange(has_begun_, true)) {
            std::thread{[mine = shared_] { read_on(*mine); }}.detach();
        }
    }

    static void read_on(shared& mine)
    {
        HANDLE const input = ::GetStdHandle(STD_INPUT_HANDLE);
        for (bool goes_on = true; goes_on;) {
            std::array<char, 256> place;
            DWORD count = 0;
            bool const is_read =
                ::ReadFile(input, place.data(), static_cast<DWORD>(place.size()), &count, nullptr) != 0;
            // Ctrl-C ends the wait of a console, and no more.
            goes_on = (is_read and count > 0) or (not is_read and ::GetLastError() == ERROR_OPERATION_ABORTED);
            std::lock_guard const hold{mine.lock};
            for (std::size_t i = 0; i < count; ++i) { // a line of Windows ends with two characters
                mine.text.append(place[i] == '\r' ? 0U : 1U, place[i]);
            }
            mine.has_ended = not goes_on;
            mine.news.notify_all();
        }
    }

    std::shared_ptr<shared> shared_{std::make_shared<shared>()};
    bool has_begun_{false};
};

inline input_thread standard_input;

/// A thread that writes texts one at a time, so that a console whose window somebody has clicked into holds up nobody.
class writing_thread {
public:
    explicit writing_thread(int descriptor) : shared_{std::make_shared<shared>(descriptor)} {}

    /// False where it is not written soon, or an earlier text is not yet.
    bool write(std::string_view text)
    {
        constexpr std::chrono::milliseconds soon{50};
        std::unique_lock hold{shared_->lock};
        auto const is_idle = [this] { return shared_->text.empty(); };
        if (not shared_->news.wait_for(hold, soon, is_idle)) {
            return false;
        }
        begin();
        shared_->text = text;
        shared_->news.notify_all();
        return shared_->news.wait_for(hold, soon, is_idle) and shared_->failure == 0;
    }

private:
    struct shared {
        explicit shared(int number) : descriptor{number} {}

        int const descriptor;
        std::mutex lock{};
        std::condition_variable news{};
        std::string text{};
        int failure{0};
    };

    void begin()
    {
        if (not std::exchange(has_begun_, true)) {
            std::thread{[mine = shared_] { write_on(*mine); }}.detach();
        }
    }

    [[noreturn]] static void write_on(shared& mine);

    std::shared_ptr<shared> shared_;
    bool has_begun_{false};
};

} // namespace platform

/// Makes the console one of UTF-8 with escape sequences until the end, and files and pipes those of bytes: a line ends with a
/// line feed, as in the files of other systems.
inline void keep_standard_descriptors() noexcept
{
    for (int const place : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::_get_osfhandle(place) < 0) {
            // The lowest free number is this one: those below are taken.
            ::_open("NUL", place == STDIN_FILENO ? _O_WRONLY : _O_RDONLY);
        }
        ::_setmode(place, _O_BINARY);
    }
    static platform::console const changed;
}

inline bool is_terminal(int descriptor) noexcept
{
    DWORD mode = 0;
    return ::GetConsoleMode(platform::handle_of_descriptor(descriptor), &mode) != 0;
}

/// Of standard input alone.
inline std::ptrdiff_t read_within(int, std::span<char> place, std::chrono::milliseconds limit) noexcept
{
    return platform::standard_input.read_within(place, limit);
}

inline bool is_terminal_own() noexcept { return true; }

inline void flush_typed() noexcept { platform::standard_input.forget(); }

inline std::ptrdiff_t write_some(int descriptor, std::string_view text) noexcept
{
    return ::_write(descriptor, text.data(), static_cast<unsigned>(text.size()));
}

inline int write_blocking(int descriptor, std::string_view text) noexcept
{
    constexpr std::size_t most = 8'192;
    while (not text.empty()) {
        DWORD count = 0;
        auto const size = static_cast<DWORD>(std::min(text.size(), most));
        if (::WriteFile(platform::handle_of_descriptor(descriptor), text.data(), size, &count, nullptr) == 0) {
            DWORD const why = ::GetLastError();
            return why == ERROR_NO_DATA or why == ERROR_BROKEN_PIPE ? EPIPE
                   : why == ERROR_DISK_FULL                         ? ENOSPC
                   : why == ERROR_INVALID_HANDLE                    ? EBADF
                                                                    : EIO;
        }
        text.remove_prefix(count);
    }
    return 0;
}

[[noreturn]] inline void platform::writing_thread::write_on(shared& mine)
{
    std::unique_lock hold{mine.lock};
    for (;;) {
        mine.news.wait(hold, [&mine] { return not mine.text.empty(); });
        std::string const text = mine.text;
        hold.unlock();
        int const failure = write_blocking(mine.descriptor, text);
        hold.lock();
        mine.failure = failure;
        mine.text.clear();
        mine.news.notify_all();
    }
}

inline bool write_at_once(int descriptor, std::string_view text) noexcept
{
    static platform::writing_thread output{STDOUT_FILENO};
    static platform::writing_thread errors{STDERR_FILENO};
    return (descriptor == STDOUT_FILENO ? output : errors).write(text);
}

/// Whether the write that failed just now had nobody who reads.
inline bool is_reader_gone() noexcept
{
    unsigned long const why = _doserrno;
    return errno == EPIPE or why == ERROR_NO_DATA or why == ERROR_BROKEN_PIPE;
}

inline void pause_for(std::chrono::milliseconds time) noexcept { ::Sleep(static_cast<DWORD>(time.count())); }

inline void write_past_port(int line, std::span<std::byte const> frame) noexcept
{
    auto const size = static_cast<DWORD>(frame.size());
    if (platform::is_socket(line)) {
        static_cast<void>(
            ::send(platform::socket_of(line), reinterpret_cast<char const*>(frame.data()), static_cast<int>(size), 0));
        return;
    }
    constexpr DWORD longest = 500; // ms: 260 bytes at 4800 bit/s take 600, and what is written goes on by itself
    OVERLAPPED own{};
    own.hEvent = ::CreateEventW(nullptr, TRUE, FALSE, nullptr);
    if (::WriteFile(platform::handle_of(line), frame.data(), size, nullptr, &own) == 0 and
        ::GetLastError() == ERROR_IO_PENDING and ::WaitForSingleObject(own.hEvent, longest) != WAIT_OBJECT_0) {
        DWORD count = 0;
        ::CancelIoEx(platform::handle_of(line), &own);
        ::GetOverlappedResult(platform::handle_of(line), &own, &count, TRUE);
    }
    ::CloseHandle(own.hEvent);
}

inline std::tm local_time(std::time_t at, long& offset) noexcept
{
    std::tm local{};
    ::localtime_s(&local, &at);
    std::tm same = local; // `_mkgmtime` may change it
    offset = static_cast<long>(::_mkgmtime(&same) - at);
    return local;
}

/// There are none.
class without_signals {
public:
    without_signals() noexcept {}
    without_signals(without_signals const&) = delete;
    without_signals& operator=(without_signals const&) = delete;
};

/// That of a serial port is its handle's.
template <typename Port> int number_of(Port const& port) noexcept
{
    if constexpr (requires { port.handle(); }) {
        auto const number = static_cast<int>(reinterpret_cast<std::intptr_t>(port.handle()));
        return number == 0 ? -1 : number;
    } else {
        return port.descriptor_number();
    }
}

inline pollfd watched_port(int line, short events) noexcept { return {platform::socket_of(line), events, 0}; }

/// A serial port is looked at each millisecond; sockets wait together.
inline int poll_ports(std::span<pollfd> ports, std::chrono::milliseconds limit) noexcept
{
    using clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds look{1};
    std::vector<pollfd> sockets;
    std::vector<pollfd*> serial;
    for (pollfd& each : ports) {
        each.revents = 0;
        int const number = static_cast<int>(each.fd);
        if (number >= 0 and platform::is_socket(number)) {
            sockets.push_back(each);
        } else if (number >= 0) {
            serial.push_back(&each);
        }
    }
    auto const until = clock::now() + limit;
    for (;;) {
        int ready = 0;
        for (pollfd* const each : serial) {
            DWORD errors = 0;
            COMSTAT status{};
            bool const is_there =
                ::ClearCommError(platform::handle_of(static_cast<int>(each->fd)), &errors, &status) != 0;
            bool const has_news = not is_there or errors != 0 or status.cbInQue > 0;
            each->revents = static_cast<short>(not is_there ? POLLERR : has_news ? each->events & POLLIN : 0);
            ready += each->revents != 0 ? 1 : 0;
        }
        auto const left =
            std::max(std::chrono::ceil<std::chrono::milliseconds>(until - clock::now()), std::chrono::milliseconds{0});
        auto const wait = ready > 0 ? std::chrono::milliseconds{0} : serial.empty() ? left : std::min(left, look);
        if (sockets.empty()) {
            ::Sleep(static_cast<DWORD>(wait.count()));
        } else if (int const count =
                       ::WSAPoll(sockets.data(), static_cast<ULONG>(sockets.size()), static_cast<INT>(wait.count()));
                   count > 0) {
            ready += count;
        }
        if (ready > 0 or left.count() == 0) {
            auto next = sockets.begin();
            for (pollfd& each : ports) {
                bool const is_it = next != sockets.end() and each.fd == next->fd;
                each.revents = is_it ? (next++)->revents : each.revents;
            }
            return ready;
        }
    }
}

/// Signals are looked for each 50 ms.
class ending_seen_in_wait {
public:
    void begin() noexcept {}
    int wait(std::span<pollfd> ports, std::chrono::nanoseconds limit) const noexcept
    {
        constexpr std::chrono::milliseconds longest{50};
        return poll_ports(ports, std::min(std::chrono::ceil<std::chrono::milliseconds>(limit), longest));
    }
};

inline std::optional<std::size_t> send_at_once(int line, std::span<std::byte const> bytes) noexcept
{
    int const count = ::send(platform::socket_of(line), reinterpret_cast<char const*>(bytes.data()),
                             static_cast<int>(bytes.size()), 0);
    if (count >= 0) {
        return static_cast<std::size_t>(count);
    }
    return ::WSAGetLastError() == WSAEWOULDBLOCK ? std::optional<std::size_t>{0} : std::nullopt;
}

inline std::optional<std::size_t> receive_at_once(int line, std::span<std::byte> place) noexcept
{
    int const count =
        ::recv(platform::socket_of(line), reinterpret_cast<char*>(place.data()), static_cast<int>(place.size()), 0);
    if (count > 0) {
        return static_cast<std::size_t>(count);
    }
    return count < 0 and ::WSAGetLastError() == WSAEWOULDBLOCK ? std::optional<std::size_t>{0} : std::nullopt;
}

/// A stream of a file, of bytes.
inline std::FILE* open_stream(std::string const& path, std::string mode) noexcept
{
    return std::fopen(path.c_str(), (mode + (mode.find('b') == mode.npos ? "b" : "")).c_str());
}

inline std::FILE* stream_to_read(std::string const& path) noexcept { return open_stream(path, "rb"); }

inline std::FILE* new_stream(std::string const& path) noexcept
{
    int const descriptor =
        ::_open(path.c_str(), _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
    return descriptor < 0 ? nullptr : ::_fdopen(descriptor, "wb");
}

inline int reserve_room(std::FILE* stream, off_t, std::size_t size) noexcept
{
    std::array<wchar_t, 1'024> path{};
    ULARGE_INTEGER left{};
    bool const is_known =
        ::GetFinalPathNameByHandleW(platform::handle_of_descriptor(::_fileno(stream)), path.data(),
                                    static_cast<DWORD>(path.size()), FILE_NAME_NORMALIZED) != 0 and
        ::GetDiskFreeSpaceExW(std::filesystem::path{path.data()}.parent_path().c_str(), &left, nullptr, nullptr) != 0;
    return is_known and left.QuadPart < size ? ENOSPC : 0;
}

/// "COM3", "com10", and what begins with \\\\.\\.
inline bool is_port_name(std::string_view word) noexcept
{
    constexpr std::string_view letters = "COM";
    bool is_com = word.size() > letters.size() and word.find_first_not_of("0123456789", letters.size()) == word.npos;
    for (std::size_t i = 0; i < letters.size() and is_com; ++i) {
        is_com = word[i] == letters[i] or word[i] == letters[i] + ('a' - 'A');
    }
    return is_com or word.starts_with("\\\\.\\");
}

#define TOOL_HOME "LOCALAPPDATA"

#define TOOL_CONFIGURATION "%APPDATA%\\rtuwire\\rtuwire.toml"

constexpr char const* example_port = "COM3";

inline std::string with_own_words(std::string text)
{
    struct own_word {
        std::string_view other, own;
    };
    // "DP*" and group: are the same to cmd and to PowerShell.
    constexpr own_word all[]{{"/dev/ttyUSB0", example_port},
                             {"/dev/ttyUSB1", "COM4"},
                             {"/dev/pts/4", "COM4"},
                             {"--from pty", "--from tcp://127.0.0.1:4001"},
                             {"rtuwire simulate", "rtuwire -p mbap://127.0.0.1:1502 simulate"},
                             {"'DP*'", "\"DP*\""},
                             {"'*'", "\"*\""},
                             {" @monitor 3202", " group:monitor 3202"}};
    for (auto const& [other, own] : all) {
        for (std::size_t at = text.find(other); at != text.npos; at = text.find(other, at + own.size())) {
            text.replace(at, other.size(), own);
        }
    }
    return text;
}

inline std::string quoted(std::string const& word)
{
    constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_\\/.:=@+-";
    bool const is_plain = not word.empty() and word.find_first_not_of(plain) == std::string::npos;
    return is_plain ? word : '"' + word + '"';
}

/// Where a user's own things of that kind are: settings, states, data.
enum class user_folder { configuration, state, data };

inline std::string folder_of_user(user_folder which)
{
    char const* const folder = std::getenv(which == user_folder::configuration ? "APPDATA" : "LOCALAPPDATA");
    return folder == nullptr ? std::string{}
                             : std::string{folder} + (which == user_folder::configuration ? "\\rtuwire" : "");
}

/// This program's own file.
inline std::string own_path()
{
    std::wstring wide(32'768, L'\0');
    wide.resize(::GetModuleFileNameW(nullptr, wide.data(), static_cast<DWORD>(wide.size())));
    std::string text(wide.size() * 3, '\0');
    text.resize(
        static_cast<std::size_t>(::WideCharToMultiByte(CP_UTF8, 0, wide.data(), static_cast<int>(wide.size()),
                                                       text.data(), static_cast<int>(text.size()), nullptr, nullptr)));
    return text;
}

inline std::string name_of_user()
{
    char const* const name = std::getenv("USERNAME");
    return name == nullptr ? "?" : name;
}

} // namespace tool
