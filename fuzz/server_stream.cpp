// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Any bytes in any chunking and any pauses to a server: it never answers more than it was asked, and
// what it says is a frame of its own unit.
#include <array>
#include <cstdint>
#include <cstdlib>

#include <rtuwire/rtuwire.hpp>

#include "../tests/support/whole_bank.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr device_object objects[] = {{0, "vendor"}, {1, "code"}, {2, "0100"}};
constexpr server_profile profile{.identity = identity_of<objects>};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    basic_server<serial_diagnostics, public_functions> node{unit_id{1}, line_timing{19'200, character_format::even_8_1},
                                                            profile};
    test::whole_bank bank;
    instant now{0xFFFF'0000U};
    node.advance(now);
    now = now + milliseconds(10);
    node.advance(now);
    while (size > 0) {
        // One byte says how many follow at once, how long the pause is, and whether a CRC follows.
        std::size_t const count = data[0] % 16U < size - 1 ? data[0] % 16U : size - 1;
        std::array<std::byte, 18> lump{};
        for (std::size_t i = 0; i < count; ++i) {
            lump[i] = static_cast<std::byte>(data[1 + i]);
        }
        std::uint16_t const crc = crc16(byte_view{lump}.first(count));
        lump[count] = to_byte(crc);
        lump[count + 1] = to_byte(std::uint32_t{crc} >> 8U);
        bool const has_crc = (data[0] & 0x10U) != 0;
        now = now + microseconds((data[0] >> 5U) * 700U);
        node.receive(byte_view{lump}.first(count + (has_crc ? 2U : 0U)), now);
        node.advance(now);
        node.serve(bank, now);
        byte_view const response = node.poll_transmit();
        if (not response.empty()) {
            auto const said = decode_adu(response);
            if (not said or said->unit() != 1) {
                std::abort();
            }
            node.sent(now);
        }
        data += 1 + count;
        size -= 1 + count;
    }
    return 0;
}
