// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A stop that comes first, of a conversation whose orders and stops no client knows.
// EXPECT: a conversation that declares an urgency derives from commander
#include <rtuwire/client/client.hpp>

#include <optional>

using namespace rtuwire;
using namespace rtuwire::detail;

#ifdef REFUSED
using kind = asker;
#else
using kind = commander;
#endif

struct hasty_stop : kind {
    static constexpr conversation_properties properties{.urgency = urgency::stop_of_unit,
                                                        .freshness = freshness::when_free};
    std::optional<request_frame> next() const { return std::nullopt; }
    void accept(result<response> const&) {}
    bool settled() const { return true; }
    unit_id unit() const { return unit_id{1}; }
    effect intent() const { return effect::stopping; }
    duration drive_timeout() const { return milliseconds(1'000); }
    std::uint8_t tolerated_misses() const { return 0; }
    void note_loss() {}
};

void pass(drive_client<>& line, hasty_stop& conversation, instant now) { line.converse(conversation, now); }
