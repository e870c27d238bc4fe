// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "words/option_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>

namespace tool {

namespace {

struct option_forms {
    std::string_view typed;
    bool is_of_serve;
    std::string_view in_file;
};

/// In the order of `line_option`.
constexpr option_forms forms[]{
    {"--timeout", true, "timeout"},
    {"--echo", true, "echo = true"},
    {"--noise", true, ""},
    {"--no-listen", true, "listen = 0"},
    {"--rs485", true, "rs485"},
    {"-u", false, "unit"},
    {"--any-unit", false, ""},
    {"sniff --find", true, ""},
    {"--listen", true, "listen"},
    {"--from", true, "from"},
    {"--units", true, "units"},
    {"--write", true, ""},
    {"--allow-broadcast and --write", true, ""},
};

} // namespace

std::string option_words(option_form form, line_option which, std::string_view value)
{
    option_forms const& of = forms[static_cast<std::size_t>(which)];
    std::string_view const name = form == option_form::in_file                   ? of.in_file
                                  : form == option_form::typed or of.is_of_serve ? of.typed
                                                                                 : std::string_view{};
    std::string text{name};
    if (not name.empty() and not value.empty()) {
        std::string_view const quote = form == option_form::in_file and which == line_option::listen ? "\"" : "";
        text.append(form == option_form::in_file ? " = " : " ").append(quote).append(value).append(quote);
    }
    return text;
}

std::string longer_timeout(double seconds, option_form form)
{
    constexpr double most = 30.0;
    std::array<char, 32> after{};
    std::array<char, 32> longer{};
    std::snprintf(after.data(), after.size(), "%.1f", seconds);
    std::snprintf(longer.data(), longer.size(), "%.1f", std::min(std::ceil(seconds * 15.0) / 10.0, most));
    return std::string{after.data()} + " s: say " + option_words(form, line_option::timeout, longer.data());
}

} // namespace tool
