// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A test bench: a client or a bus at one end of a simulated line, units at the others, and a clock of its own. It runs
// conversations to their end without hardware and without waiting. The same calls give the same bytes at the same
// times. No heap.
//
//     constexpr station<atv320::device> drive{unit_id{7}};
//     sim::bench bench{line_timing{19'200, character_format::even_8_1}, drive};  // a simulated ATV320 is unit 7
//     auto const speed = bench.run(read<atv320::rfr>(drive));                    // its outcome
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/client/bus.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/server/server.hpp>
#include <rtuwire/server/units.hpp>
#include <rtuwire/sim/drive/unit.hpp>
#include <rtuwire/sim/line/line.hpp>
#include <rtuwire/wire/function.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// What can be connected to a line: a client, a bus, a simulated drive, a server with its bank.
template <typename T>
concept line_end = requires(T& end, byte_view bytes, instant now)
{
    end.receive(bytes, now);
    end.receive_error(now);
    end.sent(now);
    end.advance(now);
    {
        end.poll_transmit()
        } -> std::same_as<byte_view>;
    {
        end.poll_deadline()
        } -> std::same_as<deadline>;
};

/// Bytes that were received one right after the other, up to and including a damaged one.
struct chunk {
    std::array<std::byte, max_adu_size> bytes{};
    std::size_t size{0};
    std::uint8_t senders{0};
    bool is_damaged{false};
    instant at{0}; ///< the end of the last one

    [[nodiscard]] constexpr bool takes(character const& next) const noexcept
    {
        bool const is_alike = next.senders == senders and not next.is_damaged and not is_damaged;
        return size == 0 or (is_alike and size < bytes.size());
    }
    constexpr void add(character const& next) noexcept
    {
        bytes[size++] = next.byte;
        senders = next.senders;
        is_damaged = next.is_damaged;
        at = next.at;
    }
};

/// One end of the line and the state of its transceiver.
template <std::size_t Sender, line_end End> struct terminal {
    static constexpr unsigned sender = Sender;

    End end;
    deadline sends_until{};
    bool is_cut{false};

    /// Its receiver is off while it sends.
    constexpr void receive(chunk const& heard) noexcept
    {
        if (is_cut or sends_until or ((heard.senders >> sender) & 1U) != 0) {
            return;
        }
        if (heard.is_damaged) {
            end.receive_error(heard.at);
        } else {
            end.receive(byte_view{heard.bytes}.first(heard.size), heard.at);
        }
    }

    /// Lets time pass; a server that knows its banks serves them.
    constexpr void advance(instant now) noexcept
    {
        if constexpr (requires { end.serve(now); }) {
            end.serve(now);
        } else {
            end.advance(now);
        }
    }

    constexpr void finish(instant now) noexcept
    {
        if (sends_until and reached(now, *sends_until)) {
            end.sent(*sends_until);
            sends_until = {};
        }
    }

    template <typename Line> constexpr void transmit(Line& line, line_timing const& timing, instant now) noexcept
    {
        if (sends_until) {
            return;
        }
        if (byte_view const frame = end.poll_transmit(); not frame.empty()) {
            sends_until = is_cut ? now + timing.characters(frame.size()) : line.transmit(sender, frame, now);
        }
    }

    constexpr void add_to(earliest& next) const noexcept
    {
        next.add(sends_until);
        next.add(end.poll_deadline());
    }
};

template <typename Numbers, line_end... Ends> class terminals;

/// All ends of a line, numbered as its senders.
template <std::size_t... Numbers, line_end... Ends>
class terminals<std::index_sequence<Numbers...>, Ends...> : terminal<Numbers, Ends>... {
public:
    /// `ends.make<End>(from)` makes each end.
    template <typename Maker, typename... From>
    explicit constexpr terminals(Maker const& ends, From const&... from) noexcept
        : terminal<Numbers, Ends>{ends.template make<Ends>(from)}...
    {}

    template <typename Action> constexpr void for_each(Action action) noexcept
    {
        (action(static_cast<terminal<Numbers, Ends>&>(*this)), ...);
    }

