// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a compiler says of a value that is put on a stream where nothing shows it: a sentence, in place of all that a
// std::ostream takes. It knows a stream by its sentry, so that no header of streams is needed. port/show.hpp shows values.
#pragma once

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// What a stream becomes for the operators of values that nothing shows; one that takes a std::ostream is better.
struct include_rtuwire_print_hpp_to_show_this {
    template <typename Stream>
        requires requires { typename Stream::sentry; }
    include_rtuwire_print_hpp_to_show_this(Stream const&) = delete;
};

/// The same for a result, which rtuwire/print.hpp shows where it shows its value.
struct include_rtuwire_print_hpp_or_show_its_value_or_its_error {
    template <typename Stream>
        requires requires { typename Stream::sentry; }
    include_rtuwire_print_hpp_or_show_its_value_or_its_error(Stream const&) = delete;
};

} // namespace detail
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
