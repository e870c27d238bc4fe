// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What the registry of Windows says of its serial ports. None is opened for it. Empty on other systems.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rtuwire/core/version.hpp>
#include <rtuwire/port/platform.hpp>

#ifdef _WIN32

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// UTF-8 as Windows' own text, and back.
[[nodiscard]] inline std::wstring wide(std::string_view text)
{
    int const size = ::MultiByteToWideChar(CP_UTF8, 0, text.data(), static_cast<int>(text.size()), nullptr, 0);
    std::wstring its(static_cast<std::size_t>(size), L'\0');
    ::MultiByteToWideChar(CP_UTF8, 0, text.data(), static_cast<int>(text.size()), its.data(), size);
    return its;
}
[[nodiscard]] inline std::string narrow(std::wstring_view text)
{
    int const length = static_cast<int>(text.size());
    int const size = ::WideCharToMultiByte(CP_UTF8, 0, text.data(), length, nullptr, 0, nullptr, nullptr);
    std::string its(static_cast<std::size_t>(size), '\0');
    ::WideCharToMultiByte(CP_UTF8, 0, text.data(), length, its.data(), size, nullptr, nullptr);
    return its;
}

/// What Windows says of one of its errors: in English, where it has that.
[[nodiscard]] inline std::string windows_text(DWORD error)
{
    std::array<wchar_t, 256> text{};
    for (DWORD const language : {DWORD{0x409}, DWORD{0}}) {
        DWORD size = ::FormatMessageW(FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS, nullptr, error,
                                      language, text.data(), static_cast<DWORD>(text.size()), nullptr);
        while (size > 0 and (text[size - 1] <= L' ' or text[size - 1] == L'.')) {
            --size;
        }
        if (size > 0) {
            return narrow({text.data(), size});
        }
    }
    return "Windows error " + std::to_string(error);
}

/// A key of the registry, open to read; closed by its destructor.
class registry_key {
public:
    registry_key(HKEY above, std::wstring const& name) noexcept
    {
        if (above == nullptr or ::RegOpenKeyExW(above, name.c_str(), 0, KEY_READ, &key_) != ERROR_SUCCESS) {
            key_ = nullptr;
        }
    }
    registry_key(registry_key const&) = delete;
    registry_key& operator=(registry_key const&) = delete;
    ~registry_key()
    {
        if (key_ != nullptr) {
            ::RegCloseKey(key_);
        }
    }

    [[nodiscard]] HKEY get() const noexcept { return key_; }

    /// The names of the keys below it.
    [[nodiscard]] std::vector<std::wstring> keys() const
    {
        std::vector<std::wstring> found;
        std::array<wchar_t, 256> name{};
        for (DWORD i = 0;; ++i) {
            auto size = static_cast<DWORD>(name.size());
            if (key_ == nullptr or
                ::RegEnumKeyExW(key_, i, name.data(), &size, nullptr, nullptr, nullptr, nullptr) != ERROR_SUCCESS) {
                return found;
            }
            found.emplace_back(name.data(), size);
        }
    }

    /// Its values that are texts: their names and what they say.
    [[nodiscard]] std::vector<std::pair<std::wstring, std::wstring>> texts() const
    {
        std::vector<std::pair<std::wstring, std::wstring>> found;
        std::array<wchar_t, 256> name{};
        for (DWORD i = 0;; ++i) {
            auto size = static_cast<DWORD>(name.size());
            LSTATUS const told = key_ == nullptr
                                     ? ERROR_NO_MORE_ITEMS
                                     : ::RegEnumValueW(key_, i, name.data(), &size, nullptr, nullptr, nullptr, nullptr);
            if (told != ERROR_SUCCESS) {
                return found;
            }
            if (std::wstring text = this->text(name.data()); not text.empty()) {
                found.emplace_back(std::wstring{name.data(), size}, std::move(text));
            }
        }
    }

    /// A value that is a text; empty where there is none, or it is longer than anybody wants.
    [[nodiscard]] std::wstring text(std::wstring const& value) const
    {
        std::array<wchar_t, 512> text{};
        auto size = static_cast<DWORD>(sizeof text - sizeof(wchar_t)); // what is there need not end with a zero
        DWORD kind = 0;
        bool const is_text = key_ != nullptr and
                             ::RegQueryValueExW(key_, value.c_str(), nullptr, &kind,
                                                reinterpret_cast<BYTE*>(text.data()), &size) == ERROR_SUCCESS and
                             kind == REG_SZ;
        return is_text ? std::wstring{text.data()} : std::wstring{};
    }

private:
    HKEY key_{nullptr};
};