    template <std::size_t Number> [[nodiscard]] constexpr auto& at() noexcept { return find<Number>(*this); }

private:
    template <std::size_t Number, typename End>
    static constexpr terminal<Number, End>& find(terminal<Number, End>& found) noexcept
    {
        return found;
    }
};

/// A server and the bank that it serves, as one end of a line. It has the public functions that the bank has something
/// for. Borrows the bank and the profile, which must outlive it.
template <register_bank Bank> class bank_unit {
public:
    constexpr bank_unit(unit_id its_address, line_timing const& its_line, Bank& bank,
                        server_profile const& its_profile) noexcept
        : node_{its_address, its_line, its_profile}, bank_{&bank}
    {}

    constexpr void receive(byte_view bytes, instant now) noexcept { node_.receive(bytes, now); }
    constexpr void receive_error(instant now) noexcept { node_.receive_error(now); }
    constexpr void sent(instant now) noexcept { node_.sent(now); }
    constexpr void advance(instant now) noexcept { node_.serve(*bank_, now); }
    [[nodiscard]] constexpr byte_view poll_transmit() noexcept { return node_.poll_transmit(); }
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept { return node_.poll_deadline(); }

private:
    basic_server<serial_diagnostics, served_functions<Bank>> node_;
    Bank* bank_;
};

/// The end of a line that an argument of a bench describes.
template <typename T> struct end_for {
    using type = T;
};
template <device_type Device> struct end_for<station<Device>> {
    using type = sim::unit<Device>;
};
template <register_bank Bank> struct end_for<bank_at<Bank>> {
    using type = bank_unit<Bank>;
};

/// Makes that end where it stays: not by a copy, which a constant expression refuses for memory that is not set yet.
struct end_maker {
    line_timing const& line;

    template <line_end End> constexpr End make(line_timing const& timing) const noexcept { return End{timing}; }
    template <line_end End> constexpr End const& make(End const& made) const noexcept { return made; }
    template <line_end End, device_type Device> constexpr End make(station<Device> const& drive) const noexcept
    {
        return End{drive.unit(), line, instant{0}};
    }
    template <line_end End, register_bank Bank> constexpr End make(bank_at<Bank> const& of) const noexcept
    {
        return End{of.address, line, of.bank, of.profile};
    }
};

