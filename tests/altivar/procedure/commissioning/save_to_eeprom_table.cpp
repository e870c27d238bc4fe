// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The table of a save of the settings: each stage and each answer, as it stands beside the code.
#include <rtuwire/altivar/procedure/commissioning/save_to_eeprom.hpp>

#include "altivar/procedure/status_words.hpp"
#include "altivar/procedure/step_table.hpp"
#include "support/catch.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using kind = outcome_kind;

namespace {

constexpr auto const& layout = atv12::device::layout;
constexpr auto const& old = atv28::device::layout; // does not show that it is saving
constexpr std::uint16_t cmi = 8504, old_cmi = 402;

constexpr cell eta = reads(3201), control = reads(cmi), eti = reads(3206);
constexpr cell x = never;
constexpr cell done = ends(kind::succeeded), silent = ends(kind::silent), refused = ends(kind::refused);
constexpr cell aborted = ends(kind::aborted), running = ends(kind::refused_while_running);

/// CMI had this word beside its orders.
constexpr std::uint16_t kept = 0x8200;
constexpr cell clear = writes(cmi, kept), clear_old = writes(old_cmi, kept);
/// The order is cleared, and the save then ends so.
constexpr cell undo(kind how) { return then(clear, how); }
constexpr cell undo_old(kind how) { return then(clear_old, how); }

constexpr std::array<stage_row<12>, 1> look_rows{{
    {"a look",
     {begun},
     {control, control, control, control, running, running, running, control, control, silent, refused, aborted}},
}};

constexpr std::array<answer, 10> others{{
    {"0", word(0)},
    {"1", word(1)},
    {"3", word(3)},
    {"8200", word(kept)},
    {"8203", word(kept | 3)},
    {"confirmed", confirmed},
    {"pause over", pause_over},
    {"no response", failed(errc::timed_out)},
    {"refused", failed(errc::server_device_failure)},
    {"limit over", late},
}};

constexpr event disabled = word(disabled_word), control_read = word(kept | 3);
constexpr way to_wait{begun, disabled, control_read, confirmed};

// clang-format off
constexpr std::array<stage_row<10>, 8> rows{{
    // stage, and the way there
    //   0, 1, 3, 8200, 8203
    //   confirmed, pause over, no response, refused, limit over
    {"reading the control word", {begun, disabled},
     {writes(cmi, 2), writes(cmi, 2), writes(cmi, 2), writes(cmi, kept | 2), writes(cmi, kept | 2),
      x, x, silent, refused, aborted}},
    {"saving", {begun, disabled, control_read},
     {x, x, x, x, x,
      pauses, x, undo(kind::silent), undo(kind::refused), undo(kind::aborted)}},
    {"a wait while it saves", to_wait,
     {x, x, x, x, x,
      x, eti, undo(kind::silent), x, undo(kind::state_timeout)}},
    {"looking whether it still saves", {begun, disabled, control_read, confirmed, pause_over},
     {clear, pauses, pauses, clear, pauses,
      x, x, undo(kind::silent), undo(kind::refused), undo(kind::state_timeout)}},
    {"a wait because it still saves", {begun, disabled, control_read, confirmed, pause_over, word(1)},
     {x, x, x, x, x,
      x, eti, undo(kind::silent), x, undo(kind::state_timeout)}},
    {"taking back", {begun, disabled, control_read, confirmed, pause_over, word(0)},
     {x, x, x, x, x,
      done, x, silent, refused, then(clear, kind::succeeded)}},
    {"taking back after no response", {begun, disabled, control_read, failed(errc::timed_out)},
     {x, x, x, x, x,
      silent, x, silent, silent, undo(kind::silent)}},
    {"taking back after a refusal", {begun, disabled, control_read, failed(errc::server_device_failure)},
     {x, x, x, x, x,
      refused, x, refused, refused, undo(kind::refused)}},
}};
constexpr std::array<stage_row<10>, 2> old_rows{{
    {"a wait while it saves", to_wait,
     {x, x, x, x, x,
      x, clear_old, undo_old(kind::silent), x, undo_old(kind::state_timeout)}},
    {"taking back", {begun, disabled, control_read, confirmed, pause_over},
     {x, x, x, x, x,
      done, x, silent, refused, then(clear_old, kind::succeeded)}},
}};
// clang-format on

constexpr save_procedure save{layout}, old_save{old};

} // namespace

TEST_CASE("a save of the settings does at its look what its table says")
{
    check_table(save, looks, look_rows);
    CHECK(does(save, begun, eta));
}

TEST_CASE("a save of the settings does in each stage, at each answer, what its table says")
{
    check_table(save, others, rows);
    check_table(old_save, others, old_rows);
}

TEST_CASE("a save of the settings repeats no order of CMI, not even a recall")
{
    CHECK(does(led(old_save, {begun, disabled}), word(kept | 7), writes(old_cmi, kept | 2)));
}
