// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client's end and simulated drives on one virtual wire: bytes take their time, everybody hears
// everybody, and time jumps from one deadline to the next.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <rtuwire/client/bus.hpp>
#include <rtuwire/sim/drive/unit.hpp>

namespace rtuwire::test {

inline constexpr line_timing bus_timing{19'200, character_format::even_8_1};

/// The wire. `Link` is a client or a bus. `converse` is what its owner does in each pass.
template <typename Link, typename Device> class simulated_bus {
public:
    explicit simulated_bus(Link link, instant start = instant{0}) : link_{link}, now_{start} {}

    Link& link() { return link_; }
    instant now() const { return now_; }
    sim::unit<Device>& unit(std::size_t index) { return *units_[index]; }
    sim::drive<Device>& drive(std::size_t index = 0) { return units_[index]->drive(); }

    void add(unit_id address)
    {
        units_.push_back(std::make_unique<sim::unit<Device>>(address, bus_timing, now_));
        is_cut_.push_back(false);
        answers_.push_back(0);
    }

    using frame_bytes = std::vector<std::byte>;

    /// What becomes of each frame on its way: emptied, it is lost. The second argument tells a request.
    void disturb(std::function<void(frame_bytes&, bool)> how) { disturb_ = std::move(how); }

    /// Takes a unit off the wire, or puts it back.
    void cut(std::size_t index, bool is_cut) { is_cut_[index] = is_cut; }

    /// Frames of a unit that the client's end heard.
    std::size_t answers(std::size_t index) const { return answers_[index]; }

    /// The request that passed last, and how many did.
    byte_view request() const { return byte_view{request_}.first(request_size_); }
    std::size_t requests() const { return requests_; }

    /// One pass at `now`, and the jump to the next thing that happens, at most `most` away.
    template <typename Converse> void step(Converse converse, duration most)
    {
        link_.advance(now_);
        converse(now_);
        for (auto const& each : units_) {
            each->advance(now_);
        }
        bool is_moved = false;
        if (byte_view const frame = link_.poll_transmit(); not frame.empty()) {
            is_moved = true;
            keep(frame);
            pass(frame.size());
            link_.sent(now_);
            frame_bytes const heard = disturbed(frame, true);
            for (std::size_t i = 0; i < units_.size(); ++i) {
                hear(i, heard);
            }
        }
        for (std::size_t sender = 0; sender < units_.size(); ++sender) {
            byte_view const frame = units_[sender]->poll_transmit();
            if (frame.empty()) {
                continue;
            }
            is_moved = true;
            pass(frame.size());
            units_[sender]->sent(now_);
            if (is_cut_[sender]) {
                continue;
            }
            frame_bytes const heard = disturbed(frame, false);
            if (heard.empty()) {
                continue;
            }
            link_.receive(heard, now_);
            ++answers_[sender];
            for (std::size_t i = 0; i < units_.size(); ++i) {
                if (i != sender) {
                    hear(i, heard);
                }
            }
        }
        if (not is_moved) {
            jump(most);
        }
    }

    /// Passes until `is_done`, or until `most` has gone by; whether it was done.
    template <typename Converse, typename Done> bool run(Converse converse, Done is_done, duration most)
    {
        instant const end = now_ + most;
        while (not is_done()) {
            if (reached(now_, end)) {
                return false;
            }
            step(converse, end - now_);
        }
        return true;
    }

    /// Runs one conversation to its end.
    template <conversation Conversation> bool run(Conversation& conversation, duration most = milliseconds(60'000))
    {
        return run([&](instant now) { link_.converse(conversation, now); }, [&] { return conversation.settled(); },
                   most);
    }

    /// Time without a controller.
    void idle(duration length)
    {
        instant const end = now_ + length;
        while (not reached(now_, end)) {
            step([](instant) {}, end - now_);
        }
    }

private:
    frame_bytes disturbed(byte_view frame, bool is_request)
    {
        frame_bytes bytes{frame.begin(), frame.end()};
        if (disturb_) {
            disturb_(bytes, is_request);
        }
        return bytes;
    }

    void hear(std::size_t index, byte_view frame)
    {
        if (not is_cut_[index] and not frame.empty()) {
            units_[index]->receive(frame, now_);
        }
    }

    void keep(byte_view frame)
    {
        request_size_ = frame.size();
        byte_writer{request_}.bytes(frame);
        ++requests_;
    }

    void pass(std::size_t bytes) { now_ = now_ + bus_timing.characters(bytes); }

    void jump(duration most)
    {
        deadline next = now_ + most;
        next = earlier(next, link_.poll_deadline());
        for (auto const& each : units_) {
            next = earlier(next, each->poll_deadline());
        }
        // A conversation's own deadlines are not asked for: its pauses are longer than this.
        next = earlier(next, now_ + milliseconds(20));
        bool const is_ahead = not reached(now_, *next);
        now_ = is_ahead ? *next : now_ + microseconds(10);
    }

    Link link_;
    std::vector<std::unique_ptr<sim::unit<Device>>> units_;
    std::vector<bool> is_cut_;
    std::vector<std::size_t> answers_;
    std::array<std::byte, max_adu_size> request_{};
    std::size_t request_size_{0};
    std::size_t requests_{0};
    std::function<void(frame_bytes&, bool)> disturb_{};
    instant now_;
};

} // namespace rtuwire::test
