// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Two ends of a line for traces: a server that now and then is slow, and somebody who asks two units without end.
#pragma once

#include <rtuwire/client.hpp>
#include <rtuwire/server.hpp>

#include <vector>

#include <rtuwire/wire/registers.hpp>

#include "support/random.hpp"

namespace rtuwire::test {

/// A traced server; one request in four takes it up to 70 ms.
template <typename Sink> class slow_unit {
public:
    slow_unit(unit_id address, line_timing const& timing, std::uint32_t seed, Sink& trace)
        : node_{address, timing}, random_{seed}
    {
        node_.trace_to(trace);
    }
    void receive(byte_view bytes, instant now) noexcept { node_.receive(bytes, now); }
    void receive_error(instant now) noexcept { node_.receive_error(now); }
    void sent(instant now) noexcept { node_.sent(now); }
    void advance(instant now) noexcept
    {
        node_.advance(now);
        if (not node_.is_asked()) {
            due_ = {};
            return;
        }
        if (not due_) {
            due_ = now + milliseconds(random_.below(4) == 0 ? random_.below(70) : 0);
        }
        if (reached(now, *due_)) {
            node_.serve(bank_, now);
        }
    }
    byte_view poll_transmit() noexcept { return node_.poll_transmit(); }
    deadline poll_deadline() const noexcept
    {
        auto const own = node_.poll_deadline();
        return due_ and own ? earlier(own, *due_) : due_ ? due_ : own;
    }

private:
    server::traced_by<Sink> node_;
    word_bank<100> bank_{};
    test::random random_;
    deadline due_{};
};

/// Asks unit 7, or unit 8 one time in eight, without end.
class asks_anything : public asker {
public:
    explicit asks_anything(std::uint32_t seed) : random_{seed} { choose(); }
    std::optional<request_frame> next() const { return request_frame{byte_view{frame_}}; }
    void accept(result<response> const&) { choose(); }
    static bool settled() { return false; }

private:
    void choose()
    {
        unit_id const unit = random_.below(8) == 0 ? unit_id{8} : unit_id{7};
        auto const start = static_cast<std::uint16_t>(random_.below(90));
        if (random_.below(2) != 0) {
            auto const count = static_cast<std::uint16_t>(1 + random_.below(9));
            auto const frame = *encode(unit, read_holding_registers{.start = start, .count = count});
            keep(frame);
        } else {
            auto const value = static_cast<std::uint16_t>(random_.next());
            auto const frame = *encode(unit, write_single_register{.address = start, .value = value});
            keep(frame);
        }
    }
    void keep(byte_view bytes) { frame_.assign(bytes.begin(), bytes.end()); }

    test::random random_;
    std::vector<std::byte> frame_;
};

} // namespace rtuwire::test
