// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a drive with all its parameters holds as delivered and as commissioned, what it keeps without power, and what it
// does with the parameters that are orders.
#include <rtuwire/sim/drive/drive.hpp>

#include "sim/drive/whole/whole_drives.hpp"

#include <cctype>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

/// A word of a drive by its address.
template <typename Device> std::uint16_t word_at(detail::simulated_drive<Device>& drive, std::uint16_t address)
{
    std::array<std::byte, 2> bytes{};
    byte_writer out{bytes};
    REQUIRE(drive.check_read(address, 1) == errc::none);
    static_cast<void>(drive.read(address, 1, out));
    return static_cast<std::uint16_t>(std::to_integer<unsigned>(bytes[0]) << 8U | std::to_integer<unsigned>(bytes[1]));
}

std::string upper(std::string text)
{
    for (char& each : text) {
        each = static_cast<char>(std::toupper(static_cast<unsigned char>(each)));
    }
    return text;
}

/// The factory value of a fact as a word; none where it tells none, or by a name that its values do not have.
std::optional<std::uint16_t> told_factory(test::fact const& of)
{
    if (of.is_number()) {
        auto const number = test::number_of(of.factory);
        return number ? std::optional{static_cast<std::uint16_t>(*number)} : std::nullopt;
    }
    for (auto const& [value, name] : of.values) {
        if (not of.factory.empty() and upper(name) == upper(of.factory)) {
            return value;
        }
    }
    return std::nullopt;
}

/// Whether a word lies inside what a fact tells.
bool is_inside(test::fact const& of, std::uint16_t word)
{
    std::int32_t const count = of.kind == "i16" ? std::int32_t{static_cast<std::int16_t>(word)} : std::int32_t{word};
    return (not of.least or count >= *of.least) and (not of.most or count <= *of.most) and
           (of.values.empty() or of.values.count(word) == 1);
}

/// Where the simulation has a value of its own: an ATV320 as delivered ramps in tenths of a second, and its headers do not
/// have the public list's factory values for the registers for driving.
bool has_own_value(std::string const& code)
{
    static std::set<std::string> const own{"NCV", "VCAL", "TBR", "TFO", "INR"};
    return own.count(code) == 1;
}

template <typename Device> void is_delivered_as_the_lists_say()
{
    test::drive_bench<Device> it;
    REQUIRE(it.tell(Device::layout.cmi, 0x0001) == errc::none);
    unsigned compared = 0;
    for (test::fact const& each : test::facts_about<Device>()) {
        bool const is_only_read = test::told(it.drive(), each.address, 0) == errc::illegal_data_address;
        if (not each.is_writable() or is_only_read) {
            continue;
        }
        CAPTURE(each.code);
        std::uint16_t const held = word_at(it.drive(), each.address);
        CHECK(is_inside(each, held));
        auto const factory = told_factory(each);
        if (factory and not has_own_value(each.code)) {
            CHECK(held == *factory);
            ++compared;
        }
    }
    CHECK(compared >= 25);
}

