// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A whole drive is read by a client over a line, and all that was read is written to another one: which then holds it.
#include <rtuwire/sim/bench.hpp>

#include "sim/drive/whole/whole_drives.hpp"
#include "support/random.hpp"

#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

using words = std::map<std::uint16_t, std::uint16_t>;

/// A drive on a line, and what a client sees of it.
template <typename Device> class seen_drive {
public:
    [[nodiscard]] result<std::uint16_t> read(std::uint16_t address)
    {
        single_request ask{station_.unit(), read_holding_registers{.start = address, .count = 1}};
        auto const outcome = bench_.run(ask);
        if (not outcome) {
            return outcome.error();
        }
        auto const response = outcome->template to<read_holding_registers>();
        if (not response) {
            return response.error();
        }
        return response->registers[0];
    }

    [[nodiscard]] errc write(std::uint16_t address, std::uint16_t word)
    {
        single_request tell{station_.unit(), write_single_register{.address = address, .value = word}};
        auto const outcome = bench_.run(tell);
        if (not outcome) {
            return outcome.error();
        }
        auto const response = outcome->template to<write_single_register>();
        return response ? errc::none : response.error();
    }

    /// Every register of the lists.
    [[nodiscard]] words all(std::vector<test::fact> const& facts)
    {
        words held;
        for (test::fact const& each : facts) {
            auto const word = read(each.address);
            CAPTURE(each.code);
            REQUIRE(word);
            held[each.address] = *word;
        }
        return held;
    }

    detail::simulated_drive<Device>& drive() { return bench_.drive(); }

private:
    station<Device> station_{unit_id{7}};
    sim::bench<host_client, sim::unit<Device>> bench_{line_timing{38'400, character_format::even_8_1}, station_};
};

/// What a setting may be set to, by the lists alone; none where it is an order, the line's own, or too little known.
std::optional<std::uint16_t> any_word(test::fact const& of, test::random& random)
{
    static std::set<std::string> const others{"CMD", "CMDD", "LFR",  "LFRD", "CMI", "PISP", "RPR", "SCS",  "FCS", "TUN",
                                              "RP",  "VAL",  "FBCD", "AIV1", "ADD", "TBR",  "TFO", "TTO",  "HSP", "LSP",
                                              "TFR", "CHCF", "CD1",  "FR1",  "FLO", "SLL",  "INR", "OL1R", "AO1R"};
    bool const is_scanner = of.address >= 12'701 and of.address <= 12'768;
    if (not of.is_writable() or test::tells_little(of) or others.count(of.code) == 1 or is_scanner) {
        return std::nullopt;
    }
    if (not of.values.empty()) {
        auto chosen = of.values.begin();
        std::advance(chosen, random.below(static_cast<std::uint32_t>(of.values.size())));
        return chosen->first;
    }
    std::int32_t const least = of.least.value_or(0);
    std::int32_t const most = of.most.value_or(of.kind == "i16" ? 32'767 : 65'535);
    return static_cast<std::uint16_t>(
        least + static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(most - least + 1))));
}

/// The limits of the speed are first let go, then set from the highest down; the rest follows, as any order will do.
template <typename Device>
unsigned refusals(seen_drive<Device>& to, words const& wanted, std::vector<test::fact> const& of)
{
    constexpr std::uint16_t tfr = 3103, hsp = 3104, lsp = 3105;
    unsigned refused = to.write(lsp, 0) == errc::none and to.write(hsp, 0) == errc::none ? 0U : 1U;
    for (std::uint16_t const address : {tfr, hsp, lsp}) {
        refused += to.write(address, wanted.at(address)) == errc::none ? 0U : 1U;
    }
    for (test::fact const& each : of) {
        bool const is_done = each.address == tfr or each.address == hsp or each.address == lsp;
        if (each.is_writable() and not is_done and not test::tells_little(each)) {
            CAPTURE(each.code);
            errc const verdict = to.write(each.address, wanted.at(each.address));
            CHECK(verdict == errc::none);
            refused += verdict == errc::none ? 0U : 1U;
        }
    }
    return refused;
}

template <typename Device> void is_read_and_written_back()
{
    auto const facts = test::facts_about<Device>();
    seen_drive<Device> from;
    test::random random{11};
    unsigned changed = 0;
    for (test::fact const& each : facts) {
        CAPTURE(each.code);
        auto const word = any_word(each, random);
        if (word) {
            REQUIRE(from.write(each.address, *word) == errc::none);
            ++changed;
        }
    }
    REQUIRE(from.write(3103, 450) == errc::illegal_data_value); // TFR below HSP
    REQUIRE(from.write(3104, 123) == errc::none);
    REQUIRE(from.write(3103, 450) == errc::none);
    CHECK(changed >= 14);

    words const held = from.all(facts);
    seen_drive<Device> to;
    CHECK(to.all(facts) != held);
    CHECK(refusals(to, held, facts) == 0);
    CHECK(to.all(facts) == held);
}

} // namespace

TEST_CASE("all of a whole drive is read over a line, and written to another one that then holds it")
{
    test::whole_drives::for_each([]<typename Device>() { is_read_and_written_back<Device>(); });
}
