// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "port/device_holder.hpp"

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <sstream>

#include <sys/stat.h>
#include <sys/sysmacros.h>

namespace tool {

std::string holder_of(std::string const& device)
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
            return name.empty() ? name : name + " (process " + process + ")";
        }
    }
    return {};
}

} // namespace tool
