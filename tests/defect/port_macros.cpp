// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the headers of the port room leave in a user's file.
#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/port/pseudo_terminal.hpp>

#include "support/catch.hpp"

namespace {

#if defined(major) || defined(minor) || defined(makedev)
constexpr bool leaks_macros = true;
#else
constexpr bool leaks_macros = false;

/// A name that users have.
struct revision {
    constexpr unsigned major() const { return 2; }
    constexpr unsigned minor() const { return 1; }
};
static_assert(revision{}.major() == 2 and revision{}.minor() == 1);
#endif

} // namespace

TEST_CASE("defect: (g) the names major and minor are left to the user")
{
    bool const leaks = leaks_macros;
    CHECK_FALSE(leaks);
}

#include <sys/sysmacros.h>

TEST_CASE("defect: (g) a device's major number is the system's")
{
    for (unsigned const number : {0U, 1U, 4U, 136U, 143U, 188U, 255U, 256U, 4095U}) {
        for (unsigned const unit : {0U, 1U, 255U, 256U, 0xFFFFFU}) {
            CHECK(rtuwire::detail::device_major(makedev(number, unit)) == number);
        }
    }
    struct stat info {};
    REQUIRE(::stat("/dev/null", &info) == 0);
    CHECK(rtuwire::detail::device_major(info.st_rdev) == 1);
    rtuwire::pseudo_terminal line;
    REQUIRE(line.open());
    rtuwire::detail::descriptor const far{::open(line.path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)};
    CHECK(rtuwire::detail::is_pseudo_terminal(far.number()));
}
