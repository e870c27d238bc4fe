// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The serial ports that a system tells of: adapters on USB, a port on the board, and places that have no hardware.
#include "port/serial_ports.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/catch.hpp"

#include "port/device_holder.hpp"

namespace {

namespace fs = std::filesystem;

void write(fs::path const& file, std::string const& text)
{
    fs::create_directories(file.parent_path());
    std::ofstream{file} << text;
}

/// A folder that looks like the root of such a system.
class system_folder {
public:
    system_folder()
    {
        std::string name = (fs::temp_directory_path() / "ports-XXXXXX").string();
        root_ = ::mkdtemp(name.data());
    }
    system_folder(system_folder const&) = delete;
    system_folder& operator=(system_folder const&) = delete;
    ~system_folder() { fs::remove_all(root_); }

    fs::path const& root() const { return root_; }

    /// A port, its hardware and its driver.
    void add(std::string const& name, std::string const& hardware, std::string const& driver) const
    {
        fs::path const device = root_ / "sys/devices" / hardware;
        fs::create_directories(device);
        fs::create_directories(root_ / "sys/drivers" / driver);
        fs::create_directories(root_ / "sys/class/tty" / name);
        fs::create_directory_symlink(root_ / "sys/drivers" / driver, device / "driver");
        fs::create_directory_symlink(device, root_ / "sys/class/tty" / name / "device");
        write(root_ / "dev" / name, "");
    }

private:
    fs::path root_{};
};

} // namespace

TEST_CASE("serial ports with hardware are told, with what an adapter says of itself")
{
    system_folder const system;
    system.add("ttyUSB0", "usb1/1-2/1-2:1.0/ttyUSB0", "ftdi_sio");
    system.add("ttyS0", "pnp0/00:04", "serial");
    system.add("ttyS4", "pnp0/00:04/00:04:0/00:04:0.0", "port");
    system.add("ttyS5", "platform/serial8250/serial8250:0/serial8250:0.0", "port");
    for (std::string const each : {"pnp0/00:04/00:04:0", "platform/serial8250/serial8250:0"}) {
        fs::create_directories(system.root() / "sys/drivers/ctrl");
        fs::create_directory_symlink(system.root() / "sys/drivers/ctrl",
                                     system.root() / "sys/devices" / each / "driver");
    }
    system.add("ttyS1", "platform/serial8250", "serial8250");
    fs::create_directories(system.root() / "sys/class/tty/tty1");
    write(system.root() / "sys/devices/usb1/1-2/product", "FT232R USB UART\n");
    write(system.root() / "sys/devices/usb1/1-2/manufacturer", "FTDI\n");
    write(system.root() / "sys/devices/usb1/1-2/serial", "A1\n");
    fs::create_directories(system.root() / "dev/serial/by-id");
    fs::create_symlink("../../ttyUSB0", system.root() / "dev/serial/by-id/usb-FTDI_A1-if00-port0");
    fs::create_symlink("../../ttyUSB9", system.root() / "dev/serial/by-id/usb-gone");

    auto const found = tool::serial_ports(system.root().string());
    REQUIRE(found.size() == 3);
    CHECK((found[1].device == "/dev/ttyS4" and found[1].driver == "serial"));
    CHECK((found[0].device == "/dev/ttyS0" and found[0].driver == "serial" and found[0].product.empty()));
    CHECK((found[2].device == "/dev/ttyUSB0" and found[2].driver == "ftdi_sio"));
    CHECK((found[2].maker == "FTDI" and found[2].product == "FT232R USB UART" and found[2].serial == "A1"));
    CHECK(found[2].stable == "/dev/serial/by-id/usb-FTDI_A1-if00-port0");
    CHECK(tool::serial_ports("/nowhere").empty());
}

TEST_CASE("serial ports of macOS are told by the names that wait for no modem")
{
    system_folder const system;
    for (std::string const name : {"cu.usbserial-A1", "tty.usbserial-A1", "null", "cu.Bluetooth-Incoming-Port"}) {
        write(system.root() / "dev" / name, "");
    }
    auto const found = tool::serial_ports(system.root().string());
    REQUIRE(found.size() == 2);
    CHECK(found[0].device == "/dev/cu.Bluetooth-Incoming-Port");
    CHECK((found[1].device == "/dev/cu.usbserial-A1" and found[1].driver.empty()));
}

TEST_CASE("the group that may open a device is told, with what makes one a member")
{
    system_folder const system;
    fs::path const device = system.root() / "ttyUSB0";
    write(device, "");
    group const* const owner = ::geteuid() == 0 ? ::getgrnam("tty") : ::getgrgid(::getegid());
    REQUIRE(owner != nullptr);
    std::string const name = owner->gr_name;
    REQUIRE(::chown(device.c_str(), static_cast<uid_t>(-1), owner->gr_gid) == 0);
    ::chmod(device.c_str(), 0660);
    std::string const words = tool::words_of_group(device.string());
    CHECK(words.starts_with("it belongs to the group " + name + ": `sudo usermod -aG " + name + ' '));
    CHECK(words.ends_with("`, then log in anew"));
    ::chmod(device.c_str(), 0600); // a group may not open it: being one of it is no help
    CHECK(tool::words_of_group(device.string()).empty());
    CHECK(tool::words_of_group((system.root() / "none").string()).empty());
}
