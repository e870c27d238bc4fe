// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Our server with every public function and the memory of agreement.hpp: unit 1 on the device named on the command
// line, until it is ended.
#include "agreement.hpp"

#include <rtuwire/server/banks.hpp>

#include "../served_device.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

struct device : word_bank<agreement::addresses> {
    bit_bank<agreement::addresses> switched{};
    bit_bank<agreement::addresses> contacts{};
    word_bank<agreement::addresses> measured{};
    std::array<std::byte, 251> id{};

    device()
    {
        for (std::uint32_t at = 0; at < agreement::addresses; ++at) {
            static_cast<void>(contacts.set(static_cast<std::uint16_t>(at), agreement::input_bit(at)));
            static_cast<void>(measured.set(static_cast<std::uint16_t>(at), agreement::input_word(at)));
        }
    }

    auto& coils() { return switched; }
    auto& discrete_inputs() { return contacts; }
    auto& input_registers() { return measured; }
    std::uint8_t exception_status() const { return static_cast<std::uint8_t>(get(agreement::status_at)); }
    byte_view server_id()
    {
        std::size_t const size = get(agreement::id_at) % (id.size() + 1);
        for (std::size_t i = 0; i < size; ++i) {
            id[i] = static_cast<std::byte>(get(static_cast<std::uint16_t>(agreement::id_at + 1 + i)));
        }
        return byte_view{id}.first(size);
    }
    errc read_fifo(std::uint16_t address, byte_writer& out) const
    {
        std::uint16_t const count = get(address) % 32U;
        for (std::uint16_t i = 1; i <= count; ++i) {
            out.u16(get(static_cast<std::uint16_t>(address + i)));
        }
        return errc::none;
    }
    static errc check_read_file(file_run) { return errc::none; }
    errc read_file(file_run run, byte_writer& out) const
    {
        for (std::size_t i = 0; i < run.count; ++i) {
            out.u16(get(agreement::memory::record_at(run.file, run.record + i)));
        }
        return errc::none;
    }
    static errc check_write_file(file_run, register_view) { return errc::none; }
    errc write_file(file_run run, register_view values)
    {
        for (std::size_t i = 0; i < values.size(); ++i) {
            static_cast<void>(set(agreement::memory::record_at(run.file, run.record + i), values[i]));
        }
        return errc::none;
    }
};

constexpr device_object objects[] = {{vendor_name, "rtuwire"},
                                     {product_code, "agreement"},
                                     {major_minor_revision, "0201"},
                                     {3, "https://example.org"},
                                     {4, "interoperability test"},
                                     {6, "0123456789012345678901234567890123456789"
                                         "0123456789012345678901234567890123456789"
                                         "0123456789012345678901234567890123456789"},
                                     {0x80, "0123456789012345678901234567890123456789"
                                            "0123456789012345678901234567890123456789"
                                            "0123456789012345678901234567890123456789"},
                                     {0xFF, "last"}};
constexpr server_profile profile{.identity = identity_of<objects>};

} // namespace

int main(int argc, char** argv)
{
    static device bank;
    // Function 08 ends by silence; socat and the system deliver a frame in one piece, or nearly so.
    auto const line = line_timing::host(115'200, character_format::none_8_1);
    basic_server<serial_diagnostics, public_functions> node{unit_id{1}, line, profile};
    return test::serve_device(argc, argv, line, node, bank);
}
