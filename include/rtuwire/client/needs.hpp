// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a client is for, in one constant: a program pays for nothing that it does not name. With it, how long a client waits and
// how often it retries, and the names of the frequent kinds of clients. What protects a line, the quarantine of units whose
// response is outstanding and the watch for echoes, can't be left out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/trace/observer.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/functions.hpp>
#include <rtuwire/wire/serial_line_rules.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// The time-out and the retries for one unit.
struct retry_policy {
    /// From the end of a request to the start of its response; the time that the response itself takes on the line is
    /// added.
    duration response_timeout{milliseconds(1000)};
    /// How often a request is repeated after no response or a damaged one; never after an exception other than 05 and
    /// 06, and never for a broadcast.
    std::uint8_t retries{2};
    /// How often a request is repeated after exception 06 (busy), and a read of bits or registers (functions 01 to 04) after
    /// 05 (acknowledge). What else a unit acknowledges it has accepted, and does: that is never sent again.
    std::uint8_t busy_retries{3};
    /// The pause before the first of these repetitions; each further one is twice as long. No other request leaves on
    /// the line meanwhile.
    duration busy_pause{milliseconds(50)};
    /// The least time from a response to the next request to the same unit, and from a failed attempt to its repetition,
    /// for a unit that misses what comes sooner. Other units' requests go on between two requests, and a stop request
    /// does not wait for it. For a pause of all units see `line_timing::with_silence`.
    duration pause{};
};

/// A client's time-outs and retries, and the properties of its line.
struct client_options {
    /// As in `retry_policy`, for every unit that has no policy of its own.
    duration response_timeout{milliseconds(1000)};
    /// From the end of a broadcast to the next request; units need it to act (SL 2.4.1).
    duration turnaround{milliseconds(100)};
    /// How much longer than `response_timeout` any unit on the line may take to respond. A unit that failed to respond
    /// in time gets no new request until all its outstanding responses must have come: client/line/request.hpp
    /// derives how long that is. A response that takes longer than both together may be taken for the response to
    /// another request, where it is the first that the unit owes: RTU responses carry no number.
    duration late_response{milliseconds(200)};
    /// As in `retry_policy`.
    std::uint8_t retries{2};
    /// Whether the line returns what is sent (two wires without receiver disable). Each byte is then compared with the
    /// one sent; a difference is a `collision`. Without it, the first request that comes back ends as `line_echo`, wherever
    /// it can be told from a response; from then on echoes are taken out (see `has_seen_echo`) until a response comes
    /// without one, and after two of them a difference is a collision. `line_echo_probe` finds out before a write.
    bool has_line_echo{false};
    /// How many bytes of noise before a response are skipped: only bytes that differ from the unit's address, and the
    /// response must then be whole. Each one adds 1.5e-5 to the share of noise that passes a CRC, so the default is
    /// none.
    std::uint8_t max_leading_noise{0};

    friend constexpr bool operator==(client_options const&, client_options const&) noexcept = default;
};

/// What a client needs. `Functions`: those that it asks, each by the type of its request; other requests are refused with
/// `invalid_function`, and where a conversation's type tells what it asks, by the compiler. With all public functions, the
/// default, it also asks those of one's own. `Observer`: what it counts by, `line_statistics` or `unit_statistics<Units>`.
///
///     inline constexpr client_needs<function_list<read_holding_registers, write_single_register>> panel{
///         .timing = line_timing{19'200, character_format::even_8_1}, .longest_frame = 64};
///     constinit basic_client<panel> link;
template <typename Functions = public_functions, typename Observer = detail::no_observer> struct client_needs {
    using functions = Functions;
    using observer = Observer;

    /// The line. Where it is given, it and the options are constants of the program, and the client is zero-initialised: it
    /// has no constructor to run and no image in flash. Absent: both are given to the constructor.
    std::optional<line_timing> timing{};
    client_options options{};
    /// The longest response, 8 to 256 bytes, CRC included; with a request of more than `request_room` so much less. A request
    /// whose response may be longer is refused with `buffer_too_small`, and where a conversation's type tells, by the compiler.
    std::size_t longest_frame{max_adu_size};
    /// How many bytes precede the room for a response: as many as most requests have, 8 to 256. A longer request takes room
    /// from its response.
    std::size_t request_room{8};
    /// For so many units the client keeps apart until when each gets no new request because its response is outstanding; where
    /// there are more, the last place stands for all of them. At least 1.
    std::size_t quarantine_places{1};
    /// How many units it may order to run their motors at once; 0 for one that commands none.
    std::size_t motors{0};
    /// Whether its line may have one unit alone, which answers at address 0: it then also asks `only_unit`. What this unit owes
    /// keeps every unit from being asked, and a late response of it counts as `noise`.
    bool has_only_unit{false};
};

