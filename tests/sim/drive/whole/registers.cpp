// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive with all its parameters answers for each register of the lists and for no other, and takes what they say.
#include <rtuwire/sim/drive/drive.hpp>

#include "sim/drive/whole/whole_drives.hpp"

#include <vector>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

template <typename Device> std::set<std::uint32_t> known_addresses()
{
    std::set<std::uint32_t> known;
    for (test::fact const& each : test::facts_about<Device>()) {
        known.insert(each.address);
    }
    if (Device::name == literal{"atv310"} or Device::name == literal{"atv310_2026"}) {
        for (auto const& [address, code] : test::beside_the_lists) {
            known.insert(address);
        }
    }
    return known;
}

template <typename Device> void answers_for_these_addresses_alone()
{
    auto const known = known_addresses<Device>();
    detail::simulated_drive<Device> const drive{instant{0}};
    std::vector<std::uint32_t> wrong;
    for (std::uint32_t address = 0; address < 0x1'0000; ++address) {
        auto const place = static_cast<std::uint16_t>(address);
        bool const is_known = known.count(address) == 1;
        bool const is_next_known = known.count(address + 1) == 1;
        bool const is_read = drive.check_read(place, 1) == errc::none;
        bool const are_both_read = drive.check_read(place, 2) == errc::none;
        bool const is_missing = drive.check_read(place, 2) == errc::illegal_data_address;
        if (is_read != is_known or are_both_read != (is_known and is_next_known) or are_both_read == is_missing) {
            wrong.push_back(address);
        }
    }
    CHECK(wrong == std::vector<std::uint32_t>{});
    CHECK(known.size() == Device::registers::size);
}

/// The words beside a limit, as far as a word has them; `least` and `most` themselves are taken.
template <typename Device> unsigned wrong_at_limits(detail::simulated_drive<Device> const& drive, test::fact const& of)
{
    std::int32_t const floor = of.kind == "i16" ? -32'768 : 0;
    std::int32_t const ceiling = of.kind == "i16" ? 32'767 : 65'535;
    auto const takes = [&](std::int32_t count) {
        errc const verdict = test::told(drive, of.address, static_cast<std::uint32_t>(count));
        REQUIRE((verdict == errc::none or verdict == errc::illegal_data_value));
        return verdict == errc::none;
    };
    unsigned wrong = 0;
    if (of.least) {
        wrong += takes(*of.least) ? 0U : 1U;
        wrong += *of.least > floor and takes(*of.least - 1) ? 1U : 0U;
    }
    if (of.most) {
        wrong += takes(*of.most) ? 0U : 1U;
        wrong += *of.most < ceiling and takes(*of.most + 1) ? 1U : 0U;
    }
    return wrong;
}

/// Registers that a client commands with, whose words are limited when they are obeyed; the three limits of the speed and
/// an order, which are tested by themselves; and one whose limits only the ATV12's headers have.
bool is_limited_elsewhere(std::string const& code, bool is_atv12)
{
    static std::set<std::string> const elsewhere{"LFR", "LFRD", "HSP", "LSP", "TFR", "VAL"};
    return elsewhere.count(code) == 1 or (code == "SFR" and not is_atv12);
}

template <typename Device> void keeps_limits()
{
    detail::simulated_drive<Device> const drive{instant{0}};
    unsigned tried = 0;
    for (test::fact const& each : test::facts_about<Device>()) {
        bool const is_atv12 = Device::name == literal{"atv12"};
        if (each.is_number() and each.is_writable() and not is_limited_elsewhere(each.code, is_atv12) and
            not test::tells_little(each)) {
            CAPTURE(each.code);
            CHECK(wrong_at_limits(drive, each) == 0);
            ++tried;
        }
    }
    CHECK(tried >= 20);
}

