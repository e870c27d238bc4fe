// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Write plans: neighbours in one request, gaps never written, the device's limit kept.
#include <rtuwire/table/write_plan.hpp>

#include "support/proof.hpp"

#include <rtuwire/altivar/atv12.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

using ramps = write_plan<atv12::device, atv12::de2, atv12::acc, atv12::dec, atv12::ac2>;
STATIC_CHECK(ramps::request_count == 2);
STATIC_CHECK(ramps::requests()[0] == address_block{9001, 2});
STATIC_CHECK(ramps::requests()[1] == address_block{9012, 2});

constexpr bool keeps_the_words_in_address_order()
{
    ramps const plan{4_s, 1.3_s, 2_s, 3_s};
    auto const first = plan.words(0);
    auto const second = plan.words(1);
    using test::is;
    return is(first.size() == 2, "the first request has two words") and is(first[0] == 13, "its first") and
           is(first[1] == 20, "its second") and is(second.size() == 2, "the second request has two words") and
           is(second[0] == 30, "its first") and is(second[1] == 40, "its second");
}
PROOF("the words stand in the order of their addresses", keeps_the_words_in_address_order)

} // namespace
