// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The client whose frames a ring keeps, and a loop that sends them on.
#include "client.hpp"

#include <rtuwire/trace.hpp>

namespace {

constinit rtuwire::trace_ring<1024> frames;

/// Sends on what has passed, before it asks.
class five_traced_requests : public five_requests {
public:
    std::optional<rtuwire::request_frame> next() const
    {
        std::array<std::byte, 256> place;
        while (auto const frame = frames.poll_frame(place)) {
            for (std::byte const each : frame->bytes) {
                board::put(each);
            }
        }
        return five_requests::next();
    }
};

template <typename Client> [[noreturn, gnu::noipa]] void ask_and_tell(Client& link)
{
    for (five_traced_requests conversation;;) {
        board::pass(link);
        link.converse(conversation, board::now());
    }
}

} // namespace

int main()
{
    rtuwire::client::traced_by<rtuwire::trace_ring<1024>> link{timing};
    link.trace_to(frames);
    ask_and_tell(link);
}
