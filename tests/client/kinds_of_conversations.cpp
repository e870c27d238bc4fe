// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What makes a class a conversation of each kind: each part of it is needed.
#include <rtuwire/ask/commander.hpp>

#include <array>
#include <optional>

#include "support/proof.hpp"

using namespace rtuwire;

namespace {

template <typename Base> struct conversation_on : Base {
    static std::optional<request_frame> next() { return std::nullopt; }
    static void accept(result<response>) {}
    bool settled() const { return true; }
};

struct count16 : conversation_on<asker> {};
struct no_asker {
    static std::optional<request_frame> next() { return std::nullopt; }
    static void accept(result<response>) {}
    static bool settled() { return true; }
};
struct silent_asker : asker {};
STATIC_CHECK(conversation<count16>);
STATIC_CHECK(not conversation<no_asker>);
STATIC_CHECK(not conversation<silent_asker>);

template <bool Value> struct always : conversation_on<asker> {
    static constexpr bool settled() { return Value; }
};
struct endless_no_asker {
    static constexpr bool settled() { return false; }
};
STATIC_CHECK(endless_conversation<always<false>>);
STATIC_CHECK(not endless_conversation<always<true>>);
STATIC_CHECK(not endless_conversation<count16>);
STATIC_CHECK(not endless_conversation<endless_no_asker>);

template <typename Base> struct timed_on : Base {
    static void advance(instant) {}
    static deadline poll_deadline() { return {}; }
};
STATIC_CHECK(timed_conversation<timed_on<count16>>);
STATIC_CHECK(not timed_conversation<count16>);
STATIC_CHECK(not timed_conversation<timed_on<no_asker>> and not timed_conversation<timed_on<silent_asker>>);

template <typename Base> struct prompt_on : Base {
    static unit_id unit() { return unit_id{1}; }
};
STATIC_CHECK(prompt_conversation<prompt_on<count16>>);
STATIC_CHECK(not prompt_conversation<count16>);
STATIC_CHECK(not prompt_conversation<prompt_on<no_asker>> and not prompt_conversation<prompt_on<silent_asker>>);

template <typename Base> struct commanding_on : Base {
    static void note_loss() {}
    static effect intent() { return effect::none; }
    static duration drive_timeout() { return {}; }
    static std::uint8_t tolerated_misses() { return 0; }
};
using command_conversation = conversation_on<commander>;
STATIC_CHECK(commanding_conversation<commanding_on<prompt_on<command_conversation>>>);
STATIC_CHECK(not commanding_conversation<prompt_on<command_conversation>>);
STATIC_CHECK(not commanding_conversation<prompt_on<count16>>);
STATIC_CHECK(not commanding_conversation<commanding_on<prompt_on<count16>>>);
STATIC_CHECK(not commanding_conversation<commanding_on<command_conversation>>);

template <typename Base> struct everyone_on : Base {
    static std::array<int, 0> stops() { return {}; }
    static effect intent() { return effect::none; }
    static bool is_urgent() { return false; }
    static bool may_cut(std::uint8_t) { return false; }
};
STATIC_CHECK(stops_by_broadcast<everyone_on<command_conversation>>);
STATIC_CHECK(not stops_by_broadcast<command_conversation>);
STATIC_CHECK(not stops_by_broadcast<count16>);
STATIC_CHECK(not stops_by_broadcast<everyone_on<count16>>);
STATIC_CHECK(not stops_by_broadcast<everyone_on<commander>>);

} // namespace
