// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An interrupt and a loop, as two threads, share a queue. The thread sanitizer finds a race here, and a model
// of the sequence finds what is missing, twice or in the wrong place. The model knows of the queue nothing
// but this: the event at the time n follows from n.
#include <rtuwire/rtu/interrupt_queue.hpp>

#include <atomic>
#include <thread>
#include <vector>

#include "support/catch.hpp"
#include "support/told_number.hpp"

using namespace rtuwire;

namespace {

/// What happens at a time.
struct event {
    enum class kind : std::uint8_t { byte, lump, error, sent } what;
    std::uint8_t first; ///< of its bytes; each further one is one more
    std::uint8_t size;
};

event event_at(std::uint32_t time)
{
    std::uint32_t mixed = time * 2'654'435'761U;
    mixed ^= mixed >> 15U;
    mixed *= 2'246'822'519U;
    mixed ^= mixed >> 13U;
    auto const first = static_cast<std::uint8_t>(mixed >> 8U);
    switch (mixed % 16) {
    case 0: return {event::kind::sent, first, 0};
    case 1: return {event::kind::error, first, 0};
    case 2:
    case 3: return {event::kind::lump, first, static_cast<std::uint8_t>(2 + mixed / 16 % 5)};
    default: return {event::kind::byte, first, 1};
    }
}

/// The two threads know of each other only this, and nothing here orders their memory.
struct shared {
    test::told_number clock;
    test::told_number reached; ///< by the loop
    std::atomic<std::uint32_t> sent{0};
};

/// The loop's client: holds each call against the sequence.
class sequence_model {
public:
    sequence_model(shared& both, std::uint32_t start) : both_{both}, last_{start} {}

    void receive(byte_view bytes, instant at)
    {
        event const each = event_at(at.microseconds);
        auto const place = static_cast<std::uint8_t>(std::to_integer<std::uint8_t>(bytes[0]) - each.first);
        // A lump that was cut by a drop goes on in a second call.
        if (at.microseconds == last_ and rest_ > 0) {
            expect(place >= each.size - rest_);
            take_note_of(place > each.size - rest_);
        } else {
            step_to(at, place > 0);
        }
        expect(not has_hole_);
        expect(place + bytes.size() <= each.size);
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            expect(bytes[i] == std::byte{static_cast<std::uint8_t>(each.first + place + i)});
        }
        rest_ = static_cast<std::uint8_t>(each.size - place - bytes.size());
        bytes_ += bytes.size();
    }
    void receive_error(instant at)
    {
        step_to(at, false);
        expect(event_at(at.microseconds).what == event::kind::error);
        has_hole_ = false;
    }
    /// Said of a drop: a hole that was found, or that will be found at the next event.
    void receive_overrun(instant)
    {
        ++drops_;
        is_told_ = not has_hole_;
        has_hole_ = false;
    }
    void sent(instant at)
    {
        step_to(at, false);
        expect(event_at(at.microseconds).what == event::kind::sent);
        both_.sent.store(++sent_, std::memory_order_relaxed);
    }

    /// After the last event: where something is missing up to there, it was said.
    void end(std::uint32_t last)
    {
        take_note_of(misses_any(last - last_ + 1) or rest_ > 0);
        expect(not has_hole_);
    }

    [[nodiscard]] std::uint32_t errors() const { return errors_; }
    [[nodiscard]] std::uint32_t drops() const { return drops_; }
    [[nodiscard]] std::uint32_t sent() const { return sent_; }
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

private:
    void expect(bool is_right) { errors_ += is_right ? 0U : 1U; }

    /// Whether anything but "sent", which the interrupt may leave out, happened up to `ahead` from here.
    [[nodiscard]] bool misses_any(std::uint32_t ahead) const
    {
        for (std::uint32_t i = 1; i < ahead; ++i) {
            if (event_at(last_ + i).what != event::kind::sent) {
                return true;
            }
        }
        return false;
    }

    /// Holds what is missing before the next event against what was said.
    void take_note_of(bool is_hole)
    {
        expect(is_hole or not is_told_);
        has_hole_ = has_hole_ or (is_hole and not is_told_);
        is_told_ = false;
    }

