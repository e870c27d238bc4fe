// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A bench for any number of simulated drives of a kind, whose frames a test can count, change and lose.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <rtuwire/client/bus.hpp>
#include <rtuwire/sim/bench.hpp>

namespace rtuwire::test {

using namespace detail;

inline constexpr line_timing bus_timing{19'200, character_format::even_8_1};
using frame_bytes = std::vector<std::byte>;

/// Simulated drives at one end of a line: they hear the others' frames, and each other's.
template <typename Device> class crowd {
public:
    explicit crowd(line_timing const& timing) : line_{timing} {}

    void add(unit_id address, instant now)
    {
        members_.push_back({std::make_unique<sim::unit<Device>>(address, line_, now)});
    }
    sim::unit<Device>& unit(std::size_t index) { return *members_[index].unit; }
    void cut(std::size_t index, bool is_cut) { members_[index].is_cut = is_cut; }
    std::size_t answers(std::size_t index) const { return members_[index].answers; }

    void receive(byte_view bytes, instant now) { tell(bytes, now, nullptr); }
    void receive_error(instant now)
    {
        for (member& each : members_) {
            each.unit->receive_error(now);
        }
    }
    void advance(instant now)
    {
        now_ = now;
        for (member& each : members_) {
            each.unit->advance(now);
        }
    }
    byte_view poll_transmit()
    {
        for (member& each : members_) {
            byte_view const frame = each.unit->poll_transmit();
            if (not frame.empty() and each.is_cut) {
                each.unit->sent(now_);
            } else if (not frame.empty()) {
                sender_ = &each;
                return frame;
            }
        }
        return {};
    }

    /// What arrives of the frame that is being sent.
    void note_arriving(frame_bytes const& frame)
    {
        arriving_ = frame;
        sender_->answers += frame.empty() ? 0U : 1U;
    }
    void sent(instant now)
    {
        sender_->unit->sent(now);
        tell(arriving_, now, sender_);
    }
    deadline poll_deadline() const
    {
        earliest next;
        for (member const& each : members_) {
            next.add(each.unit->poll_deadline());
        }
        return next;
    }

private:
    struct member {
        std::unique_ptr<sim::unit<Device>> unit;
        bool is_cut{false};
        std::size_t answers{0};
    };

    void tell(byte_view frame, instant now, member const* besides)
    {
        for (member& each : members_) {
            if (&each != besides and not each.is_cut and not frame.empty()) {
                each.unit->receive(frame, now);
            }
        }
    }

    line_timing line_;
    std::vector<member> members_{};
    member* sender_{nullptr};
    frame_bytes arriving_{};
    instant now_{0};
};

/// A line that asks what becomes of each frame.
struct watched_line : sim::line {
    std::function<void(frame_bytes&, bool, instant)> watch{};

    watched_line() : sim::line{bus_timing, 1} {}

    instant transmit(unsigned sender, byte_view bytes, instant at)
    {
        instant const end = at + bus_timing.characters(bytes.size());
        frame_bytes frame{bytes.begin(), bytes.end()};
        watch(frame, sender == 0, end);
        if (not frame.empty()) {
            sim::line::transmit(sender, frame, at);
        }
        return end;
    }
};

/// The bench. `Link` is a client or a bus. `converse` is what its owner does in each pass.
template <typename Link, typename Device>
class simulated_bus : public detail::basic_bench<Link, watched_line, crowd<Device>> {
    using base = detail::basic_bench<Link, watched_line, crowd<Device>>;

public:
    explicit simulated_bus(Link link) : base{bus_timing, watched_line{}, link, bus_timing}
    {
        this->wire().watch = [this](frame_bytes& frame, bool is_request, instant end) {
            watch(frame, is_request, end);
        };
    }
    simulated_bus(simulated_bus const&) = delete;
    simulated_bus& operator=(simulated_bus const&) = delete;

    /// While it is asked what becomes of a frame, the time at which that has arrived.
    instant now() const { return arrival_ ? *arrival_ : base::now(); }
    sim::unit<Device>& unit(std::size_t index) { return units().unit(index); }
    detail::simulated_drive<Device>& drive(std::size_t index = 0) { return unit(index).drive(); }
    void add(unit_id address) { units().add(address, now()); }

    using frame_bytes = test::frame_bytes;

    /// What becomes of each frame on its way: emptied, it is lost. The second argument tells a request.
    void disturb(std::function<void(frame_bytes&, bool)> how) { disturb_ = std::move(how); }

    /// Takes a unit off the line, or puts it back.
    void cut(std::size_t index, bool is_cut) { units().cut(index, is_cut); }

    /// Frames of a unit that the client's end heard.
    std::size_t answers(std::size_t index) { return units().answers(index); }

    /// The request that passed last, and how many did.
    byte_view request() const { return request_; }
    std::size_t requests() const { return requests_; }

    /// One pass at `now`, and the jump to the next thing that happens, at most `most` away.
    template <typename Converse> void step(Converse converse, duration most) { base::step(most, converse); }

    /// Passes until `is_done`, or until `most` has gone by; whether it was done.
    template <typename Converse, typename Done> bool run(Converse converse, Done is_done, duration most)
    {
        instant const end = now() + most;
        while (not is_done()) {
            if (reached(now(), end)) {
                return false;
            }
            step(converse, end - now());
        }
        return true;
    }

    /// Runs one conversation to its end.
    template <conversation Conversation> bool run(Conversation& conversation, duration most = milliseconds(60'000))
    {
        return run([&](instant now) { this->link().converse(conversation, now); },
                   [&] { return conversation.settled(); }, most);
    }

    /// Time without a controller.
    void idle(duration length)
    {
        run([](instant) {}, [] { return false; }, length);
    }

private:
    crowd<Device>& units() { return base::template unit<0>(); }

    void watch(frame_bytes& frame, bool is_request, instant end)
    {
        if (is_request) {
            request_ = frame;
            ++requests_;
        }
        arrival_ = end;
        if (disturb_) {
            disturb_(frame, is_request);
        }
        arrival_ = {};
        if (not is_request) {
            units().note_arriving(frame);
        }
    }

    frame_bytes request_{};
    std::size_t requests_{0};
    std::function<void(frame_bytes&, bool)> disturb_{};
    deadline arrival_{};
};

} // namespace rtuwire::test
