// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How an option of a line is said to whoever runs the program, in a message that shows what to do.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tool {

/// Where the options of a line stand: typed in front of a command, or of `serve`, which asks for many units; or in the file of
/// the gateway.
enum class option_form : std::uint8_t { typed, of_serve, in_file };

enum class line_option : std::uint8_t {
    timeout,
    echo,
    noise,
    no_listen,
    rs485,
    unit,
    any_unit,
    find,
    listen, ///< of a line that clients ask, as all that follow
    from,
    units,
    write,
    broadcast,
};

/// "--timeout 1.5", in the file "timeout = 1.5", without a value its name; empty where there is no such option, so that no message names it.
[[nodiscard]] std::string option_words(option_form form, line_option which, std::string_view value = {});

/// "1.2 s: say --timeout 1.8", of an answer that came so many seconds behind its request.
[[nodiscard]] std::string longer_timeout(double seconds, option_form form);

/// "; say --timeout 1.5": the option between two parts of a sentence, or nothing where there is no such option.
[[nodiscard]] inline std::string advice(std::string_view before, std::string const& option,
                                        std::string_view behind = {})
{
    return option.empty() ? std::string{} : std::string{before}.append(option).append(behind);
}

} // namespace tool
