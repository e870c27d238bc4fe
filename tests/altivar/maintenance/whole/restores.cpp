// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Configurations drawn from the lists of registers, carried from one simulated drive to another over a bad line.
#include <rtuwire/altivar/maintenance/restore.hpp>

#include <sstream>

#include "altivar/maintenance/whole/whole_bench.hpp"
#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;

namespace {

constexpr restore_options all_but_the_address{.with_channels = true,
                                              .with_link = true,
                                              .with_inferred = true,
                                              .with_supervision = true,
                                              .with_autorestart = true,
                                              .terminals = {.accept_unseen_inputs = true}};

/// Draws a configuration, gives it to one drive, and restores it to another one that has a configuration of its own.
/// Returns what of it the second drive does not hold.
template <typename Drive> std::string carried(std::uint32_t seed, std::uint32_t lost_in_a_million)
{
    test::random from{seed};
    whole_bench<Drive> first;
    whole_bench<Drive> second;
    configure(first, from, 60);
    configure(second, from, 10);
    second.set(6005, 300); // TTO: a drive that trips between two requests takes no channel until it is reset
    address_words const wanted = read_all(first);
    second.line.wire() = sim::line{whole_line, seed};
    second.line.wire().set_faults({.lost = lost_in_a_million});
    restore conversation{
        second.drive, Drive::map,
        wanted_settings{drive_family::of(std::string{Drive::name}),
                        [&](parameter const& row) -> std::optional<std::uint16_t> { return wanted.at(row.address); }},
        [](parameter_group const&, parameter const&, restore_report const&) {}, all_but_the_address};
    auto const how = second.line.run(conversation, milliseconds(3'000'000));
    std::ostringstream wrong;
    if (how.kind != outcome_kind::succeeded) {
        wrong << "ends as " << static_cast<unsigned>(how.kind) << ", " << static_cast<unsigned>(how.error) << "; ";
    }
    for (fact const& each : rtuwire::test::facts_of(Drive::name)) {
        parameter const* const row = Drive::map.at(each.address);
        if (row != nullptr and row->is_writable() and not is_left_alone(each.code) and not is_of_safety(each) and
            second.word(each.address) != first.word(each.address)) {
            wrong << each.code << ' ' << second.word(each.address) << " for " << first.word(each.address) << "; ";
        }
    }
    for (std::uint16_t const limit : std::array<std::uint16_t, 3>{3103, 3104, 3105}) {
        wrong << (second.word(limit) == first.word(limit) ? "" : "a limit; ");
    }
    return wrong.str();
}

template <typename Drive> void carry_all(std::uint32_t count)
{
    for (std::uint32_t seed = 1; seed <= count; ++seed) {
        INFO(Drive::name << ", seed " << seed);
        REQUIRE(carried<Drive>(seed, 10'000) == "");
    }
}

} // namespace

TEMPLATE_TEST_CASE("a configuration is carried from a drive to another over a line that loses one frame in a hundred",
                   "", whole_atv12, whole_atv310, whole_atv320)
{
    carry_all<TestType>(8);
}

TEMPLATE_TEST_CASE("1 000 configurations are carried from a drive to another over such a line", "[.long]", whole_atv12,
                   whole_atv310, whole_atv320)
{
    carry_all<TestType>(1'000);
}
