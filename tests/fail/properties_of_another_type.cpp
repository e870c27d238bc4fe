// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A write that must not be repeated, said in a type that no client looks at.
// EXPECT: the `properties` of a conversation are public
#include <rtuwire/client.hpp>

#include <optional>

using namespace rtuwire;

struct one_write : asker {
#ifndef REFUSED
    static constexpr conversation_properties properties{.repetition = repetition::never};
#else
    static constexpr repetition properties = repetition::never;
#endif
    std::optional<request_frame> next() const { return std::nullopt; }
    void accept(result<response> const&) {}
    bool settled() const { return true; }
};

void pass(client& line, one_write& conversation, instant now) { line.converse(conversation, now); }
