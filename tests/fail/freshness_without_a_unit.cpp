// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A request that is made when the line is free for its unit, of a conversation that names none.
// EXPECT: a conversation that declares freshness::when_free has a unit()
#include <rtuwire/client/client.hpp>

#include <optional>

using namespace rtuwire;

struct late_read : asker {
    static constexpr conversation_properties properties{.freshness = freshness::when_free};
    std::optional<request_frame> next() const { return std::nullopt; }
    void accept(result<response> const&) {}
    bool settled() const { return true; }
#ifndef REFUSED
    unit_id unit() const { return unit_id{1}; }
#endif
};

void pass(client& line, late_read& conversation, instant now) { line.converse(conversation, now); }
