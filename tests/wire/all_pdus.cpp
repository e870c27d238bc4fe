// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What holds of every kind of PDU.
#include "support/pdus.hpp"

#include "support/proof.hpp"

#include <rtuwire/wire/function.hpp>

using namespace rtuwire;
using test::all_pdus;

namespace {

struct response_is_listed {
    template <typename Pdu> constexpr bool operator()() const
    {
        if constexpr (requires { typename Pdu::response; }) {
            return all_pdus::contains<typename Pdu::response>;
        } else {
            return true;
        }
    }
};
STATIC_CHECK(all_pdus::all_of(response_is_listed{}));

struct refuses_no_bytes {
    template <typename Pdu> constexpr bool operator()() const { return not Pdu::decode(byte_view{}).has_value(); }
};
STATIC_CHECK(all_pdus::all_of(refuses_no_bytes{}));

struct refuses_other_functions {
    template <typename Pdu> constexpr bool operator()() const
    {
        constexpr std::array<std::byte, 5> of_no_function{std::byte{0x63}};
        return std::is_same_v<Pdu, raw_pdu<>> or not Pdu::decode(of_no_function).has_value();
    }
};
STATIC_CHECK(all_pdus::all_of(refuses_other_functions{}));

} // namespace
