// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Each action is told apart into what it was made of.
#include <rtuwire/altivar/procedure/procedure.hpp>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

struct parts {
    action_kind kind;
    std::uint16_t address{0};
    std::uint16_t word{0};
    effect does{effect::none};
    repetition again{repetition::allowed};
    std::uint8_t count{1};
    duration length{};
};

constexpr bool has(action of, parts const& wanted)
{
    bool const has_word = wanted.kind == action_kind::write;
    return what_of(of) == wanted.kind and address_of(of) == wanted.address and effect_of(of) == wanted.does and
           repetition_of(of) == wanted.again and count_of(of) == wanted.count and length_of(of) == wanted.length and
           (not has_word or word_of(of) == wanted.word);
}

constexpr auto wr = action_kind::write;
constexpr auto rd = action_kind::read;
constexpr duration longest{0xFFFF'FFFFU};

STATIC_CHECK(has(to_read(0xFFFF), {rd, 0xFFFF}));
STATIC_CHECK(has(to_read_two(8'501), {.kind = rd, .address = 8'501, .count = 2}));
STATIC_CHECK(has(within(to_read(1), longest), {.kind = rd, .address = 1, .length = longest}));
STATIC_CHECK(has(once(to_read(1)), {.kind = rd, .address = 1, .again = repetition::never}));
STATIC_CHECK(has(to_write(0xFFFF, 0), {wr, 0xFFFF, 0}));
STATIC_CHECK(has(to_write(0, 0xFFFF), {wr, 0, 0xFFFF}));
STATIC_CHECK(has(to_enable(400, 15), {wr, 400, 15, effect::enabling}));
STATIC_CHECK(has(to_reset(400, 128), {wr, 400, 128, effect::resetting}));
STATIC_CHECK(has(to_rearrange(400, 1), {wr, 400, 1, effect::rearranging}));
STATIC_CHECK(has(to_stop(0xFFFF, 0xFFFF), {wr, 0xFFFF, 0xFFFF, effect::stopping}));
STATIC_CHECK(has(once(to_stop(400, 0)), {wr, 400, 0, effect::stopping, repetition::never}));
STATIC_CHECK(has(in_presence(to_enable(400, 15)),
                 {.kind = wr, .address = 400, .word = 15, .does = effect::enabling, .length = milliseconds(500)}));
STATIC_CHECK(has(to_pause(longest), {.kind = action_kind::pause, .length = longest}));
STATIC_CHECK(has(to_pause(duration{}), {.kind = action_kind::pause}));
STATIC_CHECK(has(to_end, {.kind = action_kind::end}));

} // namespace
