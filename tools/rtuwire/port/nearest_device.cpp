// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "port/nearest_device.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "words/words.hpp"

namespace tool {

namespace {

/// Whether a name is one of a serial device: other devices are in the same folder.
bool is_of_serial_device(std::filesystem::path const& folder, std::string_view name)
{
    return folder != "/dev" or name.substr(0, 3) == "tty" or name.substr(0, 6) == "rfcomm";
}

} // namespace

std::string nearest_device(std::string const& path)
{
    std::filesystem::path const folder = std::filesystem::path{path}.parent_path();
    std::vector<std::string> names;
    std::error_code failed;
    for (std::filesystem::directory_iterator each{folder, failed}, end; not failed and each != end;
         each.increment(failed)) {
        std::error_code unknown;
        if (each->is_character_file(unknown) and is_of_serial_device(folder, each->path().filename().string())) {
            names.push_back(each->path().filename().string());
        }
    }
    std::sort(names.begin(), names.end());
    std::vector<std::string_view> const candidates{names.begin(), names.end()};
    std::string const nearest{nearest_word(std::filesystem::path{path}.filename().string(), candidates)};
    return nearest.empty() ? nearest : (folder / nearest).string();
}

} // namespace tool
