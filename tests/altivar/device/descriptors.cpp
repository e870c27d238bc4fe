// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the drives' rows say beyond address, name and unit: limits, values that are not to be written, and how well
// their source stands.
#include "support/proof.hpp"

#include <algorithm>
#include <array>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/server/typed_bank.hpp>
#include <rtuwire/table/read_plan.hpp>
#include <rtuwire/table/write_plan.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

template <auto const& R> constexpr bool takes(std::uint16_t word)
{
    return setting<R>::checked(from_word<value_of<R>>(word)).has_value();
}

// Inputs 3 and 4 can be anything that input 2 can, but "forward".
STATIC_CHECK(takes<atv28::li2>(2) and takes<atv28::li2>(3) and not takes<atv28::li2>(1));
STATIC_CHECK(not takes<atv28::li3>(2) and takes<atv28::li3>(3) and takes<atv28::li3>(17));
STATIC_CHECK(not takes<atv28::li4>(2) and takes<atv28::li4>(0) and takes<atv28::li4>(18));
STATIC_CHECK(not takes<atv28::li4>(6) and not takes<atv28::li4>(19));

// Reserved words are not written.
STATIC_CHECK(atv28::smih.mode == access::read_only and atv28::smah.mode == access::read_only);
STATIC_CHECK(atv28::spah.mode == access::read_only and atv28::spdh.mode == access::read_only);

// 200 to 240 V or 380 to 500 V, by the drive's supply; and never what lies between.
STATIC_CHECK(not takes<atv28::uns>(199) and takes<atv28::uns>(200) and takes<atv28::uns>(240));
STATIC_CHECK(not takes<atv28::uns>(241) and not takes<atv28::uns>(379));
STATIC_CHECK(takes<atv28::uns>(380) and takes<atv28::uns>(500) and not takes<atv28::uns>(501));
STATIC_CHECK(setting<atv28::uns>::clamped(volts{300}).word() == 240);

// Shown, not taken: the local control option; the control word of a drive that was just switched on.
STATIC_CHECK(takes<atv28::tcc>(1) and not takes<atv28::tcc>(2));
STATIC_CHECK(takes<atv28::cmd>(0x00EF) and not takes<atv28::cmd>(0x00F0));
STATIC_CHECK(takes<atv28::cmdd>(0x00F1) and not takes<atv28::cmdd>(0x00F0));

// Limits in raw counts, as printed.
STATIC_CHECK(takes<atv12::sfr>(20) and takes<atv12::sfr>(160));
STATIC_CHECK(not takes<atv12::sfr>(19) and not takes<atv12::sfr>(161));
STATIC_CHECK(not takes<atv12::tfr>(99) and takes<atv12::tfr>(4'000) and not takes<atv12::tfr>(4'001));
STATIC_CHECK(takes<atv12::hsp>(4'000) and not takes<atv12::hsp>(4'001));
STATIC_CHECK(takes<atv12::lsp>(0) and not takes<atv12::lsp>(4'001));
STATIC_CHECK(takes<atv310::acc>(9'999) and not takes<atv310::acc>(10'000));

// Enumerators that do not exist, at run time.
STATIC_CHECK(not takes<atv12::tbr>(25) and takes<atv12::tbr>(28));
STATIC_CHECK(not takes<atv320::chcf>(0) and not takes<atv320::chcf>(4) and takes<atv320::chcf>(3));

/// The addresses that a manual at hand prints for a drive.
constexpr std::array<std::uint16_t, 6> printed_320{3102, 3103, 3104, 3105, 9001, 9002};
constexpr std::array<std::uint16_t, 15> printed_310{3102, 3103, 3104, 3105, 3201, 3206, 6001, 6003,
                                                    6004, 6005, 8501, 8504, 8602, 8604, 9001};
constexpr bool is_scanner(std::uint16_t address) { return address / 100 == 127; }

template <typename Device, std::size_t Count>
constexpr unsigned unfounded(std::array<std::uint16_t, Count> const& printed, bool with_scanner)
{
    unsigned count = 0;
    Device::registers::for_each([&]<auto const & R>() {
        bool const is_printed = std::find(printed.begin(), printed.end(), R.address) != printed.end() or
                                (with_scanner and is_scanner(R.address));
        count += not is_printed and R.source == provenance::documented ? 1U : 0U;
    });
    return count;
}
STATIC_CHECK(unfounded<atv320::device>(printed_320, false) == 0);
STATIC_CHECK(unfounded<atv310::device>(printed_310, true) == 0);
STATIC_CHECK(unfounded<atv310::device_2026>(printed_310, true) == 0);

/// Rows whose number or name the scan of the bulletin lost.
constexpr bool says_what_was_rebuilt()
{
    constexpr std::array rebuilt{atv28::li3.source, atv28::li4.source,  atv28::lft.source,
                                 atv28::dp1.source, atv28::dp2.source,  atv28::dp3.source,
                                 atv28::dp4.source, atv28::ai1r.source, atv28::ncv.source};
    return std::count(rebuilt.begin(), rebuilt.end(), provenance::documented) == 0;
}
PROOF("a row that was rebuilt from a damaged source says so", says_what_was_rebuilt)

// Steps that the caller names stand for the register everywhere.
constexpr station<atv320::device> drive{unit_id{7}};
constexpr auto const& acc = restepped<centiseconds, atv320::acc>;
constexpr auto const& dec = restepped<centiseconds, atv320::dec>;
STATIC_CHECK(atv320::device::registers::contains<acc>);
STATIC_CHECK(not atv28::device::registers::contains<acc>);
STATIC_CHECK(write_plan<atv320::device, acc, dec>{1.3_s, 2_s}.words(0)[0] == 130);
STATIC_CHECK(read_plan<atv320::device, acc, dec>::request_count == 1);
STATIC_CHECK(bank<acc>{}.get<acc>() == centiseconds{0});

constexpr bool writes_its_steps()
{
    auto const request = write_all<acc, dec>(drive, 1.3_s, 2_s);
    byte_view const frame = request.next()->frame();
    return u16_at(frame, 7) == 130 and u16_at(frame, 9) == 200;
}
PROOF("a block counts in the steps that were named", writes_its_steps)

} // namespace
