// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "port/serial_ports.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace tool {

namespace {

namespace fs = std::filesystem;

/// The names in a folder, in order; none where it cannot be read.
std::vector<fs::path> entries_of(fs::path const& folder)
{
    std::vector<fs::path> found;
    std::error_code failed;
    for (fs::directory_iterator each{folder, failed}, end; not failed and each != end; each.increment(failed)) {
        found.push_back(each->path());
    }
    std::ranges::sort(found);
    return found;
}

/// The first line of a small file; empty where there is none.
std::string line_in(fs::path const& file)
{
    constexpr std::size_t longest = 256;
    std::string line;
    std::ifstream in{file};
    std::getline(in, line);
    line.resize(std::min(line.size(), longest));
    return line;
}

/// Where a link ends; empty where it leads nowhere.
fs::path end_of(fs::path const& link)
{
    std::error_code failed;
    fs::path const end = fs::canonical(link, failed);
    return failed ? fs::path{} : end;
}

/// The driver of a port's hardware. Since Linux 6.5 two folders of every kind of port stand in front of it.
std::string driver_of(fs::path folder)
{
    std::string driver = end_of(folder / "driver").filename().string();
    for (int i = 0; i < 2 and (driver == "port" or driver == "ctrl"); ++i) {
        folder = folder.parent_path();
        driver = end_of(folder / "driver").filename().string();
    }
    return driver;
}

/// Fills in what an adapter says of itself: a folder above its port has that.
void name_adapter(serial_port& port, fs::path folder)
{
    constexpr int most_above = 6;
    for (int i = 0; i < most_above and folder.has_relative_path(); ++i, folder = folder.parent_path()) {
        std::error_code failed;
        if (fs::exists(folder / "product", failed)) {
            port.maker = line_in(folder / "manufacturer");
            port.product = line_in(folder / "product");
            port.serial = line_in(folder / "serial");
            return;
        }
    }
}

} // namespace

std::vector<serial_port> serial_ports(std::string const& root)
{
    std::vector<fs::path> const names = entries_of(root + "/dev/serial/by-id");
    std::vector<serial_port> found;
    for (fs::path const& each : entries_of(root + "/sys/class/tty")) {
        fs::path const hardware = end_of(each / "device");
        // The kernel keeps places for ports that a computer may have: their driver is that of none.
        std::string const driver = driver_of(hardware);
        if (hardware.empty() or driver == "serial8250") {
            continue;
        }
        serial_port port{.device = "/dev/" + each.filename().string(), .driver = driver};
        for (fs::path const& name : names) {
            port.stable = end_of(name).filename() == each.filename() ? "/dev/serial/by-id/" + name.filename().string()
                                                                     : port.stable;
        }
        name_adapter(port, hardware);
        found.push_back(std::move(port));
    }
    // macOS has none of that, and two names for each: the other one, `tty`, waits for a modem.
    for (fs::path const& each :
         fs::exists(root + "/sys/class/tty") ? std::vector<fs::path>{} : entries_of(root + "/dev")) {
        if (each.filename().string().starts_with("cu.")) {
            found.push_back({.device = "/dev/" + each.filename().string()});
        }
    }
    return found;
}

} // namespace tool