/// Words to try in an enumeration: all that are near a value, and some far from any.
std::set<std::uint16_t> words_around(test::fact const& of)
{
    std::set<std::uint16_t> words{0x00FF, 0x7FFF, 0x8000, 0xFFFF};
    for (std::uint16_t word = 0; word < 300; ++word) {
        words.insert(word);
    }
    for (auto const& [value, name] : of.values) {
        words.insert({static_cast<std::uint16_t>(value - 1), value, static_cast<std::uint16_t>(value + 1)});
    }
    return words;
}

/// What a standing drive says to a word of an enumeration; orders that it cannot obey are refused for that.
errc expected(test::fact const& of, std::uint16_t word)
{
    static std::set<std::string> const orders{"SCS", "TUN", "RP", "FBCD"};
    if (of.values.count(word) == 0) {
        return errc::illegal_data_value;
    }
    bool const is_order = orders.count(of.code) == 1 and word != 0;
    bool const is_recall = of.code == "FCS" and word != 0 and word != 64;
    return is_order or is_recall ? errc::server_device_failure : errc::none;
}

template <typename Device> void takes_words_with_a_meaning()
{
    detail::simulated_drive<Device> const drive{instant{0}};
    unsigned tried = 0;
    for (test::fact const& each : test::facts_about<Device>()) {
        if (each.kind != "enum" or not each.is_writable() or each.values.empty()) {
            continue;
        }
        CAPTURE(each.code);
        unsigned wrong = 0;
        for (std::uint16_t const word : words_around(each)) {
            wrong += test::told(drive, each.address, word) == expected(each, word) ? 0U : 1U;
        }
        CHECK(wrong == 0);
        ++tried;
    }
    CHECK(tried >= 10);
}

/// How many registers the lists let a client write, and the drive does not: those of which the lists tell too little.
template <typename Device> unsigned only_read()
{
    detail::simulated_drive<Device> const drive{instant{0}};
    unsigned count = 0;
    for (test::fact const& each : test::facts_about<Device>()) {
        CAPTURE(each.code);
        bool const is_refused =
            test::told(drive, each.address, drive.word(literal{"ETA"})) == errc::illegal_data_address;
        if (not each.is_writable()) {
            CHECK(is_refused);
        } else if (is_refused) {
            CHECK(test::tells_little(each));
            ++count;
        }
    }
    return count;
}

template <typename Device> void configures_at_rest_alone()
{
    test::drive_bench<Device> it;
    it.run(200);
    REQUIRE(it.state() == cia402::state::operation_enabled);
    unsigned tried = 0;
    for (test::fact const& each : test::facts_about<Device>()) {
        auto const row = it.drive().check_read(each.address, 1);
        REQUIRE(row == errc::none);
        errc const verdict = test::told(it.drive(), each.address, 0xFFFF);
        CAPTURE(each.code);
        if (each.access == "conf" and not(test::tells_little(each) and verdict == errc::illegal_data_address)) {
            CHECK(verdict == errc::server_device_failure);
            ++tried;
        }
    }
    CHECK(tried >= 30);
}

} // namespace

TEST_CASE("a whole drive has the registers of the lists, and answers for no other with anything but exception 02")
{
    test::whole_drives::for_each([]<typename Device>() { answers_for_these_addresses_alone<Device>(); });
}

TEST_CASE("a whole drive takes the least and the most of each register, and refuses what is beyond")
{
    test::whole_drives::for_each([]<typename Device>() { keeps_limits<Device>(); });
}

TEST_CASE("a whole drive takes each value of an enumeration, and refuses a word without a meaning")
{
    test::whole_drives::for_each([]<typename Device>() { takes_words_with_a_meaning<Device>(); });
}

TEST_CASE("a whole drive lets nobody write what is only read, nor what is too little known")
{
    CHECK(only_read<atv12::full_device>() == 1);
    CHECK(only_read<atv310::full_device>() == 0);
    CHECK(only_read<atv320::full_device>() == 19);
}

TEST_CASE("a whole drive with power on refuses its configuration")
{
    test::whole_drives::for_each([]<typename Device>() { configures_at_rest_alone<Device>(); });
}
