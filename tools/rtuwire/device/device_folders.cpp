// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "device/device_folders.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

#include "../support/platform.hpp"
#include "exit_status.hpp"
#include "words/suggestion.hpp"

namespace tool {

namespace {

namespace fs = std::filesystem;

/// Where those are that come with the program; empty where nobody knows where that is.
fs::path folder_of_program()
{
    fs::path const program = own_path();
    return program.empty() ? program : program.parent_path().parent_path() / "share" / "rtuwire" / "devices";
}

/// The user's own goes before what came with the program.
std::vector<fs::path> device_folders()
{
    std::vector<fs::path> folders;
    if (fs::path const data = folder_of_user(user_folder::data); not data.empty()) {
        folders.push_back(data / "rtuwire" / "devices");
    }
    if (fs::path const shipped = folder_of_program(); not shipped.empty()) {
        folders.push_back(shipped);
    }
    return folders;
}

/// The names that a folder has files for.
std::vector<std::string> names_in(fs::path const& folder)
{
    std::vector<std::string> names;
    std::error_code failure;
    for (fs::directory_iterator each{folder, failure}, end; not failure and each != end; each.increment(failure)) {
        if (each->path().extension() == ".toml") {
            names.push_back(each->path().stem().string());
        }
    }
    return names;
}

} // namespace

std::optional<std::string> device_file_named(std::string const& word)
{
    for (fs::path const& folder : device_folders()) {
        std::vector<std::string> const names = names_in(folder);
        if (std::ranges::count(names, word) != 0) {
            return (folder / (word + ".toml")).string();
        }
    }
    return std::nullopt;
}

std::vector<std::string> device_file_names()
{
    std::vector<std::string> known;
    for (fs::path const& folder : device_folders()) {
        std::vector<std::string> const names = names_in(folder);
        known.insert(known.end(), names.begin(), names.end());
    }
    std::ranges::sort(known);
    known.erase(std::unique(known.begin(), known.end()), known.end());
    return known;
}

std::string words_of_missing_folder()
{
    fs::path const shipped = folder_of_program();
    std::error_code ignored;
    return shipped.empty() or fs::is_directory(shipped, ignored)
               ? std::string{}
               : "; those that come with the program are looked for in " + shipped.string() + ", which is not there";
}

std::string path_of_device(std::string const& word)
{
    if (word.find_first_of("./") != word.npos) {
        return word;
    }
    if (auto const found = device_file_named(word)) {
        return *found;
    }
    std::vector<std::string> const known = device_file_names();
    std::vector<std::string_view> const views{known.begin(), known.end()};
    std::string all;
    for (std::string const& each : known) {
        all += (all.empty() ? "; there is " : ", ") + each;
    }
    refuse_word("there is no register file called '" + word + "'" + suggestion(word, views) + all +
                words_of_missing_folder() + "; a file of yours has a path: ./" + word + " or " + word + ".toml");
}

} // namespace tool
