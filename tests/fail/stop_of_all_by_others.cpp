// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A stop of all units that gives something else than the commanders of its units.
// EXPECT: each stop of a conversation that stops all units commands one of them
#include <rtuwire/client/client.hpp>

#include <array>
#include <optional>

using namespace rtuwire;
using namespace rtuwire::detail;

struct hand_stop : commander {
#ifndef REFUSED
    static constexpr conversation_properties properties{.urgency = urgency::stop_of_unit,
                                                        .freshness = freshness::when_free};
#endif
    std::optional<request_frame> next() const { return std::nullopt; }
    void accept(result<response> const&) {}
    bool settled() const { return true; }
    using commander::commander;
    using commander::unit;
    effect intent() const { return effect::stopping; }
    duration drive_timeout() const { return milliseconds(1'000); }
    std::uint8_t tolerated_misses() const { return 0; }
    void note_loss() {}
};

struct stop_of_others : commander {
    static constexpr conversation_properties properties{.urgency = urgency::stop_of_all};
    std::optional<request_frame> next() const { return std::nullopt; }
    void accept(result<response> const&) {}
    bool settled() const { return true; }
    std::array<hand_stop, 1>& stops() { return one; }
    effect intent() const { return effect::stopping; }
    bool is_urgent() const { return true; }
    void note_unlisted(std::uint16_t) {}
    std::uint8_t unit_told() const { return 0; }
    bool may_cut(std::uint8_t) const { return false; }
    std::array<hand_stop, 1> one{hand_stop{unit_id{1}}};
};

void pass(drive_client<>& line, stop_of_others& conversation, instant now) { line.converse(conversation, now); }