/// A client of all functions whose line is given to its constructor.
inline constexpr client_needs<> usual_needs{};

/// The same that counts, or whatever else `Observer` does: `basic_client<observed_by<line_statistics>>`; of any other client
/// its own `observed_by`: `blocking_client<posix_serial>::observed_by<line_statistics>`.
template <typename Observer> inline constexpr client_needs<public_functions, Observer> observed_by{};

/// Those of a program where memory does not matter: requests and responses of every size, and 32 motors.
inline constexpr client_needs<> host_needs{.request_room = max_adu_size, .motors = 32};

namespace detail {

/// What the constant `Needs` says, in types and in changed copies of it.
template <auto const& Needs> struct told_by {
    using functions = typename std::remove_cvref_t<decltype(Needs)>::functions;
    using observer = typename std::remove_cvref_t<decltype(Needs)>::observer;

    static constexpr bool is_fixed = Needs.timing.has_value();
    static constexpr std::size_t smallest = 8;
    static_assert(Needs.longest_frame >= smallest and Needs.longest_frame <= max_adu_size,
                  "a client's longest_frame is 8 to 256 bytes");
    static_assert(Needs.request_room >= smallest and Needs.request_room <= max_adu_size,
                  "a client's request_room is 8 to 256 bytes");
    static_assert(is_fixed or Needs.options == client_options{},
                  "a client whose line is given to its constructor is given its options there, too");
    static_assert(Needs.quarantine_places > 0,
                  "a client has at least one place for a unit whose response is outstanding");

    /// The line and the options as constants; a part of one is no template argument.
    struct constant_line {
        static constexpr line_timing value = *Needs.timing;
        [[nodiscard]] static constexpr line_timing const& get() noexcept { return value; }
    };
    struct constant_options {
        static constexpr client_options value = Needs.options;
        [[nodiscard]] static constexpr client_options const& get() noexcept { return value; }
    };
    using line = std::conditional_t<is_fixed, constant_line, stored<line_timing>>;
    using options = std::conditional_t<is_fixed, constant_options, stored<client_options>>;

    /// The same needs with other counts.
    template <typename Observer>
    static constexpr client_needs<functions, Observer> with(std::size_t quarantine_places, std::size_t motors) noexcept
    {
        return {.timing = Needs.timing,
                .options = Needs.options,
                .longest_frame = Needs.longest_frame,
                .request_room = Needs.request_room,
                .quarantine_places = quarantine_places,
                .motors = motors,
                .has_only_unit = Needs.has_only_unit};
    }
};

/// Whether a list has this very request, not only one of its code.
template <typename Request, typename... Functions>
[[nodiscard]] consteval bool is_listed(function_list<Functions...>) noexcept
{
    return (std::is_same_v<Request, Functions> or ...);
}

/// Whether a list of functions has all that a conversation asks, as far as its type tells: a conversation may declare
/// `static constexpr function_set asks{...}`.
template <typename Functions, typename Conversation> [[nodiscard]] consteval bool has_what_it_asks() noexcept
{
    if constexpr (requires { requires has_own_format<typename Conversation::request_type>; }) {
        return is_listed<typename Conversation::request_type>(Functions{});
    } else if constexpr (requires { Conversation::asks; }) {
        return Functions::codes.contains_all(Conversation::asks);
    }
    return true;
}

/// Whether a conversation asks one of the functions in its usual form, as far as its type tells, that is in the list in a format
/// of one's own.
template <typename Conversation, typename... Functions>
[[nodiscard]] consteval bool asks_usual_of_own(function_list<Functions...>) noexcept
{
    if constexpr (requires { requires has_own_format<typename Conversation::request_type>; }) {
        return false;
    } else if constexpr (requires { Conversation::asks; }) {
        return ((has_own_format<Functions> and Conversation::asks.contains(function_row<Functions>::code)) or ...);
    }
    return false;
}

/// Whether a conversation asks the only unit of a line, at address 0, as its type tells: `static constexpr bool asks_only_unit`.
template <typename Conversation> [[nodiscard]] consteval bool asks_only_unit() noexcept
{
    if constexpr (requires { requires Conversation::asks_only_unit; }) {
        return true;
    }
    return false;
}

/// Whether a client has room for the longest request of a conversation together with its longest response, as far as its
/// type tells.
template <auto const& Needs, typename Conversation> [[nodiscard]] consteval bool has_room_for() noexcept
{
    if constexpr (requires { Conversation::longest_frames; }) {
        constexpr frame_sizes most = Conversation::longest_frames;
        return most.response <= Needs.longest_frame and
               most.request + most.response <= Needs.request_room + Needs.longest_frame;
    }
    return true;
}

/// Whether a client has all that a conversation needs of it, as far as its type tells; what is missing is refused in a sentence.
template <auto const& Needs, typename Conversation> [[nodiscard]] consteval bool has_all_for() noexcept
{
    using functions = typename told_by<Needs>::functions;
    static_assert(has_what_it_asks<functions, Conversation>(),
                  "this client's list of functions lacks one that the conversation asks: add it to its client_needs");
    static_assert(not asks_usual_of_own<Conversation>(functions{}),
                  "this client asks a function of the conversation in a format of one's own: its usual form takes "
                  "another client");
    static_assert(has_room_for<Needs, Conversation>(),
                  "this client has no room for the longest frames of the conversation: give its client_needs a "
                  "larger longest_frame");
    return true;
}

/// The same needs, with another observer.
template <auto const& Needs, typename Observer>
inline constexpr auto observed_needs = told_by<Needs>::template with<Observer>(Needs.quarantine_places, Needs.motors);

/// The same needs, with a sink that takes the frames.
template <auto const& Needs, typename Sink>
inline constexpr auto traced_needs =
    told_by<Needs>::template with<observers<typename told_by<Needs>::observer, tracing<Sink>>>(Needs.quarantine_places,
                                                                                               Needs.motors);

} // namespace detail

