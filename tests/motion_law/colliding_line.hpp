// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A bench on which everybody may speak at once: bit by bit, so that what collides arrives damaged, or as something
// else. Its drives may answer late, and its line tells when the client's end spoke, and whether over somebody.
#pragma once

#include <array>
#include <utility>

#include <rtuwire/client/bus.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/sim/bench.hpp>

namespace rtuwire::test {

using namespace detail;

inline constexpr std::uint32_t colliding_rate = 19'200;
inline constexpr line_timing colliding_timing{colliding_rate, character_format::even_8_1};

/// A drive that may answer late.
template <device_type Device> class late_unit {
public:
    duration latency{};

    explicit late_unit(station<Device> const& of) : unit_{of.unit(), colliding_timing, instant{0}} {}

    detail::simulated_drive<Device> const& drive() const { return unit_.drive(); }
    void receive(byte_view bytes, instant at) { unit_.receive(bytes, at); }
    void receive_error(instant at) { unit_.receive_error(at); }
    void sent(instant at) { unit_.sent(at); }
    void advance(instant now)
    {
        now_ = now;
        unit_.advance(now);
    }
    byte_view poll_transmit()
    {
        if (latency.microseconds != 0 and held_.empty()) {
            held_ = unit_.poll_transmit();
            leaves_at_ = now_ + latency;
        }
        if (latency.microseconds == 0) {
            return unit_.poll_transmit();
        }
        if (held_.empty() or not reached(now_, leaves_at_)) {
            return {};
        }
        return std::exchange(held_, byte_view{});
    }
    deadline poll_deadline() const { return held_.empty() ? unit_.poll_deadline() : deadline{leaves_at_}; }

private:
    sim::unit<Device> unit_;
    instant now_{0};
    instant leaves_at_{0};
    byte_view held_{};
};

/// A line that notes when the client's end, sender 0, speaks.
class noting_line : public sim::line {
public:
    noting_line() : sim::line{colliding_rate, character_format::even_8_1, 1} {}

    /// When the client's end last began to speak.
    instant spoke_at() const { return spoke_at_; }
    std::size_t spoken() const { return spoken_; }

    /// How often it began while a drive had been speaking for a character and more, so that it had been heard.
    unsigned spoke_over() const { return spoke_over_; }

    instant transmit(unsigned sender, byte_view bytes, instant at)
    {
        instant const end = sim::line::transmit(sender, bytes, at);
        speeches_[sender] = {at, end};
        if (sender == 0) {
            spoke_at_ = at;
            ++spoken_;
            for (std::size_t other = 1; other < speeches_.size(); ++other) {
                auto const& [from, to] = speeches_[other];
                bool const was_heard = not reached(at, to) and at - from > colliding_timing.characters(1);
                spoke_over_ += was_heard ? 1U : 0U;
            }
        }
        return end;
    }

private:
    std::array<std::pair<instant, instant>, max_senders> speeches_{
        filled<max_senders>(std::pair{instant{0}, instant{0}})};
    instant spoke_at_{0};
    std::size_t spoken_{0};
    unsigned spoke_over_{0};
};

/// The bench. `Link` is a client or a bus.
template <typename Link, device_type... Devices>
class colliding_line : public detail::basic_bench<Link, noting_line, late_unit<Devices>...> {
public:
    explicit colliding_line(Link const& link, station<Devices> const&... drives)
        : detail::basic_bench<Link, noting_line, late_unit<Devices>...>{colliding_timing, noting_line{}, link,
                                                                        late_unit<Devices>{drives}...}
    {}
};

} // namespace rtuwire::test
