// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The table of a procedure as data: a row for each stage with the events that lead there, a column for each answer,
// and in each cell what the procedure does next.
#pragma once

#include <array>
#include <cstddef>

#include "support/catch.hpp"

#include <rtuwire/altivar/procedure/procedure.hpp>

namespace rtuwire::test {

/// An answer, by the name that the table's head has for it.
struct answer {
    char const* name;
    altivar::event what;
};

/// Of two words each: where the status is the second one, it is this, too.
[[nodiscard]] constexpr altivar::event word(std::uint16_t read)
{
    return {altivar::event::kind::word_read, read, errc::none, read};
}
[[nodiscard]] constexpr altivar::event words(std::uint16_t first, std::uint16_t second)
{
    return {altivar::event::kind::word_read, first, errc::none, second};
}
[[nodiscard]] constexpr altivar::event failed(errc error) { return {altivar::event::kind::failed, 0, error}; }
inline constexpr altivar::event begun{altivar::event::kind::begun};
inline constexpr altivar::event confirmed{altivar::event::kind::written};
inline constexpr altivar::event pause_over{altivar::event::kind::pause_over};
inline constexpr altivar::event late{altivar::event::kind::late};

/// What a procedure does next, and how it has ended or will end.
struct cell {
    altivar::action_kind what{altivar::action_kind::end};
    std::uint16_t address{0};
    std::uint16_t word{0};
    altivar::outcome_kind ending{altivar::outcome_kind::pending};
    bool is_possible{true};
};

/// This answer cannot come in this stage.
inline constexpr cell never{.is_possible = false};
inline constexpr cell pauses{.what = altivar::action_kind::pause};
[[nodiscard]] constexpr cell reads(std::uint16_t address)
{
    return {.what = altivar::action_kind::read, .address = address};
}
[[nodiscard]] constexpr cell writes(std::uint16_t address, std::uint16_t word)
{
    return {.what = altivar::action_kind::write, .address = address, .word = word};
}
[[nodiscard]] constexpr cell ends(altivar::outcome_kind how) { return {.ending = how}; }

/// The same, and the procedure then comes to rest and ends so.
[[nodiscard]] constexpr cell then(cell first, altivar::outcome_kind how)
{
    first.ending = how;
    return first;
}

/// The events that lead to a stage.
struct way {
    template <typename... Events> constexpr way(Events... in_order) : events{in_order...}, size{sizeof...(Events)} {}

    std::array<altivar::event, 16> events{};
    std::size_t size;
};

/// A stage and its cells, one for each answer.
template <std::size_t Answers> struct stage_row {
    char const* name;
    way there;
    std::array<cell, Answers> cells;
};

/// The procedure after its way to a stage.
template <typename Script> [[nodiscard]] constexpr Script led(Script it, way const& there)
{
    for (std::size_t i = 0; i < there.size; ++i) {
        static_cast<void>(it.step(there.events[i]));
    }
    return it;
}

/// Whether the procedure does what the cell holds. Where it ends later, it is first brought to rest: its writes are
/// confirmed, and its reads find the drive in "switch on disabled".
template <typename Script> [[nodiscard]] constexpr bool does(Script it, altivar::event what, cell const& expected)
{
    altivar::action next = it.step(what);
    bool const is_right = what_of(next) == expected.what and
                          (what_of(next) == altivar::action_kind::end or what_of(next) == altivar::action_kind::pause or
                           (address_of(next) == expected.address and
                            (what_of(next) == altivar::action_kind::read or word_of(next) == expected.word)));
    constexpr std::uint16_t disabled = 0x0250;
    bool const goes_on = expected.what != altivar::action_kind::end;
    for (unsigned i = 0; i < 10 and goes_on and expected.ending != altivar::outcome_kind::pending; ++i) {
        next = it.step(what_of(next) == altivar::action_kind::read    ? word(disabled)
                       : what_of(next) == altivar::action_kind::write ? confirmed
                                                                      : pause_over);
        if (what_of(next) == altivar::action_kind::end) {
            break;
        }
    }
    return is_right and it.reason().kind == expected.ending;
}

/// Checks each cell of a table, and names the one that is wrong.
template <typename Script, std::size_t Answers, std::size_t Rows>
void check_table(Script const& begun_nowhere, std::array<answer, Answers> const& answers,
                 std::array<stage_row<Answers>, Rows> const& rows)
{
    for (stage_row<Answers> const& row : rows) {
        for (std::size_t i = 0; i < Answers; ++i) {
            if (row.cells[i].is_possible) {
                INFO(row.name << ", " << answers[i].name);
                CHECK(does(led(begun_nowhere, row.there), answers[i].what, row.cells[i]));
            }
        }
    }
}

} // namespace rtuwire::test
