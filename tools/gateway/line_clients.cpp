// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line_clients.hpp"

#include <utility>

namespace tool::gateway {

line_clients::line_clients(choices const& chosen, std::function<void(std::string const&)> tell)
    : chosen_{chosen}, tell_{tell}, settings_{serve_settings_in(chosen_)}, events_{std::move(tell)},
      clients_{settings_, counts_, events_, {}}, served_{chosen_, settings_, clients_, counts_, events_}
{
    listen();
}

line_clients::~line_clients() { clients_.end(); }

void line_clients::listen()
{
    auto const now = clock::now();
    if (is_listening_ or now < next_listening_) {
        return;
    }
    next_listening_ = now + listening_pause;
    auto const why = ended_by([this] { clients_.listen(); });
    is_listening_ = not why;
    std::string const text =
        why ? std::string{"nobody is served: "} + why->what() + "; it is tried again"
            : "clients may read units " + chosen_.serve.units + " at " + chosen_.serve.listen.front();
    if (std::exchange(told_failure_, text) != text) {
        tell_(text);
    }
}

void line_clients::serve_one()
{
    listen();
    static_cast<void>(clients_.wait_for_request(-1, clock::now()));
    auto const request = clients_.take();
    if (not request) {
        return;
    }
    bool const was_up = served_.has_line();
    auto const sent = was_up ? line_->exchange().sent() : 0;
    served_.handle(*request);
    requests_ += was_up ? line_->exchange().sent() - sent : 0;
    if (was_up and not served_.has_line()) {
        throw ended{exit_status::port, served_.why_lost()};
    }
}

void line_clients::wait(int line, clock::time_point until)
{
    if (not clients_.wait_for_request(line, until)) {
        throw ended{exit_status::port, chosen_.line.port + ": the port has gone"};
    }
}

} // namespace tool::gateway