/// See client/client.hpp.
template <auto const& Needs> class basic_client;

/// A client that counts nothing.
using client = basic_client<usual_needs>;

namespace detail {

/// What a `drive_client` needs.
template <std::size_t Units> inline constexpr client_needs<> needs_to_drive{.motors = Units};

/// The options of a client that is given none.
inline constexpr client_options default_client_options{};

/// What a `static_client` and a `static_drive_client` need.
template <line_timing const& Timing, client_options const& Options, typename Observer, std::size_t Motors>
inline constexpr client_needs<public_functions, Observer> fixed_needs{
    .timing = Timing, .options = Options, .motors = Motors};

} // namespace detail

/// The same for conversations that command the motors of up to `Units` units: start, stop, cycle and the like.
template <std::size_t Units = 1> using drive_client = basic_client<detail::needs_to_drive<Units>>;

/// The same where memory does not matter: its requests and responses may have any size.
using host_client = basic_client<host_needs>;

/// A client that holds neither its line's times nor its options and is zero-initialised: a `constinit` one has no
/// constructor to run and no image in flash. Each `Timing` makes code of its own, so it is for boards with one line.
///
///     constexpr line_timing timing{19'200, character_format::even_8_1}; // outside of functions
///     constinit static_client<timing> link;
template <line_timing const& Timing, client_options const& Options = detail::default_client_options,
          typename Observer = detail::no_observer>
using static_client = basic_client<detail::fixed_needs<Timing, Options, Observer, 0>>;

/// The same for conversations that command the motors of up to `Units` units: see `drive_client`.
template <line_timing const& Timing, std::size_t Units = 1,
          client_options const& Options = detail::default_client_options, typename Observer = detail::no_observer>
using static_drive_client = basic_client<detail::fixed_needs<Timing, Options, Observer, Units>>;

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
