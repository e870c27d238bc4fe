// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What holds of both functions that read bits, 01 and 02.
#pragma once

#include "support/pdu_facts.hpp"

#include <rtuwire/wire/views.hpp>

namespace rtuwire::test {

using namespace detail;

/// Of how many responses with 0 to 2001 bits something is wrong: those of 1 to 2000 bits come back in whole bytes, the
/// bits behind the last one 0; the others are refused. `bits` names the response's member.
template <typename Response, typename Bits> unsigned wrong_bit_responses(sample const& some, Bits bits)
{
    unsigned wrong = 0;
    for (std::size_t count = 0; count <= 2001; ++count) {
        Response const told{bit_view{some.bytes, count}};
        bool const is_right = count >= 1 and count <= 2000
                                  ? survives(told,
                                             [&](Response const& read) {
                                                 bit_view const all = read.*bits;
                                                 bool holds = all.size() == 8 * ((count + 7) / 8) and
                                                              bit_view{all.bytes(), count} == told.*bits;
                                                 for (std::size_t i = count; i < all.size(); ++i) {
                                                     holds = holds and not all[i];
                                                 }
                                                 return holds;
                                             })
                                  : is_refused(told, errc::invalid_quantity);
        wrong += is_right ? 0U : 1U;
    }
    return wrong;
}

} // namespace rtuwire::test
