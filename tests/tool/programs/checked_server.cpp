// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Our servers in some of their kinds, for `check`: units 1 (and 2, of several) on the device of the command line, until it is ended.
//
//   checked_server DEVICE typed | hooks | units | counting
#include <cstdio>
#include <string_view>

#include <rtuwire/client.hpp>
#include <rtuwire/port.hpp>
#include <rtuwire/server.hpp>

using namespace rtuwire;

namespace {

constexpr device_object objects[] = {
    {vendor_name, "rtuwire"}, {product_code, "checked"}, {major_minor_revision, "1.0"}};
constexpr server_profile profile{.identity = identity_of<objects>};
constexpr auto line = line_timing::host(19'200, character_format::even_8_1);

constexpr reg<decihertz> s8{.code = "S8", .address = 8};
constexpr reg<decihertz> s9{.code = "S9", .address = 9};
constexpr reg<decihertz> s10{.code = "S10", .address = 10};
constexpr reg<decihertz> s11{.code = "S11", .address = 11};
constexpr reg<decihertz> s12{.code = "S12", .address = 12};
constexpr reg<decihertz> s13{.code = "S13", .address = 13};
constexpr reg<decihertz> s14{.code = "S14", .address = 14};
constexpr reg<decihertz> s15{.code = "S15", .address = 15};
constexpr reg<celsius> bearing{.code = "TMP", .address = 20, .mode = access::read_only};

using typed_bank = bank<s8, s9, s10, s11, s12, s13, s14, s15, bearing>;

struct io_module : word_bank<32> {
    bit_bank<32> outputs{};
    bit_bank<8> contacts{};
    word_bank<4> measured{};

    bit_bank<32>& coils() { return outputs; }
    bit_bank<8>& discrete_inputs() { return contacts; }
    word_bank<4>& input_registers() { return measured; }
};

using functions =
    function_list<read_coils, read_discrete_inputs, read_holding_registers, read_input_registers, write_single_coil,
                  write_single_register, write_multiple_coils<>, write_multiple_registers<>, mask_write_register,
                  read_write_multiple_registers<>, read_device_identification>;

template <typename Server, typename... Bank> int serves(posix_serial& port, Server node, Bank&... banks)
{
    // Nothing is heard before the line was silent once.
    instant const silent = port.now() + line.frame_end() + milliseconds(10);
    while (not reached(port.now(), silent)) {
        static_cast<void>(serve_once(node, port, banks..., milliseconds(10)));
    }
    std::puts("ready");
    std::fflush(stdout);
    while (serve_once(node, port, banks..., milliseconds(200))) {
    }
    std::fprintf(stderr, "%s\n", port.failure().c_str());
    return 1;
}

} // namespace

int main(int argc, char** argv)
{
    posix_serial port;
    if (argc != 3 or not port.open(argv[1])) {
        std::fprintf(stderr, "%s\n", argc == 3 ? port.failure().c_str() : "usage: checked_server DEVICE KIND");
        return 2;
    }
    std::string_view const kind{argv[2]};
    typed_bank typed;
    io_module io;
    word_bank<16> words{100};
    if (kind == "typed") {
        return serves(port, server{unit_id{1}, line, profile}, typed);
    }
    if (kind == "hooks") {
        auto served = with_hooks(typed).check<s8>([](decihertz) { return errc::none; }).on_write<s8>([&](decihertz) {
            typed.set<bearing>(celsius{20});
        });
        return serves(port, server{unit_id{1}, line, profile}, served);
    }
    if (kind == "units") {
        return serves(port, server::with<functions>::for_units(line, bank_at{unit_id{1}, io, profile},
                                                               bank_at{unit_id{2}, words}));
    }
    if (kind == "counting") {
        return serves(port, counting_server::with<functions>{unit_id{1}, line, profile}, io);
    }
    std::fprintf(stderr, "there is no kind '%s'\n", argv[2]);
    return 2;
}
