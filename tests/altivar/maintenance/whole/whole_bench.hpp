// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Simulated drives with all their parameters at the end of a line, configurations drawn from the lists of registers, and
// what the drives then hold.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/drive/whole/facts.hpp"
#include "support/random.hpp"

#include <rtuwire/altivar/atv12_parameters.hpp>
#include <rtuwire/altivar/atv310_parameters.hpp>
#include <rtuwire/altivar/atv320_parameters.hpp>
#include <rtuwire/altivar/maintenance/backup.hpp>
#include <rtuwire/altivar/maintenance/restore.hpp>
#include <rtuwire/sim/bench.hpp>

namespace rtuwire::test {

using namespace detail;

/// A drive with all its parameters, and what the lists call it.
struct whole_atv12 {
    using device = altivar::atv12::full_device;
    static constexpr altivar::parameter_map const& map = altivar::atv12::parameters;
    static constexpr char const* name = "atv12";
};
struct whole_atv310 {
    using device = altivar::atv310::full_device;
    static constexpr altivar::parameter_map const& map = altivar::atv310::parameters;
    static constexpr char const* name = "atv310";
};
struct whole_atv320 {
    using device = altivar::atv320::full_device;
    static constexpr altivar::parameter_map const& map = altivar::atv320::parameters;
    static constexpr char const* name = "atv320";
};

inline constexpr line_timing whole_line{19'200, character_format::even_8_1};

template <typename Drive> struct whole_bench {
    static constexpr station<typename Drive::device> drive{unit_id{1}};

    sim::bench<drive_client<2>, sim::unit<typename Drive::device>> line{
        drive_client<2>{whole_line, client_options{.response_timeout = milliseconds(100), .retries = 5}}, drive};

    /// What it holds, without a line.
    [[nodiscard]] std::uint16_t word(std::uint16_t address)
    {
        std::array<std::byte, 2> place{};
        byte_writer out{place};
        static_cast<void>(line.drive().read(address, 1, out));
        return u16_at(byte_view{place}, 0);
    }

    /// Writes a word without a line, as its own keypad would; what it refuses stays.
    void set(std::uint16_t address, std::uint16_t word)
    {
        register_block const value{word};
        if (line.drive().check_write(address, value) == errc::none) {
            static_cast<void>(line.drive().write(address, value));
        }
    }
};

/// Words by addresses.
using address_words = std::map<std::uint16_t, std::uint16_t>;

/// All that a drive tells over its line.
template <typename Drive> address_words read_all(whole_bench<Drive>& bench)
{
    address_words all;
    altivar::backup conversation{
        bench.drive, Drive::map,
        [&](altivar::parameter_group const&, altivar::parameter const& row, result<std::uint16_t> const& word) {
            if (word) {
                all[row.address] = *word;
            }
        }};
    static_cast<void>(bench.line.run(conversation, milliseconds(600'000)));
    return all;
}

/// What no configuration of these tests touches: what does something when it is written, what the line needs, and the
/// limits, which are drawn together.
inline bool is_left_alone(std::string const& code)
{
    static char const* const codes[]{"CMD",  "CMDD", "CMI",  "LFR",  "LFRD", "PISP", "AIV1", "SCS", "FCS", "TUN",
                                     "RP",   "RPR",  "VAL",  "FBCD", "CIC",  "OL1R", "AO1R", "ADD", "TBR", "TFO",
                                     "SMIL", "SMAL", "SPAL", "SPAT", "SPDL", "SPDT", "LSP",  "HSP", "TFR", "NCV",
                                     "VCAL", "SPN",  "PPI",  "TAC",  "TAC2", "PET",  "CFG"};
    bool const is_scanner_word = code.size() == 3 and code.substr(0, 2) == "NC" and code[2] >= '1' and code[2] <= '8';
    return is_scanner_word or std::find(std::begin(codes), std::end(codes), code) != std::end(codes);
}

/// The registers of an ATV320's safety functions: compared, and never written.
inline bool is_of_safety(fact const& of) { return of.address >= 15'300 and of.address <= 15'331; }

/// A word for a register, as the lists have its values.
inline std::uint16_t drawn_word(fact const& of, random& from)
{
    if (not of.values.empty()) {
        auto at = of.values.begin();
        std::advance(at, static_cast<long>(from.below(static_cast<std::uint32_t>(of.values.size()))));
        return at->first;
    }
    std::int32_t const least = of.least.value_or(0);
    std::int32_t const most = std::max(of.most.value_or(least + 100), least);
    return static_cast<std::uint16_t>(
        least + static_cast<std::int32_t>(from.below(static_cast<std::uint32_t>(most - least) + 1U)));
}

/// Gives a drive a configuration drawn from the lists of registers: a share of all that can be written, in percent.
template <typename Drive> void configure(whole_bench<Drive>& bench, random& from, std::uint32_t share)
{
    std::uint16_t const tfr = static_cast<std::uint16_t>(500 + from.below(3'000));
    std::uint16_t const hsp = static_cast<std::uint16_t>(from.below(tfr + 1U));
    std::uint16_t const lsp = static_cast<std::uint16_t>(from.below(hsp + 1U));
    bench.set(3105, 0), bench.set(3103, tfr), bench.set(3104, hsp), bench.set(3103, tfr), bench.set(3105, lsp);
    for (fact const& each : rtuwire::test::facts_of(Drive::name)) {
        if (each.is_writable() and not is_left_alone(each.code) and not is_of_safety(each) and
            from.below(100) < share) {
            bench.set(each.address, drawn_word(each, from));
        }
    }
}

} // namespace rtuwire::test
