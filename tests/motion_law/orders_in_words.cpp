// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Orders that stand in a word that is read are not given again when it is written.
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <cstdint>

#include <rtuwire/altivar/procedure/commissioning/save_to_eeprom.hpp>
#include <rtuwire/ask/single_request.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

template <typename Device> void saves_after_factory_settings()
{
    test::simulated_bus<drive_client<4>, Device> it{drive_client<4>{test::bus_timing, patient}};
    it.add(unit_id{3});
    it.idle(milliseconds(20));
    constexpr station<Device> drive{unit_id{3}};
    // CMI as it stands where somebody ordered factory settings by it.
    constexpr std::uint8_t factory_settings = 0x01;
    bool is_reading = false;
    std::vector<std::uint16_t> told;
    it.disturb([&](std::vector<std::byte>& frame, bool is_request) {
        bool const is_cmi = is_request and u16_at(byte_view{frame}, 2) == Device::layout.cmi;
        if (is_cmi and frame[1] == std::byte{6}) {
            told.push_back(u16_at(byte_view{frame}, 4));
        }
        if (not is_request and is_reading) {
            frame = {frame[0], frame[1], frame[2], std::byte{0}, std::byte{factory_settings}};
            std::uint16_t const crc = crc16(frame);
            frame.push_back(to_byte(crc));
            frame.push_back(to_byte(crc >> 8U));
        }
        is_reading = is_cmi and frame[1] == std::byte{3};
    });
    save_to_eeprom save{drive};
    REQUIRE(it.run(save));
    CHECK(save.succeeded());
    REQUIRE(told.size() == 2);
    CHECK(told[0] == 0x0002);
    CHECK(told[1] == 0x0000);
}

} // namespace

TEST_CASE("motion law: S20 a save behind factory settings does not order them again")
{
    test::all_drives::for_each([]<typename Device>() { saves_after_factory_settings<Device>(); });
}
