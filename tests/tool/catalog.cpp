// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The catalog of the tool: rows as the manuals print them, all registers as the library's tables have them, and texts
// as the library makes them where it knows the type.
#include "catalog/catalog.hpp"

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "support/drives.hpp"

#include <rtuwire/altivar/atv12_parameters.hpp>
#include <rtuwire/altivar/atv310_parameters.hpp>
#include <rtuwire/altivar/atv320_parameters.hpp>
#include <rtuwire/table/register_text.hpp>

#include "catalog/value_text.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

std::string string_of(literal text) { return {text.begin(), text.end()}; }

tool::register_entry const& entry(std::string_view drive, std::string_view code)
{
    tool::drive_catalog const* const catalog = tool::catalog_named(drive);
    REQUIRE(catalog != nullptr);
    tool::register_entry const* const found = catalog->by_code(code);
    REQUIRE(found != nullptr);
    return *found;
}

/// How many of some words of a register have another text in the catalog than in the library.
template <auto const& R> std::size_t different_texts(tool::register_entry const& row, std::uint32_t every)
{
    std::size_t count = 0;
    for (std::uint32_t word = 0; word <= 0xFFFF; word += every) {
        auto const here = static_cast<std::uint16_t>(word);
        auto const text = text_of(from_word<value_of<R>>(here));
        count += tool::text_of(row, here) == std::string(text.begin(), text.end()) ? 0U : 1U;
    }
    return count;
}

} // namespace

TEST_CASE("the catalog has the rows of the manuals")
{
    tool::register_entry const& acc = entry("ATV12", "acc");
    CHECK(acc.address == 9001);
    CHECK((acc.unit == "s" and acc.step.numerator == 1 and acc.step.denominator == 10));
    CHECK((acc.min.raw() == 0 and acc.max.raw() == 9999 and acc.factory == 30));
    CHECK((acc.kind == tool::register_kind::number and acc.mode == access::read_write));

    CHECK(entry("atv320", "RFR").kind == tool::register_kind::signed_number);
    CHECK(entry("atv320", "ACC").steps_set_by == "INR");
    CHECK(tool::text_of_bound(entry("atv310", "HSP").max) == "TFR");
    CHECK(tool::text_of_bound(entry("atv28", "ITH").max) == "23/20 INV");
    CHECK(tool::text_of_bound(entry("atv28", "SMAL").max) == "1/10 TFR*SDS");
    CHECK((entry("atv28", "UNS").gap_first == 241 and entry("atv28", "UNS").gap_last == 379));
    CHECK(entry("atv28", "AI2").source == provenance::doubtful);
    CHECK(entry("atv320", "ETA").bits[3] == "fault");
    CHECK(entry("atv320", "ETA").bits[8].empty());
    CHECK(entry("atv28", "ETA").bits[4] == "mains_absent");
    CHECK(entry("atv28", "ETI3").bits[0].empty());

    tool::drive_catalog const& old = *tool::catalog_named("atv28");
    CHECK((old.limits.read == 7 and old.limits.exchange_read == 0 and old.units.last == 31));
    CHECK_FALSE(old.functions.contains(function_code::read_write_multiple_registers));
    CHECK((old.layout.cmd == 400 and old.speed_reference == 603 and old.frequency_reference == 401));
    CHECK(old.at(459)->code == "ETI");
    CHECK(old.at(463) == nullptr);
    CHECK(tool::catalog_named("atv99") == nullptr);
}

TEST_CASE("the catalog has all registers of all drives, each once, in the order of addresses")
{
    std::size_t drives = 0;
    test::all_drives::for_each([&]<typename Device>() {
        ++drives;
        tool::drive_catalog const* const catalog = tool::catalog_named(string_of(Device::name));
        REQUIRE(catalog != nullptr);
        REQUIRE(catalog->registers.size() >= Device::registers::size);
        for (std::size_t i = 1; i < catalog->registers.size(); ++i) {
            CHECK(catalog->registers[i - 1].address < catalog->registers[i].address);
        }
        std::size_t for_driving = 0;
        for (tool::register_entry const& each : catalog->registers) {
            for_driving += each.is_for_driving ? 1U : 0U;
        }
        CHECK(for_driving == Device::registers::size);
        Device::registers::for_each([&]<auto const & R>() {
            INFO(string_of(R.code));
            tool::register_entry const* const row = catalog->at(R.address);
            REQUIRE((row != nullptr and row == catalog->by_code(string_of(R.code))));
            CHECK((row->name == string_of(R.name) and row->mode == R.mode and row->factory == R.factory));
            CHECK((row->lowest_count() == lowest<R>() and row->highest_count() == highest<R>()));
            CHECK((row->source == R.source and row->is_for_driving));
        });
    });
    CHECK(tool::all_catalogs().size() == drives);
}

