// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A commander whose requests are made before they can leave: its order would be checked too early.
// EXPECT: a conversation that declares urgency::stop_of_unit also declares freshness::when_free
#include <rtuwire/client/client.hpp>

#include <optional>

using namespace rtuwire;
using namespace rtuwire::detail;

struct early_commander : commander {
#ifdef REFUSED
    static constexpr conversation_properties properties{.urgency = urgency::stop_of_unit};
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

void pass(drive_client<>& line, early_commander& conversation, instant now) { line.converse(conversation, now); }
