// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A conversation that commands a motor and whose stops would wait for their turn.
// EXPECT: a commander declares its urgency: a stop comes before all other requests
#include <rtuwire/client/client.hpp>

#include <optional>

using namespace rtuwire;
using namespace rtuwire::detail;

struct silent_commander : commander {
#ifdef REFUSED
    static constexpr conversation_properties properties{.freshness = freshness::when_free};
#else
    static constexpr conversation_properties properties{.urgency = urgency::stop_of_unit,
                                                        .freshness = freshness::when_free};
#endif
    std::optional<request_frame> next() const { return std::nullopt; }
    void accept(result<response> const&) {}
    bool settled() const { return true; }
    unit_id unit() const { return unit_id{1}; }
    effect intent() const { return effect::stopping; }
    duration drive_timeout() const { return milliseconds(1'000); }
    std::uint8_t tolerated_misses() const { return 0; }
    void note_loss() {}
};

void pass(drive_client<>& line, silent_commander& conversation, instant now) { line.converse(conversation, now); }
