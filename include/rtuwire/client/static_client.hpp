// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A client whose line and options are constants of the program, for small processors.
#pragma once

#include <rtuwire/client/client.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/observer.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// The options of a client that is given none.
inline constexpr client_options default_client_options{};

/// What a `static_client` and a `static_drive_client` need.
template <line_timing const& Timing, client_options const& Options, typename Observer, std::size_t Motors>
inline constexpr client_needs<public_functions, Observer> fixed_needs{
    .timing = Timing, .options = Options, .motors = Motors};

} // namespace detail

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
