// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "port/device_holder.hpp"

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <sstream>

#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

namespace tool {

namespace {

/// Whether the command of a process is `start`.
bool is_start(std::string const& process)
{
    std::ifstream words{"/proc/" + process + "/cmdline"};
    for (std::string word; std::getline(words, word, '\0');) {
        if (word == "start") {
            return true;
        }
    }
    return false;
}

} // namespace

device_holder holder_of(std::string const& device)
{
    struct stat status {};
    if (::stat(device.c_str(), &status) != 0) {
        return {};
    }
    char file[64]; // as the kernel writes it: its file system's numbers, and its own
    std::snprintf(file, sizeof file, "%02x:%02x:%ju", major(status.st_dev), minor(status.st_dev),
                  static_cast<std::uintmax_t>(status.st_ino));
    std::ifstream locks{"/proc/locks"};
    for (std::string line; std::getline(locks, line);) {
        std::istringstream words{line}; // 1: FLOCK ADVISORY WRITE 4711 00:18:5 0 EOF
        std::string number, kind, manner, access, process, place;
        words >> number >> kind >> manner >> access >> process >> place;
        if (kind == "FLOCK" and place == file) {
            std::string name;
            std::getline(std::ifstream{"/proc/" + process + "/comm"}, name);
            return name.empty()
                       ? device_holder{}
                       : device_holder{name + " (process " + process + ")", name == "rtuwire" and is_start(process)};
        }
    }
    return {};
}

std::string words_of_group(std::string const& device)
{
    struct stat status {};
    bool const may_group = ::stat(device.c_str(), &status) == 0 and (status.st_mode & 060) == 060;
    group const* const owner = may_group and status.st_gid != 0 ? ::getgrgid(status.st_gid) : nullptr;
    std::string const name = owner != nullptr ? owner->gr_name : "";
    passwd const* const user = name.empty() ? nullptr : ::getpwuid(::geteuid());
    return user == nullptr ? std::string{}
                           : "it belongs to the group " + name + ": `sudo usermod -aG " + name + ' ' + user->pw_name +
                                 "`, then log in anew";
}

} // namespace tool
