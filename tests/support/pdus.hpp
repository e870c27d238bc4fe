// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The one list of the kinds of PDU, for tests and fuzz targets that try all of them: the requests and responses of the
// public functions, the exception, and bytes that nobody interprets.
#pragma once

// Beside this header: fuzz targets have no folder of tests to search.
#include "type_list.hpp"

#include <rtuwire/serial_line.hpp>
#include <rtuwire/wire/functions.hpp>
#include <rtuwire/wire/raw.hpp>

namespace rtuwire::test {

template <typename List, typename T> struct with;
template <typename... Ts, typename T> struct with<type_list<Ts...>, T> {
    using type = std::conditional_t<type_list<Ts...>::template contains<T>, type_list<Ts...>, type_list<Ts..., T>>;
};

/// The requests and responses of functions, each once, behind those that a list holds already.
template <typename List, typename... Functions> struct pdus_of {
    using type = List;
};
template <typename List, typename First, typename... Others> struct pdus_of<List, First, Others...> {
    using type = typename pdus_of<typename with<typename with<List, First>::type, typename First::response>::type,
                                  Others...>::type;
};
template <typename List, typename... Functions> struct pdus_of<List, function_list<Functions...>> {
    using type = typename pdus_of<List, Functions...>::type;
};

using all_pdus = pdus_of<type_list<exception_response, raw_pdu<>>, public_functions>::type;

} // namespace rtuwire::test
