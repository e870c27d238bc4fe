// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A snapshot: its values by register, and limits that hang on other registers taken from it.
#include <rtuwire/table/read_plan.hpp>

#include "support/proof.hpp"

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/wire/views.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

using plan = read_plan<atv28::device, atv28::lsp, atv28::hsp, atv28::tfr, atv28::sds, atv28::inv>;

/// What the drive holds: SDS 30, TFR 60.0 Hz, HSP 50.0 Hz, LSP 10.0 Hz, INV 4.1 A.
constexpr plan::snapshot now()
{
    plan::snapshot seen;
    for (std::size_t at = 0; at < plan::request_count; ++at) {
        address_block const block = plan::requests()[at];
        register_block<16> words;
        for (std::uint16_t i = 0; i < block.count; ++i) {
            std::uint32_t const address = std::uint32_t{block.start} + i;
            words.set(i, address == atv28::sds.address   ? 30
                         : address == atv28::tfr.address ? 600
                         : address == atv28::hsp.address ? 500
                         : address == atv28::lsp.address ? 100
                                                         : 41);
        }
        seen.store(at, words.view());
    }
    return seen;
}

constexpr bool takes_limits_from_the_snapshot()
{
    plan::snapshot const seen = now();
    auto const is_above = [](auto const& checked) { return checked.error() == errc::value_too_high; };
    auto const is_below = [](auto const& checked) { return checked.error() == errc::value_too_low; };
    bool const between = seen.checked<atv28::sp2>(decihertz{100}).has_value() and
                         seen.checked<atv28::sp2>(decihertz{500}).has_value() and
                         is_below(seen.checked<atv28::sp2>(9.9_Hz)) and
                         is_above(seen.checked<atv28::sp2>(decihertz{501}));
    bool const share = seen.checked<atv28::ith>(deciamperes{47}).has_value() and
                       is_above(seen.checked<atv28::ith>(deciamperes{48})) and
                       seen.checked<atv28::ith>(deciamperes{20}).has_value() and
                       is_below(seen.checked<atv28::ith>(deciamperes{19}));
    // 50.0 Hz at 30 rpm a hertz.
    bool const product =
        seen.checked<atv28::smil>(rpm{1500}).has_value() and is_above(seen.checked<atv28::smil>(rpm{1501}));
    return between and share and product and seen.checked<atv28::acc>(deciseconds{36'000}).has_value() and
           is_above(seen.checked<atv28::acc>(deciseconds{36'001}));
}
PROOF("limits that hang on other registers are those of the snapshot", takes_limits_from_the_snapshot)

} // namespace
