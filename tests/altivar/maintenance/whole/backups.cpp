// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Backups and comparisons of simulated drives with all their parameters.
#include <rtuwire/altivar/maintenance/backup.hpp>

#include <vector>

#include "altivar/maintenance/whole/whole_bench.hpp"
#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;

namespace {

/// The fewest reads for these addresses, of at most 63 registers each and of no other one: the cheapest last read for
/// each end.
std::size_t fewest_reads(std::vector<std::uint16_t> const& sorted)
{
    std::vector<std::size_t> best(sorted.size() + 1, 0);
    for (std::size_t end = 1; end <= sorted.size(); ++end) {
        best[end] = best[end - 1] + 1;
        for (std::size_t begin = end; begin-- > 0 and end - begin <= 63;) {
            bool const has_hole = sorted[end - 1] - sorted[begin] != static_cast<int>(end - 1 - begin);
            best[end] = has_hole ? best[end] : std::min(best[end], best[begin] + 1);
        }
    }
    return best[sorted.size()];
}

} // namespace

TEMPLATE_TEST_CASE("a backup of a whole drive takes hardly more than the fewest requests", "", whole_atv12,
                   whole_atv310, whole_atv320)
{
    whole_bench<TestType> bench;
    std::size_t requests = 0;
    std::vector<std::uint16_t> told;
    backup conversation{bench.drive, TestType::map,
                        [&](parameter_group const&, parameter const& row, result<std::uint16_t> const& word) {
                            CHECK(word == bench.word(row.address));
                            told.push_back(row.address);
                        }};
    std::vector<std::byte> last;
    auto const count = [&](instant) {
        if (auto const asked = conversation.next()) {
            std::vector<std::byte> const now(asked->frame().begin(), asked->frame().end());
            requests += now != last ? 1U : 0U;
            last = now;
        }
    };
    REQUIRE(bench.line.run_until([&] { return conversation.settled(); }, milliseconds(600'000), conversation, count));
    REQUIRE(conversation.outcome().has_value());
    CHECK(conversation.refused() == 0);
    CHECK(std::is_sorted(told.begin(), told.end()));
    CHECK(told.size() == TestType::map.size());
    std::size_t const fewest = fewest_reads(told);
    CHECK(requests >= fewest);
    CHECK(requests * 10 <= fewest * 11);
}

TEST_CASE("of 200 single changes, drawn from the lists, a comparison finds each, and nothing else")
{
    whole_bench<whole_atv320> bench;
    address_words const before = read_all(bench);
    CHECK(before == read_all(bench));
    std::vector<std::uint16_t> found;
    auto const wanted = [&](parameter const& row) -> std::optional<std::uint16_t> { return before.at(row.address); };
    auto const compare = [&] {
        found.clear();
        backup check{bench.drive, atv320::parameters,
                     compared_with{wanted, [&](parameter_group const&, parameter const& row, comparison how,
                                               result<std::uint16_t> const&) {
                                       if (how != comparison::equal and how != comparison::not_compared) {
                                           found.push_back(row.address);
                                       }
                                   }}};
        REQUIRE(bench.line.run(check, milliseconds(600'000)).has_value());
    };
    compare();
    CHECK(found.empty());
    test::random from{200};
    std::vector<fact> all = rtuwire::test::facts_of("atv320");
    std::erase_if(all, [](fact const& each) {
        parameter const* const row = atv320::parameters.at(each.address);
        return row == nullptr or not row->is_writable() or is_left_alone(each.code);
    });
    for (unsigned changes = 0; changes < 200;) {
        fact const& each = all[from.below(static_cast<std::uint32_t>(all.size()))];
        std::uint16_t const old = bench.word(each.address);
        bench.set(each.address, drawn_word(each, from));
        if (bench.word(each.address) == old) {
            continue;
        }
        ++changes;
        INFO(each.code);
        compare();
        CHECK(found == std::vector{each.address});
        bench.set(each.address, old);
        REQUIRE(bench.word(each.address) == old);
    }
}
