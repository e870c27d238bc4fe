// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "mqtt/wake_up.hpp"

#include <cerrno>
#include <cstdint>

#include <sys/eventfd.h>
#include <unistd.h>

namespace tool::gateway {

wake_up::wake_up() : descriptor_{::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)} {}

wake_up::~wake_up()
{
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

void wake_up::ring() const noexcept
{
    int const kept = errno;
    std::uint64_t const one = 1;
    static_cast<void>(!::write(descriptor_, &one, sizeof one)); // full: it rings already
    errno = kept;
}

void wake_up::hear() const noexcept
{
    std::uint64_t count = 0;
    static_cast<void>(!::read(descriptor_, &count, sizeof count));
}

} // namespace tool::gateway
