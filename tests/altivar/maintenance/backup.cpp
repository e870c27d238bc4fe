// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A backup asks for as little as it can, and tells each parameter once, whatever the drive refuses.
#include <rtuwire/altivar/maintenance/backup.hpp>

#include <algorithm>
#include <vector>

#include "altivar/maintenance/maintenance_bench.hpp"
#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using namespace rtuwire::test;

namespace {

struct told_word {
    std::uint16_t address;
    result<std::uint16_t> word;
};

/// A sink that keeps all.
auto kept_in(std::vector<told_word>& all)
{
    return [&all](parameter_group const&, parameter const& row, result<std::uint16_t> const& word) {
        all.push_back({row.address, word});
    };
}

/// The addresses of a map, sorted, by a walk of the test's own.
std::vector<std::uint16_t> addresses_of(parameter_map const& map)
{
    std::vector<std::uint16_t> all;
    for (parameter_group const& group : map.groups()) {
        for (parameter const& each : group.rows) {
            all.push_back(each.address);
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// Whether each address was told once, in order.
bool is_each_once(std::vector<told_word> const& told, std::vector<std::uint16_t> const& all)
{
    return std::equal(told.begin(), told.end(), all.begin(), all.end(),
                      [](told_word const& one, std::uint16_t address) { return one.address == address; });
}

/// The fewest requests for these addresses, none of which reads another one: by trying all last blocks.
std::size_t fewest_requests(std::vector<std::uint16_t> const& all, std::size_t limit)
{
    std::vector<std::size_t> best(all.size() + 1, 0);
    for (std::size_t end = 1; end <= all.size(); ++end) {
        best[end] = best[end - 1] + 1;
        for (std::size_t begin = 0; begin < end; ++begin) {
            bool const is_block = std::size_t{all[end - 1]} - all[begin] == end - 1 - begin and end - begin <= limit;
            best[end] = is_block ? std::min(best[end], best[begin] + 1) : best[end];
        }
    }
    return best[all.size()];
}

/// Ten registers without a hole.
constexpr row_access rw{access::read_write, provenance::documented};
constexpr parameter ten[]{
    {"R0", 100, rw, in<count16>}, {"R1", 101, rw, in<count16>}, {"R2", 102, rw, in<count16>},
    {"R3", 103, rw, in<count16>}, {"R4", 104, rw, in<count16>}, {"R5", 105, rw, in<count16>},
    {"R6", 106, rw, in<count16>}, {"R7", 107, rw, in<count16>}, {"R8", 108, rw, in<count16>},
    {"R9", 109, rw, in<count16>},
};
constexpr parameter_group group_of_ten[]{{"ten", ten}};
constexpr parameter_map map_of_ten{group_of_ten};

/// Runs a backup against a set of refused registers, a bit each, without a line.
unsigned run_by_hand(unsigned culprits, std::vector<told_word>& told, errc refusal)
{
    backup conversation{paper_station, map_of_ten, kept_in(told)};
    unsigned requests = 0;
    while (auto const asked = conversation.next()) {
        REQUIRE(++requests < 100);
        std::uint16_t const start = u16_at(asked->frame(), 2);
        std::uint16_t const count = u16_at(asked->frame(), 4);
        REQUIRE((start >= 100 and start + count <= 110));
        unsigned const mask = ((1U << count) - 1U) << (start - 100U);
        if ((culprits & mask) != 0) {
            conversation.accept(refusal);
            continue;
        }
        std::array<std::byte, 2 + 2 * 10> pdu{std::byte{3}, static_cast<std::byte>(2 * count)};
        for (unsigned i = 0; i < count; ++i) {
            pdu[2 + 2 * i + 1] = static_cast<std::byte>(start + i);
        }
        conversation.accept(response{byte_view{pdu}.first(2U + 2U * count)});
    }
    REQUIRE(conversation.outcome().has_value());
    CHECK(conversation.read() + conversation.refused() == 10);
    return requests;
}

} // namespace

TEST_CASE("a backup reads every parameter once, in the order of addresses, by the fewest requests")
{
    paper_drive drive = small_drive();
    paper_bench bench{drive};
    std::vector<told_word> told;
    backup conversation{paper_station, small_map, kept_in(told)};
    REQUIRE(bench.line.run(conversation).has_value());
    auto const all = addresses_of(small_map);
    CHECK(all.size() == small_map.size());
    CHECK(is_each_once(told, all));
    for (told_word const& one : told) {
        CHECK(one.word == drive.word(one.address));
    }
    CHECK(conversation.read() == all.size());
    CHECK(conversation.refused() == 0);
    CHECK(drive.requests() == fewest_requests(all, 63));
    CHECK(drive.writes.empty());
}

TEST_CASE("whichever registers a drive refuses, each is told, and no other")
{
    for (errc const refusal : {errc::illegal_data_address, errc::illegal_data_value, errc::server_device_failure}) {
        for (unsigned culprits = 0; culprits < 1U << 10U; ++culprits) {
            std::vector<told_word> told;
            unsigned const requests = run_by_hand(culprits, told, refusal);
            REQUIRE(told.size() == 10);
            unsigned found = 0;
            for (unsigned i = 0; i < 10; ++i) {
                REQUIRE(told[i].address == 100 + i);
                found += told[i].word == refusal ? 1U << i : 0U;
                bool const is_read = told[i].word == static_cast<std::uint16_t>(100 + i);
                REQUIRE((is_read or told[i].word == refusal));
            }
            REQUIRE(found == culprits);
            // One register refused among ten costs its block, halves down to it, and the rest.
            bool const is_one = culprits != 0 and (culprits & (culprits - 1U)) == 0;
            REQUIRE(requests <= (culprits == 0 ? 1U : is_one ? 8U : 40U));
        }
    }
}

TEST_CASE("a backup ends at a failure, and says what it did not read")
{
    paper_drive drive = small_drive();
    paper_bench bench{drive};
    std::vector<told_word> told;
    backup conversation{paper_station, small_map, kept_in(told)};
    SECTION("of the line")
    {
        drive.before = [&](unsigned number) { number == 5 ? bench.line.cut() : void(); };
        CHECK(bench.line.run(conversation) == errc::timed_out);
        CHECK(conversation.read() > 0);
        CHECK(told.back().word == errc::timed_out);
    }
    SECTION("of a drive without the function")
    {
        for (auto& [address, one] : drive.registers) {
            one.refuses_read = errc::illegal_function;
        }
        CHECK(bench.line.run(conversation) == errc::illegal_function);
        CHECK(drive.requests() == 1);
        CHECK(told.front().word == errc::illegal_function);
    }
    CHECK(is_each_once(told, addresses_of(small_map)));
}

TEST_CASE("a comparison finds each difference of a setting, and nothing else")
{
    paper_drive drive = small_drive();
    word_list words;
    small_map.for_each([&](parameter const& row, parameter_group const&) {
        words[rtuwire::test::text_of(row.code)] = drive.word(row.address);
    });
    std::vector<std::string> differing;
    unsigned unknown = 0;
    auto const compare = [&] {
        differing.clear();
        paper_bench bench{drive};
        backup check{paper_station, small_map,
                     compared_with{words_by_code{&words}, [&](parameter_group const&, parameter const& row,
                                                              comparison found, result<std::uint16_t> const& held) {
                                       unknown += found == comparison::unknown ? 1U : 0U;
                                       if (found == comparison::differs) {
                                           CHECK(held == drive.word(row.address));
                                           differing.push_back(rtuwire::test::text_of(row.code));
                                       }
                                   }}};
        REQUIRE(bench.line.run(check).has_value());
    };
    compare();
    CHECK(differing.empty());

    // What the drive shows, counts or was ordered is no difference.
    std::vector<std::string> const no_settings{"ETA", "RFR", "TAC", "NCV", "IL1R", "CMD", "LFR", "CMI", "TUN"};
    small_map.for_each([&](parameter const& row, parameter_group const&) {
        std::string const code = rtuwire::test::text_of(row.code);
        drive.registers[row.address].word ^= 1U;
        compare();
        drive.registers[row.address].word ^= 1U;
        bool const is_setting_here = std::find(no_settings.begin(), no_settings.end(), code) == no_settings.end();
        CHECK(differing == (is_setting_here ? std::vector{code} : std::vector<std::string>{}));
    });

    drive.registers[9001].refuses_read = errc::illegal_data_address;
    compare();
    CHECK(differing.empty());
    CHECK(unknown == 1);
}