/// The bench over a line of any kind: `bench` is the one to use. `Line` offers `transmit`, `receive` and
/// `poll_deadline` as `sim::line` does.
template <typename Link, typename Line, line_end... Units> class basic_bench {
    static_assert(1 + sizeof...(Units) <= sim::line::max_senders, "a simulated line has up to 7 units");

public:
    /// `link` is the client or bus, or the times of its line; the others describe the units.
    template <typename From, typename... Ends>
    constexpr basic_bench(line_timing const& its_timing, Line const& wire, From const& link,
                          Ends const&... ends) noexcept
        : ends_{end_maker{its_timing}, link, ends...}, wire_{wire}
    {}

    /// The client or bus.
    [[nodiscard]] constexpr Link& link() noexcept { return ends_.template at<0>().end; }

    /// A unit by its place among the arguments, 0 for the first.
    template <std::size_t Index = 0> [[nodiscard]] constexpr auto& unit() noexcept
    {
        return ends_.template at<Index + 1>().end;
    }

    /// The simulated drive of such a unit.
    template <std::size_t Index = 0> [[nodiscard]] constexpr auto& drive() noexcept { return unit<Index>().drive(); }

    /// The line, for its faults. The client is sender 0, the units are senders 1 to 7.
    [[nodiscard]] constexpr Line& wire() noexcept { return wire_; }

    [[nodiscard]] constexpr instant now() const noexcept { return now_; }

    /// Takes a unit off the line, or puts it back. It goes on as with a broken cable.
    template <std::size_t Index = 0> constexpr void cut(bool is_cut = true) noexcept
    {
        ends_.template at<Index + 1>().is_cut = is_cut;
    }

    /// One pass at `now()` in which all visitors visit, and the jump to whatever is due next: `longest` away at most,
    /// or the end of the bytes that are on the line. A visitor is a conversation (on a bus, in the slot of its place),
    /// or a function that is called with the time.
    template <typename... Visitors> constexpr void step(duration longest, Visitors&&... visitors)
    {
        visit_and_jump(now_ + longest_frame, longest, visitors...);
    }
    template <typename... Visitors> constexpr void pass(Visitors&&... visitors) { step(longest_sleep, visitors...); }

    /// Passes for a time.
    template <typename... Visitors> constexpr void run_for(duration length, Visitors&&... visitors)
    {
        static_cast<void>(run_until([] { return false; }, length, visitors...));
    }

    /// Passes until `is_done()`, at most for `limit` (70 minutes where that is longer); returns whether it was done.
    template <std::predicate Done, typename... Visitors>
    constexpr bool run_until(Done is_done, duration limit, Visitors&&... visitors)
    {
        instant const begin = now_;
        duration const all = limit < longest_limit ? limit : longest_limit;
        while (not is_done()) {
            duration const passed = now_ - begin;
            if (passed >= all) {
                return false;
            }
            duration const rest{all.microseconds - passed.microseconds};
            visit_and_jump(now_ + (rest < longest_frame ? rest : longest_frame), longest_sleep, visitors...);
        }
        return true;
    }

    /// Runs a conversation to its end, at most for `limit`, and returns its `outcome()`, or where it has none its
    /// `reason()`, or where it has neither a `result<void>`; what the limit cut says that it has not ended. Of a
    /// conversation without a name, whose response would end with the statement, only the error. A conversation that is
    /// already settled begins anew by its `again()`; where it has none, the error is `used_already`.
    template <typename Conversation>
        requires conversation<std::remove_cvref_t<Conversation>>
    constexpr auto run(Conversation&& conversation, duration limit = longest_run)
    {
        static_assert(not endless_conversation<std::remove_cvref_t<Conversation>>,
                      "this conversation never ends: give it to run_for or run_until");
        if (not can_run(conversation)) {
            return outcome_of(std::forward<Conversation>(conversation), errc::used_already);
        }
        static_cast<void>(run_until([&] { return conversation.settled(); }, limit, conversation));
        return outcome_of(std::forward<Conversation>(conversation));
    }

    /// Runs conversations side by side until all have ended, at most for `longest_run`; returns whether they have. One that
    /// had ended before begins anew by its `again()`; one that ends first is not visited any more.
    template <conversation First, conversation Second, conversation... Rest>
    constexpr bool run(First& first, Second& second, Rest&... rest)
    {
        if (not(can_run(first) and can_run(second) and (can_run(rest) and ...))) {
            return false;
        }
        auto const is_done = [&] { return first.settled() and second.settled() and (rest.settled() and ...); };
        return run_until(is_done, longest_run, to_its_end<First>{first}, to_its_end<Second>{second},
                         to_its_end<Rest>{rest}...);
    }

    static constexpr duration longest_run = milliseconds(60'000);

private:
    /// The longest time from pass to pass: motors turn, and a visitor's own times may be unknown.
    static constexpr duration longest_sleep = milliseconds(20);
    /// The clock wraps 95 s later.
    static constexpr duration longest_limit{70U * 60U * 1'000'000U};
    /// The longest time without a pass while bytes are on the line.
    static constexpr duration longest_frame = milliseconds(1'000);
    /// A visitor that visits until it has ended.
    template <typename Conversation> struct to_its_end {
        Conversation& of;
    };

    /// What a pass takes that finds something due at once.
    static constexpr duration shortest_sleep = microseconds(10);

    template <typename... Visitors> constexpr void visit_and_jump(instant end, duration longest, Visitors&... visitors)
    {
        ends_.for_each([this](auto& each) { each.finish(now_); });
        link().advance(now_);
        std::size_t slot = 0;
        (visit(visitors, slot++), ...);
        ends_.for_each([this](auto& each) {
            if constexpr (std::remove_cvref_t<decltype(each)>::sender != 0) {
                each.advance(now_);
            }
            each.transmit(wire_, link().line(), now_);
        });
        earliest next;
        next.add(end);
        if (not wire_.poll_deadline()) {
            next.add(now_ + (longest < longest_sleep ? longest : longest_sleep));
        }
        ends_.for_each([&](auto const& each) { each.add_to(next); });
        (add_to(next, visitors), ...);
        instant const due = *deadline{next};
        advance_to(reached(now_, due) ? now_ + shortest_sleep : due);
    }

    template <typename Visitor> constexpr void visit(Visitor& visitor, std::size_t slot)
    {
        if constexpr (not conversation<Visitor>) {
            visitor(now_);
        } else if constexpr (requires { link().converse(slot, visitor, now_); }) {
            link().converse(slot, visitor, now_);
        } else {
            link().converse(visitor, now_);
        }
    }

    template <typename Conversation> constexpr void visit(to_its_end<Conversation>& visitor, std::size_t slot)
    {
        if (not visitor.of.settled()) {
            visit(visitor.of, slot);
        }
    }

    template <typename Conversation>
    constexpr void add_to(earliest& next, to_its_end<Conversation> const& visitor) const noexcept
    {
        add_to(next, visitor.of);
    }

    /// A time that has come had its effect in this pass.
    template <typename Visitor> constexpr void add_to(earliest& next, Visitor const& visitor) const noexcept
    {
        if constexpr (timed_conversation<Visitor>) {
            deadline const at = visitor.poll_deadline();
            if (at and not reached(now_, *at)) {
                next.add(*at);
            }
        }
    }

    /// Lets time pass up to `next`, or to the end of the bytes that arrive before it without a gap.
    constexpr void advance_to(instant next) noexcept
    {
        chunk heard;
        bool is_any = false;
        while (auto const at = wire_.poll_deadline()) {
            instant const with_gap = now_ + link().line().characters(1) + microseconds(1);
            if (not reached(next, *at) or (is_any and not reached(with_gap, *at))) {
                break;
            }
            character const got = *wire_.receive(*at);
            if (not heard.takes(got)) {
                deliver(heard);
                heard = {};
            }
            heard.add(got);
            now_ = *at;
            is_any = true;
        }
        if (is_any) {
            deliver(heard);
        } else {
            now_ = next;
        }
    }

    constexpr void deliver(chunk const& heard) noexcept
    {
        ends_.for_each([&](auto& each) { each.receive(heard); });
    }

    terminals<std::make_index_sequence<1 + sizeof...(Units)>, Link, Units...> ends_;
    Line wire_;
    instant now_{0};
};

} // namespace detail

namespace sim {

/// A client or bus and up to seven units on a line. A unit is given as a `station` (a simulated drive of that kind),
/// as `bank_at`, as a server of several units, or as another end of a line that is already made.
template <typename Link, detail::line_end... Units> class bench : public detail::basic_bench<Link, line, Units...> {
    using base = detail::basic_bench<Link, line, Units...>;

public:
    /// Copies the client or bus, and makes the other ends; the line has its bit rate and format.
    template <typename... Ends>
    explicit constexpr bench(Link const& link, Ends const&... ends) noexcept
        : base{link.line(), line{link.line(), 1}, link, ends...}
    {}

    /// The same with the times of the line instead of a client of one's own.
    template <typename... Ends>
    explicit constexpr bench(line_timing const& its_timing, Ends const&... ends) noexcept
        : base{its_timing, line{its_timing, 1}, its_timing, ends...}
    {}
};

template <typename... Ends>
bench(line_timing, Ends const&...) -> bench<host_client, typename detail::end_for<Ends>::type...>;
template <detail::line_end Link, typename... Ends>
bench(Link, Ends const&...) -> bench<Link, typename detail::end_for<Ends>::type...>;

} // namespace sim
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