    void step_to(instant at, bool is_cut)
    {
        std::uint32_t const ahead = at.microseconds - last_;
        expect(ahead > 0 and ahead < 0x8000'0000U);
        take_note_of(misses_any(ahead) or rest_ > 0 or is_cut);
        rest_ = 0;
        last_ = at.microseconds;
    }

    shared& both_;
    std::uint32_t last_;
    std::uint8_t rest_{0};
    bool has_hole_{false}, is_told_{false};
    std::uint32_t errors_{0}, drops_{0}, sent_{0};
    std::uint64_t bytes_{0};
};

struct outcome {
    std::uint32_t errors, drops, overflows, sent_missing;
    std::uint64_t bytes;
};

/// With overflows, each stretch of so many events begins with a burst: three times what the queue holds, which the interrupt
/// has behind it before the loop looks again.
constexpr std::uint32_t stretch = 1'024;

/// Lets `count` events pass through a queue; the clock wraps half-way. With `may_overflow` the interrupt often runs further
/// ahead of the loop than the queue holds, and in every burst it does.
template <std::size_t Capacity> outcome run(std::uint32_t count, bool may_overflow)
{
    std::uint32_t const start = 0U - count / 2;
    std::uint32_t const end = start + count;
    interrupt_queue<Capacity> line;
    shared both{test::told_number{start}, test::told_number{start}};
    auto const is_in_burst = [&](std::uint32_t n) {
        return may_overflow and n % stretch > 0 and n % stretch < 3 * Capacity and n <= count;
    };
    std::uint32_t sent = 0;
    std::thread interrupt{[&] {
        std::vector<std::byte> bytes;
        std::uint32_t ahead = 1;
        for (std::uint32_t n = 1; n <= count; ++n) {
            instant const at{start + n};
            event const each = event_at(at.microseconds);
            if (may_overflow and n % stretch == 0) {
                ahead = 1; // the loop has seen all that was before the burst
            }
            for (std::uint32_t seen = both.reached.get(); at.microseconds - seen > ahead and not is_in_burst(n);
                 seen = both.reached.get()) {
                both.reached.wait_behind(seen);
            }
            // Once it has waited, the interrupt may run on for up to twice what the queue holds.
            ahead = may_overflow ? 1 + each.first % (2 * Capacity) : Capacity / 8;
            bytes.clear();
            for (unsigned i = 0; i < each.size; ++i) {
                bytes.push_back(std::byte{static_cast<std::uint8_t>(each.first + i)});
            }
            switch (each.what) {
            case event::kind::byte: line.receive(bytes[0], at); break;
            case event::kind::lump: line.receive(bytes, at); break;
            case event::kind::error: line.receive_error(at); break;
            case event::kind::sent:
                // One transmission after the other, as a client has it.
                if (both.sent.load(std::memory_order_relaxed) != sent) {
                    break;
                }
                line.sent(at);
                ++sent;
                break;
            }
            both.clock.tell(at.microseconds);
        }
    }};
    sequence_model seen{both, start};
    instant now{start};
    while (now.microseconds != end) {
        both.clock.wait_behind(now.microseconds);
        now = instant{both.clock.get()};
        while (is_in_burst(now.microseconds - start + 1)) {
            both.clock.wait_behind(now.microseconds);
            now = instant{both.clock.get()};
        }
        line.deliver_to(seen, now);
        both.reached.tell(now.microseconds);
    }
    interrupt.join();
    line.deliver_to(seen, now);
    seen.end(end);
    return {seen.errors(), seen.drops(), line.overflows(), sent - seen.sent(), seen.bytes()};
}

TEST_CASE("defect: (a) an interrupt and a loop share a line: all arrives, in order")
{
    auto const got = run<128>(100'000, false);
    CHECK(got.errors == 0);
    CHECK(got.drops == 0);
    CHECK(got.overflows == 0);
    CHECK(got.sent_missing == 0);
    CHECK(got.bytes > 100'000);
}

TEST_CASE("defect: (a) an interrupt and a loop share a line: no drop is silent, sent is never lost")
{
    auto const got = run<16>(100'000, true);
    CHECK(got.errors == 0);
    CHECK(got.drops >= 100'000 / stretch);
    CHECK(got.overflows == got.drops);
    CHECK(got.sent_missing == 0);
    CHECK(got.bytes > 50'000);
}

TEST_CASE("defect: (a) an interrupt and a loop share a line: the same with positions of 16 bits")
{
    auto const got = run<256>(200'000, true);
    CHECK(got.errors == 0);
    CHECK(got.drops >= 200'000 / stretch);
    CHECK(got.overflows == got.drops);
    CHECK(got.sent_missing == 0);
}

} // namespace