/// A device that was a serial port at some time, whether it is there now or not.
struct port_device {
    std::string port{};     ///< "COM3"
    std::string bus{};      ///< "USB", "FTDIBUS", "ACPI"
    std::string hardware{}; ///< what the bus calls it: "VID_1A86&PID_7523"
    std::string instance{}; ///< of the adapter: its serial number where it has one
    std::string name{};     ///< "USB-SERIAL CH340 (COM3)"
    std::string maker{};    ///< "wch.cn", or "@oem5.inf,%ftdi%;FTDI"
    std::string driver{};
};

/// All that Windows remembers of.
[[nodiscard]] inline std::vector<port_device> port_devices()
{
    std::vector<port_device> found;
    registry_key const devices{HKEY_LOCAL_MACHINE, L"SYSTEM\\CurrentControlSet\\Enum"};
    for (std::wstring const& bus : devices.keys()) {
        registry_key const on_bus{devices.get(), bus};
        for (std::wstring const& hardware : on_bus.keys()) {
            registry_key const of_hardware{on_bus.get(), hardware};
            for (std::wstring const& instance : of_hardware.keys()) {
                registry_key const device{of_hardware.get(), instance};
                std::wstring const port = registry_key{device.get(), L"Device Parameters"}.text(L"PortName");
                if (port.starts_with(L"COM")) {
                    found.push_back({narrow(port), narrow(bus), narrow(hardware), narrow(instance),
                                     narrow(device.text(L"FriendlyName")), narrow(device.text(L"Mfg")),
                                     narrow(device.text(L"Service"))});
                }
            }
        }
    }
    return found;
}

/// Whether a port is behind a USB bus, as Windows names that: USB's own drivers, and that of FTDI, which is a bus.
[[nodiscard]] inline bool is_usb_port(std::string_view name)
{
    auto const is_same = [](std::string_view one, std::string_view other) {
        return ::CompareStringOrdinal(wide(one).c_str(), -1, wide(other).c_str(), -1, TRUE) == CSTR_EQUAL;
    };
    std::string_view const port = name.starts_with("\\\\.\\") ? name.substr(4) : name;
    for (port_device const& each : port_devices()) {
        if (is_same(each.port, port) and (is_same(each.bus, "USB") or is_same(each.bus, "FTDIBUS"))) {
            return true;
        }
    }
    return false;
}

/// The text of a setup file behind its place there.
[[nodiscard]] inline std::string without_place(std::string const& text)
{
    std::size_t const at = text.starts_with('@') ? text.rfind(';') : text.npos;
    return at == text.npos ? text : text.substr(at + 1);
}

/// What an adapter has as its serial number. Where it has none, Windows makes up a name, which has an ampersand.
[[nodiscard]] inline std::string serial_of(port_device const& device)
{
    if (device.bus == "FTDIBUS") { // VID_0403+PID_6001+A9XYZ123A: the last letter is of one of its ports
        std::string const last = device.hardware.substr(device.hardware.rfind('+') + 1);
        return last.substr(0, last.empty() ? 0 : last.size() - 1);
    }
    return device.bus == "USB" and device.instance.find('&') == std::string::npos ? device.instance : std::string{};
}

} // namespace detail

/// A serial port that is there, and what its adapter says of itself; texts are empty where that is not known.
struct win32_port {
    std::string name{};    ///< "COM3"
    std::string driver{};  ///< "FTSER2K"
    std::string maker{};   ///< "FTDI"
    std::string product{}; ///< "USB Serial Port"
    std::string serial{};  ///< the adapter's serial number
};

/// The serial ports of this computer, by their numbers. None is opened.
[[nodiscard]] inline std::vector<win32_port> win32_ports()
{
    std::vector<detail::port_device> const devices = detail::port_devices();
    std::vector<win32_port> found;
    detail::registry_key const there{HKEY_LOCAL_MACHINE, L"HARDWARE\\DEVICEMAP\\SERIALCOMM"};
    for (auto const& [_, name] : there.texts()) {
        win32_port port{.name = detail::narrow(name)};
        auto const is_it = [&](detail::port_device const& each) { return each.port == port.name; };
        auto const device = std::ranges::find_if(devices, is_it);
        if (std::ranges::count_if(devices, is_it) == 1) { // two that had this name: nobody tells which one is there
            std::string const behind = " (" + port.name + ")";
            port.driver = device->driver;
            port.maker = detail::without_place(device->maker);
            port.product = detail::without_place(device->name);
            if (port.product.ends_with(behind)) {
                port.product.resize(port.product.size() - behind.size());
            }
            port.serial = detail::serial_of(*device);
        }
        found.push_back(std::move(port));
    }
    std::ranges::sort(found, {}, [](win32_port const& each) { // COM2 is before COM10
        return std::pair{each.name.size(), std::string_view{each.name}};
    });
    return found;
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

#endif
