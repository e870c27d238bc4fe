// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A commander that cannot be told that its unit was lost.
// EXPECT: a conversation that declares urgency::stop_of_unit has note_loss(), intent(), drive_timeout() and tolerated_misses()
#include <rtuwire/client/client.hpp>

#include <optional>

using namespace rtuwire;
using namespace rtuwire::detail;

struct careless_commander : commander {
    static constexpr conversation_properties properties{.urgency = urgency::stop_of_unit,
                                                        .freshness = freshness::when_free};
    std::optional<request_frame> next() const { return std::nullopt; }
    void accept(result<response> const&) {}
    bool settled() const { return true; }
    unit_id unit() const { return unit_id{1}; }
    effect intent() const { return effect::stopping; }
    duration drive_timeout() const { return milliseconds(1'000); }
    std::uint8_t tolerated_misses() const { return 0; }
#ifndef REFUSED
    void note_loss() {}
#endif
};

void pass(drive_client<>& line, careless_commander& conversation, instant now) { line.converse(conversation, now); }
