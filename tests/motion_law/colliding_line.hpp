// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line on which everybody may speak at once: bit by bit, so that what collides arrives damaged, or as something
// else. A client's end, and simulated drives of any kind.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <rtuwire/client/bus.hpp>
#include <rtuwire/sim/drive/unit.hpp>
#include <rtuwire/sim/line/line.hpp>

namespace rtuwire::test {

inline constexpr std::uint32_t colliding_rate = 19'200;
inline constexpr line_timing colliding_timing{colliding_rate, character_format::even_8_1};

/// One end of the line as the line sees it.
struct line_node {
    virtual ~line_node() = default;
    virtual void receive(byte_view bytes, instant at) = 0;
    virtual void receive_error(instant at) = 0;
    virtual void sent(instant at) = 0;
    virtual void advance(instant now) = 0;
    virtual byte_view poll_transmit() = 0;
    virtual deadline poll_deadline() const = 0;
    deadline sends_until{};
    instant began_at{0};
};

/// An engine of this library as such an end. A drive may answer late.
template <typename Engine> struct engine_node : line_node {
    Engine engine;
    duration latency{};

    explicit engine_node(Engine of) : engine{std::move(of)} {}
    void receive(byte_view bytes, instant at) override { engine.receive(bytes, at); }
    void receive_error(instant at) override { engine.receive_error(at); }
    void sent(instant at) override { engine.sent(at); }
    void advance(instant now) override
    {
        now_ = now;
        engine.advance(now);
    }
    byte_view poll_transmit() override
    {
        if (latency.microseconds != 0 and held_.empty()) {
            held_ = engine.poll_transmit();
            leaves_at_ = now_ + latency;
        }
        if (latency.microseconds == 0) {
            return engine.poll_transmit();
        }
        if (held_.empty() or not reached(now_, leaves_at_)) {
            return {};
        }
        return std::exchange(held_, byte_view{});
    }
    deadline poll_deadline() const override { return held_.empty() ? engine.poll_deadline() : deadline{leaves_at_}; }

private:
    instant now_{0};
    instant leaves_at_{0};
    byte_view held_{};
};

/// The line. `Link` is a client or a bus, and talker 0.
template <typename Link> class colliding_line {
public:
    explicit colliding_line(Link link, std::uint32_t seed = 1)
        : link_{std::move(link)}, wire_{colliding_rate, character_format::even_8_1, seed}
    {}

    Link& link() { return link_.engine; }
    instant now() const { return now_; }
    sim::line& wire() { return wire_; }

    /// One more drive; at most seven.
    template <device_type Device> engine_node<sim::unit<Device>>& add(station<Device> const& drive)
    {
        auto node =
            std::make_unique<engine_node<sim::unit<Device>>>(sim::unit<Device>{drive.unit(), colliding_timing, now_});
        auto& added = *node;
        nodes_.push_back(std::move(node));
        return added;
    }

    /// When the client's end last began to speak.
    instant spoke_at() const { return spoke_at_; }
    std::size_t spoken() const { return spoken_; }

    /// How often it began while a drive had been speaking for a character and more, so that it had been heard.
    unsigned spoke_over() const { return spoke_over_; }

    template <typename Converse> void step(Converse converse, instant until)
    {
        hear();
        finish(link_);
        link_.advance(now_);
        converse(now_);
        speak(0, link_);
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            finish(*nodes_[i]);
            nodes_[i]->advance(now_);
            speak(static_cast<unsigned>(i + 1), *nodes_[i]);
        }
        jump(until);
    }

    template <typename Converse> void pass(Converse converse, duration length)
    {
        instant const end = now_ + length;
        while (not reached(now_, end)) {
            step(converse, end);
        }
    }

    template <conversation Conversation> void run(Conversation& conversation, duration most = milliseconds(60'000))
    {
        instant const end = now_ + most;
        while (not conversation.settled() and not reached(now_, end)) {
            step([&](instant now) { link().converse(conversation, now); }, end);
        }
    }

private:
    void hear()
    {
        while (auto const heard = wire_.receive(now_)) {
            tell(0, link_, *heard);
            for (std::size_t i = 0; i < nodes_.size(); ++i) {
                tell(static_cast<unsigned>(i + 1), *nodes_[i], *heard);
            }
        }
    }

    /// A talker's receiver is off while it speaks.
    static void tell(unsigned sender, line_node& node, sim::character const& heard)
    {
        if (node.sends_until or heard.is_from(sender)) {
            return;
        }
        if (heard.is_damaged) {
            node.receive_error(heard.at);
        } else {
            node.receive(byte_view{&heard.byte, 1}, heard.at);
        }
    }

    void finish(line_node& node)
    {
        if (node.sends_until and reached(now_, *node.sends_until)) {
            node.sent(*node.sends_until);
            node.sends_until = {};
        }
    }

    void speak(unsigned sender, line_node& node)
    {
        if (node.sends_until) {
            return;
        }
        if (byte_view const frame = node.poll_transmit(); not frame.empty()) {
            node.sends_until = wire_.transmit(sender, frame, now_);
            node.began_at = now_;
            spoke_at_ = sender == 0 ? now_ : spoke_at_;
            spoken_ += sender == 0 ? 1U : 0U;
            for (auto const& each : nodes_) {
                bool const was_heard = each->sends_until and now_ - each->began_at > colliding_timing.characters(1);
                spoke_over_ += sender == 0 and was_heard ? 1U : 0U;
            }
        }
    }

    void jump(instant until)
    {
        deadline next = earlier(deadline{until}, deadline{now_ + milliseconds(5)});
        next = earlier(next, wire_.poll_deadline());
        next = earlier(next, link_.sends_until);
        next = earlier(next, link_.poll_deadline());
        for (auto const& each : nodes_) {
            next = earlier(next, each->sends_until);
            next = earlier(next, each->poll_deadline());
        }
        now_ = reached(now_, *next) ? now_ + microseconds(10) : *next;
    }

    engine_node<Link> link_;
    sim::line wire_;
    std::vector<std::unique_ptr<line_node>> nodes_;
    instant now_{0};
    instant spoke_at_{0};
    std::size_t spoken_{0};
    unsigned spoke_over_{0};
};

} // namespace rtuwire::test