template <typename Device> void is_commissioned()
{
    test::drive_bench<Device> it;
    CHECK(it.word("CD1") == 10);
    CHECK(it.word("FR1") == 164);
    CHECK(it.word("CHCF") == 1);
    CHECK(it.word("SLL") == 1);
    CHECK(it.word("ADD") == 1);
    it.run(200);
    CHECK(it.frequency() == 20'000);
}

template <typename Device> void keeps_what_was_saved()
{
    test::drive_bench<Device> it;
    REQUIRE(it.tell(9001, 77) == errc::none);
    it.cycle_power();
    CHECK(it.word("ACC") == 30);
    REQUIRE(it.tell(9001, 77) == errc::none);
    REQUIRE(it.tell(9602, 600) == errc::none);
    REQUIRE(it.tell(5281, 500) == errc::none); // AIV1, a reference of the link
    REQUIRE(it.tell(Device::layout.cmi, 0x0002) == errc::none);
    it.cycle_power();
    CHECK(it.word("ACC") == 77);
    CHECK(it.word("FRS") == 600);
    CHECK(it.word("AIV1") == 0);
}

/// Factory settings by the menu.
template <typename Device> void recalls_by_the_menu()
{
    test::drive_bench<Device> it;
    test::drive_bench<Device> by_the_link;
    REQUIRE(it.tell(9001, 77) == errc::none);
    REQUIRE(it.tell(5281, 500) == errc::none);
    REQUIRE(it.tell(8002, 64) == errc::none); // FCS: InI
    REQUIRE(by_the_link.tell(Device::layout.cmi, 0x0001) == errc::none);
    CHECK(it.word("FCS") == 0);
    CHECK(it.word("AIV1") == 500);
    CHECK(it.word("ADD") == 0);
    it.wait(3'000);
    by_the_link.wait(3'000);
    for (test::fact const& each : test::facts_about<Device>()) {
        CAPTURE(each.code);
        bool const is_order = each.code == "AIV1" or each.code == "CMI";
        CHECK((is_order or word_at(it.drive(), each.address) == word_at(by_the_link.drive(), each.address)));
    }
}

template <typename Device> void does_not_recall_while_it_runs()
{
    test::drive_bench<Device> it;
    it.run(200);
    CHECK(it.tell(8002, 64) == errc::server_device_failure);
    CHECK(it.frequency() == 20'000);
}

template <typename Device> void refuses_orders_that_it_cannot_obey()
{
    test::drive_bench<Device> it;
    REQUIRE(it.tell(8001, 0) == errc::none);
    CHECK(it.tell(8001, 2) == errc::server_device_failure); // SCS: save as configuration 1
    CHECK(it.tell(8002, 2) == errc::server_device_failure); // FCS: load it
    CHECK(it.tell(8002, 71) == errc::server_device_failure);
    REQUIRE(it.tell(9608, 0) == errc::none);
    CHECK(it.tell(9608, 1) == errc::server_device_failure); // TUN
    CHECK(it.word("SCS") + it.word("FCS") + it.word("TUN") == 0);
    REQUIRE(it.tell(3120, 4) == errc::none); // RPR: the powered time
    CHECK(it.word("RPR") == 0);
}

} // namespace

TEST_CASE("a whole drive as delivered holds the factory values of the lists, and what they do not tell lies inside its "
          "limits")
{
    test::whole_drives::for_each([]<typename Device>() { is_delivered_as_the_lists_say<Device>(); });
}

TEST_CASE("a whole drive comes commissioned, and runs by the link")
{
    test::whole_drives::for_each([]<typename Device>() { is_commissioned<Device>(); });
}

TEST_CASE("a whole drive keeps its settings without power once they are saved, and orders never")
{
    test::whole_drives::for_each([]<typename Device>() { keeps_what_was_saved<Device>(); });
}

TEST_CASE("factory settings by the menu are those by the link, and come to no drive that runs")
{
    test::whole_drives::for_each([]<typename Device>() {
        recalls_by_the_menu<Device>();
        does_not_recall_while_it_runs<Device>();
    });
}

TEST_CASE("a whole drive refuses orders that its simulation cannot obey")
{
    test::whole_drives::for_each([]<typename Device>() { refuses_orders_that_it_cannot_obey<Device>(); });
    test::drive_bench<atv320::full_device> it;
    CHECK(it.tell(12901, 1) == errc::server_device_failure); // VAL
    CHECK(it.tell(7128, 1) == errc::server_device_failure);  // RP
    CHECK(it.tell(14962, 1) == errc::server_device_failure); // FBCD
}

TEST_CASE("ramps keep their counts when the size of their steps changes")
{
    test::drive_bench<atv320::full_device> it;
    REQUIRE(it.tell(9001, 77) == errc::none);
    for (std::uint16_t const step : std::array<std::uint16_t, 3>{0, 1, 2}) {
        REQUIRE(it.tell(9020, step) == errc::none);
        CHECK(it.word("ACC") == 77);
        CHECK(it.word("DEC") == 30);
    }
}

TEST_CASE("the bit rate of a communication card is not that of the line")
{
    detail::simulated_drive<atv320::full_device> drive{instant{0}};
    CHECK(drive.line().rate == 32);
    register_block const rate{std::uint16_t{24}};
    REQUIRE(drive.check_write(6603, rate) == errc::none); // BDR
    static_cast<void>(drive.write(6603, rate));
    CHECK(drive.line().rate == 32);
}
