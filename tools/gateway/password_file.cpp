// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include <filesystem>
#include <string>
#include <system_error>

#include "files/regular_file.hpp"
#include "gateway_file.hpp"

namespace tool::gateway {

namespace {

constexpr std::size_t longest_password = 1'024;

} // namespace

bool is_open_to_all(std::string const& file)
{
    namespace fs = std::filesystem;
    std::error_code failure;
    fs::perms const allowed = fs::status(file, failure).permissions();
    return not failure and (allowed & fs::perms::others_all) != fs::perms::none;
}

std::string password_of(broker_choices const& broker)
{
    std::string const& file = broker.password_file;
    if (file.empty()) {
        return {};
    }
    if (std::string const why = why_no_regular_file(file); not why.empty()) {
        refuse_word(file + ": " + why);
    }
    if (is_open_to_all(file)) {
        refuse_word(file + ": anybody may read or change this password; say chmod o= " + file);
    }
    file_text found = text_of_file(file);
    if (not found.failure.empty()) {
        refuse_word(file + ": " + found.failure);
    }
    std::string& text = found.text;
    if (text.ends_with('\n')) {
        text.pop_back();
    }
    if (text.ends_with('\r')) {
        text.pop_back();
    }
    if (text.empty() or text.size() > longest_password or text.find_first_of(std::string{"\0\n", 2}) != text.npos) {
        refuse_word(file + ": it holds the password alone, on one line of at most " + std::to_string(longest_password) +
                    " bytes");
    }
    return std::move(text);
}

} // namespace tool::gateway
