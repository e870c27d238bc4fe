// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A name server that takes its time: the system's own call, replaced in this program for names that begin with "slow".
#include <rtuwire/port/tcp_stream.hpp>

#include <atomic>
#include <string>

#include <dlfcn.h>
#include <netdb.h>
#include <signal.h>
#include <unistd.h>

#include "support/catch.hpp"

using namespace rtuwire;

namespace {

std::atomic<int> ended{0};
std::atomic<bool> is_held{false}; // the name server answers when it is let go
std::atomic<bool> takes_signals{false};

} // namespace

extern "C" int getaddrinfo(char const* host, char const* port, addrinfo const* wanted, addrinfo** found)
{
    using call = int (*)(char const*, char const*, addrinfo const*, addrinfo**);
    static auto const next = reinterpret_cast<call>(::dlsym(RTLD_NEXT, "getaddrinfo"));
    bool const is_slow = std::string{host}.rfind("slow", 0) == 0 and (wanted->ai_flags & AI_NUMERICHOST) == 0;
    if (not is_slow) {
        return next(host, port, wanted, found);
    }
    sigset_t blocked{};
    ::pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
    takes_signals = ::sigismember(&blocked, SIGINT) == 0;
    for (int i = 0; i == 0 or (is_held and i < 1'000); ++i) {
        ::usleep(20'000);
    }
    int const status = next("127.0.0.1", port, wanted, found);
    ++ended;
    return status;
}

TEST_CASE("a name server that is slow holds nobody up")
{
    ended = 0;
    is_held = true;
    tcp_stream port;
    instant const start = steady_now();
    CHECK(port.open("slow.example", 9, milliseconds(50)) == errc::timed_out);
    CHECK(steady_now() - start >= milliseconds(50));
    CHECK(port.failure() == "slow.example:9: no such host (not found in time)");
    CHECK(ended == 0);
    // What was left behind ends by itself.
    is_held = false;
    for (int i = 0; i < 1'000 and ended == 0; ++i) {
        ::usleep(20'000);
    }
    CHECK(ended == 1);
    CHECK_FALSE(takes_signals);
}

TEST_CASE("a name that is found late, but in time, is connected to")
{
    ended = 0;
    tcp_stream port;
    // Nobody listens there: the look-up is over, and connecting is refused.
    CHECK(port.open("slow.example", 9, milliseconds(20'000)) == errc::device_not_found);
    CHECK(port.failure() == "slow.example:9: no connection (Connection refused)");
    CHECK(ended == 1);
}
