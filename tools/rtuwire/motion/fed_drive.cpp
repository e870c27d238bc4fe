// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/fed_drive.hpp"

#include "line/left_alone.hpp"
#include "motion/question.hpp"
#include "words/time_words.hpp"

namespace tool {

fed_unit who_is_fed(open_line& line, named_unit const& unit)
{
    identity_words const who = unit.drive.empty() or unit.drive == no_drive or unit.names != nullptr
                                   ? who_is_it(line, unit.unit)
                                   : identity_words{.drive = unit.drive, .may_be_drive = true};
    if (who.drive.empty() and not who.may_be_drive and not look_for_unnamed_drive(line, unit.unit, who).may_be_one) {
        return {};
    }
    return {true, who.drive.empty() ? nullptr : &catalog_chosen(who.drive)};
}

std::optional<fed_pause> pause_of(open_line& line, rtuwire::unit_id unit, fed_unit const& who)
{
    if (not who.may_be_drive) {
        return std::nullopt;
    }
    auto const found = who.drive == nullptr ? line_supervision{} : supervision_of(line, unit, who.drive->layout);
    if (found.is_off) {
        return std::nullopt;
    }
    constexpr std::chrono::milliseconds tenth{100}, usual{7'000};
    auto const time_out = found.tenths ? tenth * *found.tenths : usual;
    auto const longest = time_out / (found.tenths ? 2 : 3);
    std::string const what = found.tenths ? "its time-out of " : "its time-out, which it does not tell and may be ";
    return fed_pause{longest,
                     what + seconds_text(time_out) + (found.tenths ? " allows " : ", allows ") + seconds_text(longest)};
}

void ask_before_it_is_fed(fed_unit const& who, named_unit const& unit, permissions const& allowed,
                          std::string const& act, char const* question)
{
    if (not who.may_be_drive) {
        return;
    }
    std::string const what =
        "unit " + std::to_string(unit.unit.byte()) +
        (who.drive == nullptr ? " may be a drive" : " is an " + std::string{who.drive->name}) + ": " + act +
        " begins its supervision of the line, so that it shows the fault SLF at its next start "
        "once nobody asks it, and holds that off meanwhile: a motor whose controller has gone runs on";
    if (is_asked(allowed)) {
        if (not may_go_on(allowed, what, question)) {
            throw ended{exit_status::refused, "nothing was asked"};
        }
    } else if (not allowed.is_confirmed) {
        refuse_for_safety(what + "; to " + std::string{question, std::char_traits<char>::length(question) - 1} +
                          ", say --yes");
    }
}

} // namespace tool
