// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A serial device that a program opened is free again when the program is done with it, although another
// process has it open all the time. Root may open a locked device, so all of it runs as a user who may not.
#include <rtuwire/port/posix_serial.hpp>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include <grp.h>
#include <sys/wait.h>

#include "support/catch.hpp"

#include <rtuwire/port/pseudo_terminal.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr int rounds = 100;
constexpr ::uid_t nobody = 65'534;

/// Runs `check` in a process of a user who is not root; 0, or the number that it returned.
template <typename Check> int as_a_normal_user(Check check)
{
    std::fflush(nullptr);
    ::pid_t const child = ::fork();
    if (child == 0) {
        bool const is_normal = ::geteuid() != 0 or (::setgroups(0, nullptr) == 0 and ::setgid(nobody) == 0 and
                                                    ::setuid(nobody) == 0 and ::geteuid() != 0);
        std::_Exit(is_normal ? check() : 99);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    return child > 0 and WIFEXITED(status) ? WEXITSTATUS(status) : 98;
}

/// Another process, which has a device open from before the test until its end.
class other_process {
public:
    explicit other_process(std::string const& device)
    {
        int ends[2];
        if (::pipe(ends) != 0) {
            return;
        }
        child_ = ::fork();
        if (child_ == 0) {
            int const number = ::open(device.c_str(), O_RDWR | O_NOCTTY);
            char const response = number >= 0 ? 'y' : 'n';
            static_cast<void>(::write(ends[1], &response, 1) == 1);
            for (;;) {
                ::pause();
            }
        }
        char response = 'n';
        has_device_ = ::read(ends[0], &response, 1) == 1 and response == 'y';
        ::close(ends[0]);
        ::close(ends[1]);
    }
    other_process(other_process const&) = delete;
    other_process& operator=(other_process const&) = delete;
    ~other_process()
    {
        if (child_ > 0) {
            ::kill(child_, SIGKILL);
            ::waitpid(child_, nullptr, 0);
        }
    }

    bool has_device() const { return has_device_; }

private:
    ::pid_t child_{-1};
    bool has_device_{false};
};

/// Whether this user can open a device, and lock it.
bool is_free(std::string const& device)
{
    descriptor const look{::open(device.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)};
    return look.is_open() and ::flock(look.number(), LOCK_EX | LOCK_NB) == 0;
}

/// A line that another process has open, too, and that this user could be locked out of.
struct shared_line {
    pseudo_terminal near{};
    bool is_open{near.open().has_value()};
    std::string const device{near.path()};
    other_process const other{device};

    bool is_ready() const { return is_open and other.has_device() and bites(); }

private:
    bool bites() const
    {
        descriptor const lock{::open(device.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)};
        bool const is_locked =
            lock.is_open() and ::ioctl(lock.number(), TIOCEXCL) == 0 and not is_free(device) and errno == EBUSY;
        return is_locked and ::ioctl(lock.number(), TIOCNXCL) == 0 and is_free(device);
    }
};

#define EXPECT(...)                                                                                                    \
    if (not(__VA_ARGS__)) {                                                                                            \
        std::fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #__VA_ARGS__);                                 \
        return 1;                                                                                                      \
    }

int open_and_leave()
{
    shared_line const line;
    EXPECT(line.is_ready());
    for (int i = 0; i < rounds; ++i) {
        {
            posix_serial port;
            EXPECT(port.open(line.device));
            EXPECT(not is_free(line.device));
        }
        EXPECT(is_free(line.device));
    }
    return 0;
}

int open_and_close()
{
    shared_line const line;
    EXPECT(line.is_ready());
    posix_serial port;
    for (int i = 0; i < rounds; ++i) {
        EXPECT(port.open(line.device));
        port.close();
        EXPECT(is_free(line.device));
    }
    return 0;
}

int open_again()
{
    shared_line const first;
    shared_line const second;
    EXPECT(first.is_ready() and second.is_ready());
    posix_serial port;
    for (int i = 0; i < rounds; ++i) {
        EXPECT(port.open(first.device));
        EXPECT(port.open(second.device));
        EXPECT(is_free(first.device) and not is_free(second.device));
    }
    return 0;
}

int fail_to_open()
{
    shared_line const line;
    EXPECT(line.is_ready());
    posix_serial port;
    for (int i = 0; i < rounds; ++i) {
        EXPECT(port.open("/dev/null") == errc::device_not_serial);
        EXPECT(port.open("/dev/rtuwire-does-not-exist") == errc::device_not_found);
        // Refused when the device is locked already.
        EXPECT(port.open(line.device, {.bits_per_second = 49}) == errc::device_setting_refused);
        EXPECT(is_free(line.device));
        EXPECT(port.open(line.device, {.rs485 = rs485_mode::required}) == errc::device_setting_refused);
        EXPECT(is_free(line.device));
    }
    return 0;
}

int fail_beside_an_owner()
{
    shared_line const line;
    EXPECT(line.is_ready());
    posix_serial owner;
    EXPECT(owner.open(line.device));
    for (int i = 0; i < rounds; ++i) {
        posix_serial port;
        EXPECT(port.open(line.device) == errc::device_in_use);
        EXPECT(not is_free(line.device));
    }
    owner.close();
    EXPECT(is_free(line.device));
    return 0;
}

int move()
{
    shared_line const first;
    shared_line const second;
    EXPECT(first.is_ready() and second.is_ready());
    for (int i = 0; i < rounds; ++i) {
        posix_serial from;
        posix_serial to;
        EXPECT(from.open(first.device) and to.open(second.device));
        to = std::move(from);
        EXPECT(is_free(second.device) and not is_free(first.device));
        posix_serial last{std::move(to)};
        EXPECT(not is_free(first.device));
        last = posix_serial{};
        EXPECT(is_free(first.device) and is_free(second.device));
    }
    return 0;
}

int refuse_and_restore()
{
    shared_line const line;
    EXPECT(line.is_ready());
    descriptor const look{::open(line.device.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)};
    termios before{};
    EXPECT(::tcgetattr(look.number(), &before) == 0);
    posix_serial port;
    EXPECT(not port.open(line.device, {.bits_per_second = 1'200, .rs485 = rs485_mode::required}));
    termios after{};
    EXPECT(::tcgetattr(look.number(), &after) == 0);
    EXPECT(::cfgetospeed(&after) == ::cfgetospeed(&before));
    EXPECT(after.c_iflag == before.c_iflag and after.c_cflag == before.c_cflag);
    return 0;
}

int die()
{
    pseudo_terminal near;
    EXPECT(near.open());
    ::pid_t const owner = ::fork();
    if (owner == 0) {
        posix_serial port;
        if (port.open(near.path())) {
            ::raise(SIGKILL);
        }
        std::_Exit(1);
    }
    int status = 0;
    ::waitpid(owner, &status, 0);
    EXPECT(WIFSIGNALED(status));
    EXPECT(not is_free(near.path()));
    // Whoever holds the other end of the line goes on waiting for bytes.
    std::array<std::byte, 8> place{};
    for (int i = 0; i < 12; ++i) {
        EXPECT(near.read(place, near.now() + milliseconds(100)));
    }
    posix_serial again;
    EXPECT(again.open(near.path()));
    // What a living program holds stays its own.
    for (int i = 0; i < 12; ++i) {
        EXPECT(near.read(place, near.now() + milliseconds(100)));
    }
    EXPECT(not is_free(near.path()));
    return 0;
}

} // namespace

TEST_CASE("defect: D13 a device is free when its port goes") { CHECK(as_a_normal_user(open_and_leave) == 0); }

TEST_CASE("defect: D13 a device is free when its port is closed") { CHECK(as_a_normal_user(open_and_close) == 0); }

TEST_CASE("defect: D13 a device is free when its port opens another") { CHECK(as_a_normal_user(open_again) == 0); }

TEST_CASE("defect: D13 a device is free when it could not be opened") { CHECK(as_a_normal_user(fail_to_open) == 0); }

TEST_CASE("defect: D13 a failed open takes nothing from the owner of a device")
{
    CHECK(as_a_normal_user(fail_beside_an_owner) == 0);
}

TEST_CASE("defect: D13 a device is free when another port is moved over its own")
{
    CHECK(as_a_normal_user(move) == 0);
}

TEST_CASE("defect: D13 a device has its settings again when it could not be opened")
{
    CHECK(as_a_normal_user(refuse_and_restore) == 0);
}

TEST_CASE("defect: D13 a simulated line can be opened again when its client was killed")
{
    CHECK(as_a_normal_user(die) == 0);
}
