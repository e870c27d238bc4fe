// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a maker's header declares, as types: a fact that does not hold does not compile. The facts were written from the headers
// that each names and compile with these, too, unless the file says that it was not tried.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#define DECLARES(function, ...) static_assert(std::is_same_v<decltype(function), __VA_ARGS__>)
/// One of several functions of a name.
#define OVERLOAD(function, ...) static_assert(static_cast<__VA_ARGS__>(&function) != nullptr)
#define VALUE(name, value) static_assert(static_cast<long long>(name) == (value))
#define MEMBER(object, member, ...) static_assert(std::is_same_v<decltype(object::member), __VA_ARGS__>)
/// A function of a class, which may be its base's and may have others of its name beside it.
#define METHOD(object, result, function, ...)                                                                          \
    static_assert(static_cast<result (object::*)(__VA_ARGS__)>(&object::function) != nullptr)