TEST_CASE("the catalog has the parameters of the public lists, each with its row and its group")
{
    // That the maps are the lists, tests/parameters/compare.py says.
    using namespace rtuwire::altivar;
    auto const all = [](std::string_view drive) { return tool::catalog_named(drive)->registers.size(); };
    CHECK(all("atv12") == atv12::parameters.size() + atv12::unverified_parameters.size());
    CHECK(all("atv320") == atv320::parameters.size() + atv320::unverified_parameters.size());
    CHECK(all("atv310_2026") == atv310::parameters.size());
    CHECK(all("atv310") == atv310::parameters_2014.size());
    for (tool::drive_catalog const* const drive : tool::all_catalogs()) {
        std::set<std::string_view> codes;
        for (tool::register_entry const& each : drive->registers) {
            INFO(drive->name << ' ' << each.code);
            CHECK(codes.insert(each.code).second);
            REQUIRE(each.row != nullptr);
            CHECK((each.row->address == each.address and std::string_view{each.row->code} == each.code));
            CHECK((each.row->mode() == each.mode and not each.group.empty()));
            CHECK((each.source != provenance::doubtful or not drive->map.by_code(each.code)->is_writable() or
                   each.is_writable()));
        }
    }
    CHECK(entry("atv320", "SP2").group == "functions_speed");
    CHECK(entry("atv320", "SP2").unit == "Hz");
    CHECK(entry("atv320", "CLI").mode == access::read_only); // unverified
    CHECK(entry("atv28", "CMD").group == "command");
    CHECK(entry("atv28", "ACC").group == "settings");
    CHECK(entry("atv28", "RFR").group == "monitoring");
}

TEST_CASE("an ATV310 has the numbers of its menu, each revision its own")
{
    tool::drive_catalog const& old = *tool::catalog_named("atv310");
    tool::drive_catalog const& later = *tool::catalog_named("atv310_2026");
    CHECK((old.by_menu("701")->code == "ADD" and old.by_menu("705.3")->code == "NMA4"));
    CHECK((old.by_menu("705.4") == nullptr and later.by_menu("705.4")->code == "NMA5"));
    CHECK((old.by_menu("502.0") == nullptr and later.by_menu("502.0")->code == "STT"));
    CHECK((old.by_menu("") == nullptr and old.by_menu("999") == nullptr));
    CHECK(tool::catalog_named("atv320")->by_menu("701") == nullptr);
}

TEST_CASE("a text of the catalog is that of the library, for words of each register")
{
    test::all_drives::for_each([]<typename Device>() {
        tool::drive_catalog const* const catalog = tool::catalog_named(string_of(Device::name));
        Device::registers::for_each([&]<auto const & R>() {
            INFO(string_of(R.code));
            CHECK(different_texts<R>(*catalog->at(R.address), 53) == 0);
        });
    });
}

TEST_CASE("a text of the catalog is that of the library, for each word of some registers")
{
    namespace of = altivar::atv320;
    tool::drive_catalog const& drive = *tool::catalog_named("atv320");
    CHECK(different_texts<of::rfr>(*drive.at(3202), 1) == 0); // tenths, with a sign
    CHECK(different_texts<of::lft>(*drive.at(7121), 1) == 0); // an enumeration with meanings
    CHECK(different_texts<of::eta>(*drive.at(3201), 1) == 0); // bits
    CHECK(different_texts<of::sfr>(*drive.at(3102), 1) == 0); // hundreds
    CHECK(different_texts<of::cos>(*drive.at(9606), 1) == 0); // hundredths of nothing
    CHECK(different_texts<of::lfrd>(*drive.at(8602), 1) == 0);
    CHECK(different_texts<altivar::atv28::ai2r>(entry("atv28", "AI2R"), 1) == 0); // millionths
}

TEST_CASE("bits are told in words, and a step that another register sets is taken from there")
{
    CHECK(tool::full_text(entry("atv320", "ETA"), 0x0208) == "0x0208 (fault, remote)");
    CHECK(tool::full_text(entry("atv320", "ETA"), 0x0100) == "0x0100 (bit 8)");
    CHECK(tool::full_text(entry("atv320", "ETA"), 0) == "0x0000 (none)");
    CHECK(tool::full_text(entry("atv320", "RFR"), 0xFFFB) == "-0.5 Hz");

    tool::drive_catalog const& drive = *tool::catalog_named("atv320");
    tool::register_entry const& acc = entry("atv320", "ACC");
    CHECK_FALSE(tool::step_of(acc, drive));
    CHECK_FALSE(tool::step_of(acc, drive, 7));
    CHECK(tool::text_of(acc, 150, *tool::step_of(acc, drive, 0)) == "1.50 s");
    CHECK(tool::text_of(acc, 150, *tool::step_of(acc, drive, 1)) == "15.0 s");
    CHECK(tool::text_of(acc, 150, *tool::step_of(acc, drive, 2)) == "150 s");
}

TEST_CASE("a limit or a step that another register sets is one of the same drive")
{
    for (tool::drive_catalog const* drive : tool::all_catalogs()) {
        for (tool::register_entry const& each : drive->registers) {
            INFO(drive->name << ' ' << each.code);
            for (bound const& limit : {each.min, each.max}) {
                CHECK((limit.code().size() == 0 or drive->by_code(string_of(limit.code())) != nullptr));
                CHECK((limit.factor().size() == 0 or drive->by_code(string_of(limit.factor())) != nullptr));
            }
            CHECK((each.steps_set_by.empty() or drive->by_code(each.steps_set_by) != nullptr));
        }
    }
}

TEST_CASE("no two values or bits of a register have one name")
{
    for (tool::drive_catalog const* drive : tool::all_catalogs()) {
        for (tool::register_entry const& each : drive->registers) {
            INFO(drive->name << ' ' << each.code);
            std::set<std::string> names;
            for (choice const& value : each.values()) {
                CHECK(names.insert(string_of(value.mnemonic)).second);
            }
            for (std::string_view const bit : each.bits) {
                CHECK((bit.empty() or names.insert(std::string{bit}).second));
            }
        }
    }
}
