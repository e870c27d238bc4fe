// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What makes a class a conversation of each kind: each part of it is needed.
#include <rtuwire/ask/commander.hpp>

#include <array>
#include <optional>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

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

template <typename Base> struct with_unit : Base {
    static unit_id unit() { return unit_id{1}; }
};
template <typename Base> struct made_when_free : Base {
    static constexpr conversation_properties properties{.freshness = freshness::when_free};
};
template <typename Base> using prompt_on = made_when_free<with_unit<Base>>;
STATIC_CHECK(prompt_conversation<prompt_on<count16>>);
STATIC_CHECK(not prompt_conversation<count16>);
STATIC_CHECK(not prompt_conversation<with_unit<count16>>);
STATIC_CHECK(not prompt_conversation<made_when_free<count16>>);
STATIC_CHECK(not prompt_conversation<prompt_on<no_asker>> and not prompt_conversation<prompt_on<silent_asker>>);

template <typename Base> struct with_losses : Base {
    static void note_loss() {}
    static effect intent() { return effect::none; }
    static duration drive_timeout() { return {}; }
    static std::uint8_t tolerated_misses() { return 0; }
};
template <typename Base> struct stops_first : Base {
    static constexpr conversation_properties properties{.urgency = urgency::stop_of_unit,
                                                        .freshness = freshness::when_free};
};
template <typename Base> using commanding_on = stops_first<with_losses<Base>>;
using command_conversation = conversation_on<commander>;
STATIC_CHECK(commanding_conversation<commanding_on<prompt_on<command_conversation>>>);
STATIC_CHECK(not commanding_conversation<with_losses<prompt_on<command_conversation>>>);
STATIC_CHECK(not commanding_conversation<stops_first<with_unit<command_conversation>>>);
STATIC_CHECK(not commanding_conversation<prompt_on<command_conversation>>);
STATIC_CHECK(not commanding_conversation<prompt_on<count16>>);
STATIC_CHECK(not commanding_conversation<commanding_on<prompt_on<count16>>>);
STATIC_CHECK(not commanding_conversation<commanding_on<command_conversation>>);

template <typename Base> struct with_stops : Base {
    static std::array<int, 0> stops() { return {}; }
    static effect intent() { return effect::none; }
    static bool is_urgent() { return false; }
    static void note_unlisted(std::uint16_t) {}
    static std::uint8_t unit_told() { return 0; }
    static bool may_cut(std::uint8_t) { return false; }
};
template <typename Base> struct everyone_on : with_stops<Base> {
    static constexpr conversation_properties properties{.urgency = urgency::stop_of_all};
};
STATIC_CHECK(stops_by_broadcast<everyone_on<command_conversation>>);
STATIC_CHECK(not stops_by_broadcast<with_stops<command_conversation>>);
STATIC_CHECK(not stops_by_broadcast<commanding_on<with_stops<with_unit<command_conversation>>>>);
STATIC_CHECK(not commanding_conversation<everyone_on<with_losses<with_unit<command_conversation>>>>);
STATIC_CHECK(not stops_by_broadcast<command_conversation>);
STATIC_CHECK(not stops_by_broadcast<count16>);
STATIC_CHECK(not stops_by_broadcast<everyone_on<count16>>);
STATIC_CHECK(not stops_by_broadcast<everyone_on<commander>>);

// What a conversation declares; a declaration of another type is refused (tests/fail/properties_of_another_type.cpp).
STATIC_CHECK(properties_of<count16>.urgency == urgency::in_turn);
STATIC_CHECK(properties_of<count16>.repetition == repetition::allowed);
STATIC_CHECK(properties_of<count16>.freshness == freshness::any_time);
STATIC_CHECK(properties_of<prompt_on<count16>>.freshness == freshness::when_free);
STATIC_CHECK(has_what_it_declares<with_unit<count16>>());
STATIC_CHECK(has_what_it_declares<prompt_on<count16>>());
STATIC_CHECK(has_what_it_declares<commanding_on<with_unit<command_conversation>>>());
STATIC_CHECK(has_what_it_declares<everyone_on<command_conversation>>());

} // namespace
