// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Ports that are opened where standard descriptors are closed.
#include "support/catch.hpp"
#include "support/death.hpp"

#include <string>

#include <fcntl.h>
#include <unistd.h>

#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/port/pseudo_terminal.hpp>

using namespace rtuwire;

namespace {

/// In a child with these of the three closed (a set of bits): whether `act` is true.
template <typename Act> bool holds_with_closed(unsigned closed, Act act)
{
    return test::end_of([&] {
               for (int number = 0; number < 3; ++number) {
                   if ((closed >> number & 1U) != 0) {
                       ::close(number);
                   }
               }
               if (not act()) {
                   ::_exit(1);
               }
           })
        .is_return;
}

bool is_closed(int number) { return ::fcntl(number, F_GETFD) < 0; }

} // namespace

TEST_CASE("motion law: S26 a port takes the place of no standard descriptor that is closed, and leaves it closed")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    for (unsigned closed = 0; closed < 8; ++closed) {
        CAPTURE(closed);
        CHECK(holds_with_closed(closed, [&] {
            posix_serial port;
            bool const is_right = port.open(far.path()) and port.descriptor_number() > 2;
            bool are_left = true;
            for (int number = 0; number < 3; ++number) {
                are_left = are_left and is_closed(number) == ((closed >> number & 1U) != 0);
            }
            return is_right and are_left;
        }));
    }
}

TEST_CASE("motion law: S26 a pseudo-terminal takes the place of no standard descriptor that is closed")
{
    for (unsigned closed = 0; closed < 8; ++closed) {
        CAPTURE(closed);
        CHECK(holds_with_closed(closed, [&] {
            pseudo_terminal line;
            bool is_right = line.open().has_value();
            for (int number = 0; number < 3; ++number) {
                is_right = is_right and is_closed(number) == ((closed >> number & 1U) != 0);
            }
            return is_right;
        }));
    }
}
