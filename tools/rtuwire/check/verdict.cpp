// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "check/verdict.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <optional>

#include "check/hostile.hpp"
#include "frame/hex_text.hpp"
#include "line/end_wish.hpp"
#include "words/time_words.hpp"

namespace tool {

namespace {

constexpr std::string_view listen_only{"D12"};

judgement fails(std::string why) { return {.how = verdict::fails, .why = std::move(why)}; }

std::vector<sent_piece> as_piece(line_bytes const& frame) { return {sent_piece{.bytes = frame}}; }

/// What clauses say that are more than steps.
class procedures {
public:
    procedures(checked_unit& unit, clause const& which) : unit_{unit}, which_{which} {}

    judgement run()
    {
        struct procedure {
            std::string_view id;
            judgement (procedures::*act)();
        };
        constexpr procedure all[]{{"L40", &procedures::spaced},
                                  {"L41", &procedures::gaps},
                                  {"L44", &procedures::all_answers},
                                  {"X04", &procedures::exception_form},
                                  {"X05", &procedures::exception_code},
                                  {"X07", &procedures::refused_functions},
                                  {"I01", &procedures::basic_objects},
                                  {"I02", &procedures::object_lengths},
                                  {"I03", &procedures::paging},
                                  {"I04", &procedures::last_page},
                                  {"I11", &procedures::level},
                                  {"I12", &procedures::objects_of_level},
                                  {"I14", &procedures::characters},
                                  {"D06", &procedures::bus_messages},
                                  {"D07", &procedures::bus_errors},
                                  {"D08", &procedures::exceptions},
                                  {"D09", &procedures::own_messages},
                                  {"D10", &procedures::unanswered},
                                  {"P01", &procedures::claimed_functions},
                                  {"T01", &procedures::response_times},
                                  {"T02", &procedures::turn_around},
                                  {"T03", &procedures::thousand},
                                  {"T04", &procedures::late_answers}};
        procedure const* const found = std::ranges::find(all, which_.id, &procedure::id);
        return found == std::end(all) ? judgement{verdict::not_tried, "this program has no procedure for it yet", {}}
                                      : (this->*found->act)();
    }

private:
    line_bytes say(std::string_view words) { return unit_.ask(words, which_.id).bytes; }

    bool is_read_answered() { return is_allowed("OK1", say("READ"), plain_read(unit_.where()), {}, unit_.where()); }

    judgement spaced()
    {
        bool const has_two = unit_.where().readable >= 2 and unit_.where().read_function == std::byte{3};
        for (unsigned i = 0; i < 20; ++i) {
            bool const asks_two = has_two and i % 2 == 1;
            line_bytes const asked = bytes_of(pieces_of(asks_two ? "U 03 R 00 02 CRC" : "READ", unit_.where()));
            line_bytes const came = unit_.ask(as_piece(asked), which_.id).bytes;
            if (not is_allowed(asks_two ? "OK2" : "OK1", came, asked, {}, unit_.where())) {
                return fails("request " + std::to_string(i + 1) + " of 20: " + shown(came) + " came to " +
                             shown(asked));
            }
        }
        return {};
    }

    judgement gaps()
    {
        line_bytes const asked = bytes_of(pieces_of("U 03 R 00 B(RN) CRC", unit_.where()));
        line_time largest{0};
        for (unsigned i = 0; i < 10; ++i) {
            largest = std::max(largest, unit_.ask(as_piece(asked), which_.id).largest_gap);
        }
        line_time const most = rtuwire::to_chrono(unit_.line().wire().t1_5());
        return largest <= most
                   ? judgement{}
                   : fails("a silence of " + ms_text(largest) + " inside of an answer; t1.5 is " + ms_text(most));
    }

    /// Each answer, by itself: unit, function, size, CRC. Exceptions are of another clause.
    judgement all_answers()
    {
        for (auto const& [asked, answer, id] : unit_.exchanges()) {
            line_bytes const& came = answer.bytes;
            bool const is_refusal =
                came.size() > 1 and (came[1] >= std::byte{0x80} or (came.size() == 5 and came[1] == asked[1]));
            // The lengths of identifications are of another clause, too.
            bool const is_identification = asked[1] == std::byte{0x2B};
            if (came.empty() or is_identification or (is_refusal and has_right_crc(came))) {
                continue;
            }
            std::size_t const size = stated_size(came, asked).value_or(came.size());
            if (came[0] != asked[0] or came.size() < 2 or came[1] != asked[1] or came.size() != size or
                not has_right_crc(came)) {
                return fails("clause " + std::string{id} + ": " + shown(came) + " came to " + shown(asked));
            }
        }
        return {};
    }

    template <typename Fits> judgement each_exception(Fits fits)
    {
        for (auto const& [asked, answer, id] : unit_.exchanges()) {
            line_bytes const& came = answer.bytes;
            if (is_refusal(came, asked) and not fits(came, came[1] >= std::byte{0x80})) {
                return fails("clause " + std::string{id} + ": " + shown(came) + " came to " + shown(asked));
            }
        }
        return {};
    }

    judgement exception_form()
    {
        return each_exception([](line_bytes const& came, bool has_high_bit) {
            return has_high_bit and came.size() == 5 and has_right_crc(came);
        });
    }

    judgement exception_code()
    {
        return each_exception([](line_bytes const& came, bool) {
            constexpr unsigned listed[]{1, 2, 3, 4, 5, 6, 8, 0x0A, 0x0B};
            return came.size() < 5 or std::ranges::count(listed, std::to_integer<unsigned>(came[2])) > 0;
        });
    }

    judgement refused_functions()
    {
        std::map<std::byte, bool> has; // functions with a normal answer
        for (auto const& [asked, answer, id] : unit_.exchanges()) {
            has[asked[1]] = has[asked[1]] or (answer.bytes.size() > 1 and answer.bytes[1] == asked[1]);
        }
        for (auto const& [asked, answer, id] : unit_.exchanges()) {
            line_bytes const& came = answer.bytes;
            bool const may_mean_a_part = asked[1] == std::byte{8} or asked[1] == std::byte{43};
            if (has[asked[1]] and not may_mean_a_part and came.size() == 5 and
                came[1] == (asked[1] | std::byte{0x80}) and came[2] == std::byte{1}) {
                return fails("clause " + std::string{id} + ": " + shown(came) + " came to " + shown(asked) +
                             ", and the unit has that function");
            }
        }
        return {};
    }

    /// All answers to a code of function 43/14, as long as more follows.
    std::vector<line_bytes> pages_of(unsigned code, std::string* why = nullptr)
    {
        std::vector<line_bytes> pages;
        std::byte object{0};
        for (unsigned i = 0; i < 128; ++i) {
            line_bytes const asked = framed({std::byte{unit_.where().unit}, std::byte{0x2B}, std::byte{0x0E},
                                             static_cast<std::byte>(code), object});
            static_cast<void>(unit_.feed_before(unit_.line().time_without_answer({}, unit_.line().longest_wait())));
            line_bytes const came = unit_.ask(as_piece(asked), which_.id).bytes;
            if (not is_allowed("IDENT", came, asked, {}, unit_.where())) {
                if (why != nullptr and (came.size() < 2 or came[1] == std::byte{0x2B})) {
                    *why = shown(came) + " came to " + shown(asked);
                }
                return pages;
            }
            pages.push_back(came);
            if (came[5] != std::byte{0xFF} or code == 4) {
                return pages;
            }
            object = came[6];
        }
        if (why != nullptr) {
            *why = "no end within 128 answers to code " + std::to_string(code);
        }
        return pages;
    }

    template <typename Action> static void each_object(line_bytes const& page, Action&& action)
    {
        std::size_t at = 8;
        for (std::size_t left = std::to_integer<std::size_t>(page[7]); left > 0; --left) {
            std::size_t const size = std::to_integer<std::size_t>(page[at + 1]);
            action(std::to_integer<unsigned>(page[at]), rtuwire::byte_view{page}.subspan(at + 2, size));
            at += 2 + size;
        }
    }

    judgement basic_objects()
    {
        std::map<unsigned, unsigned> count;
        std::string wrong;
        for (line_bytes const& each : pages_of(1, &wrong)) {
            each_object(each, [&](unsigned object, rtuwire::byte_view) { ++count[object]; });
        }
        if (not wrong.empty()) {
            return fails(wrong);
        }
        for (unsigned object = 0; object < 3; ++object) {
            if (count[object] != 1) {
                return fails("object " + std::to_string(object) + " came " + std::to_string(count[object]) + " times");
            }
        }
        return {};
    }

    judgement object_lengths()
    {
        for (unsigned const code : {1U, 2U, 3U}) {
            std::string wrong;
            static_cast<void>(pages_of(code, &wrong));
            if (not wrong.empty() and not wrong.starts_with("no end")) {
                return fails(wrong);
            }
        }
        return {};
    }

    judgement paging()
    {
        for (unsigned const code : {1U, 2U, 3U}) {
            std::string wrong;
            int highest = -1;
            for (line_bytes const& each : pages_of(code, &wrong)) {
                each_object(each, [&](unsigned object, rtuwire::byte_view) {
                    highest = std::max(highest, static_cast<int>(object));
                });
                if (each[5] != std::byte{0} and each[5] != std::byte{0xFF}) {
                    return fails("more follows is neither 00 nor FF: " + shown(each));
                }
                if (each[5] == std::byte{0xFF} and std::to_integer<int>(each[6]) <= highest) {
                    return fails("the next object is not above all that came: " + shown(each));
                }
            }
            if (wrong.starts_with("no end")) {
                return fails(wrong);
            }
        }
        return {};
    }

    judgement last_page()
    {
        for (unsigned const code : {1U, 2U, 3U}) {
            for (line_bytes const& each : pages_of(code)) {
                if (each[5] == std::byte{0} and each[6] != std::byte{0}) {
                    return fails("no more follows, and the next object is not 00: " + shown(each));
                }
            }
        }
        return {};
    }

    judgement level()
    {
        constexpr unsigned levels[]{0x01, 0x02, 0x03, 0x81, 0x82, 0x83};
        for (unsigned const code : {1U, 2U, 3U, 4U}) {
            for (line_bytes const& each : pages_of(code)) {
                if (std::ranges::count(levels, std::to_integer<unsigned>(each[4])) == 0) {
                    return fails("conformity " + hex_of(rtuwire::byte_view{each}.subspan(4, 1)) + ": " + shown(each));
                }
            }
        }
        return {};
    }

    judgement objects_of_level()
    {
        std::optional<std::byte> first;
        for (unsigned const code : {1U, 2U, 3U}) {
            for (line_bytes const& each : pages_of(code)) {
                first = first.value_or(each[4]);
                unsigned const level = std::to_integer<unsigned>(each[4]) & 0x7FU;
                unsigned highest = 0;
                each_object(each, [&](unsigned object, rtuwire::byte_view) { highest = std::max(highest, object); });
                unsigned const of_level = level == 1 ? 0x02U : level == 2 ? 0x7FU : 0xFFU;
                unsigned const of_code = code == 1 ? 0x02U : code == 2 ? 0x7FU : 0xFFU;
                if (highest > std::min(of_level, of_code) or each[4] != *first) {
                    return fails("code " + std::to_string(code) + ": " + shown(each));
                }
            }
        }
        return {};
    }

    judgement characters()
    {
        for (line_bytes const& each : pages_of(2)) {
            bool is_ascii = true;
            each_object(each, [&](unsigned object, rtuwire::byte_view text) {
                is_ascii = is_ascii and (object > 6 or std::ranges::all_of(text, [](std::byte one) {
                                             return one >= std::byte{0x20} and one <= std::byte{0x7E};
                                         }));
            });
            if (not is_ascii) {
                return fails(shown(each));
            }
        }
        return {};
    }

    /// By how much a counter rises while `steps` are said; its second question counts, too.
    judgement count(unsigned subfunction, std::initializer_list<std::string_view> steps, unsigned due)
    {
        line_bytes const asked = framed({std::byte{unit_.where().unit}, std::byte{8}, std::byte{0},
                                         static_cast<std::byte>(subfunction), std::byte{0}, std::byte{0}});
        auto const counter = [&]() -> std::optional<unsigned> {
            line_bytes const came = unit_.ask(as_piece(asked), which_.id).bytes;
            bool const is_one = came.size() == 8 and has_right_crc(came) and came[1] == std::byte{8};
            return is_one ? std::optional{std::to_integer<unsigned>(came[4]) << 8U | std::to_integer<unsigned>(came[5])}
                          : std::nullopt;
        };
        auto const before = counter();
        for (std::string_view const each : steps) {
            static_cast<void>(say(each));
        }
        auto const after = counter();
        if (not before or not after) {
            return fails("the counter could not be read");
        }
        unsigned const rose = (*after - *before) & 0xFFFFU;
        return rose == due
                   ? judgement{}
                   : fails("the counter rose by " + std::to_string(rose) + ", " + std::to_string(due) + " are due");
    }

    judgement bus_messages() { return count(0x0B, {"READ", "READ", "V 03 R 00 01 CRC"}, 4); }
    judgement bus_errors() { return count(0x0C, {"U 03 R 00 01 CRC !6^01", "U 03 R 00 01 CRC !6^01"}, 2); }
    judgement exceptions()
    {
        for (std::string_view const each : {"U 03 R 00 00 CRC", "U 03 FF FF 00 02 CRC"}) {
            line_bytes const came = say(each);
            if (not is_refusal(came, bytes_of(pieces_of(each, unit_.where())))) {
                return {verdict::does_not_apply, "one of its two requests is not refused by an exception", {}};
            }
        }
        return count(0x0D, {"U 03 R 00 00 CRC", "U 03 FF FF 00 02 CRC", "READ"}, 2);
    }
    judgement own_messages() { return count(0x0E, {"READ", "V 03 R 00 01 CRC"}, 2); }
    judgement unanswered() { return count(0x0F, {"READ", "00 03 R 00 01 CRC"}, 1); }

    /// By a request that only reads, or by what was found in the places that may be changed.
    judgement claimed_functions()
    {
        struct reading {
            unsigned function;
            std::string_view words;
        };
        constexpr reading all[]{{0x01, "U 01 00 00 00 01 CRC"},
                                {0x02, "U 02 00 00 00 01 CRC"},
                                {0x03, "U 03 00 00 00 01 CRC"},
                                {0x04, "U 04 00 00 00 01 CRC"},
                                {0x07, "U 07 CRC"},
                                {0x08, "U 08 00 00 A5 5A CRC"},
                                {0x0B, "U 0B CRC"},
                                {0x0C, "U 0C CRC"},
                                {0x11, "U 11 CRC"},
                                {0x14, "U 14 07 06 00 01 00 00 00 01 CRC"},
                                {0x18, "U 18 00 00 CRC"},
                                {0x2B, "U 2B 0E 01 00 CRC"}};
        constexpr unsigned words[]{0x06, 0x10, 0x16, 0x17}, coils[]{0x05, 0x0F};
        std::string unasked;
        for (unsigned const function : unit_.claimed()) {
            reading const* const found = std::ranges::find(all, function, &reading::function);
            bool const is_looked_for = (std::ranges::count(words, function) > 0 and unit_.where().scratch) or
                                       (std::ranges::count(coils, function) > 0 and unit_.where().scratch_coil);
            if (unit_.has_function(function)) {
                continue;
            }
            if (is_looked_for) {
                return fails("function " + std::to_string(function) + " is claimed, and not there");
            }
            if (found == std::end(all)) {
                unasked += (unasked.empty() ? "" : ", ") + std::to_string(function);
                continue;
            }
            line_bytes const came = say(found->words), asked = bytes_of(pieces_of(found->words, unit_.where()));
            if (came.empty() or (is_refusal(came, asked) and came[2] == std::byte{1})) {
                return fails("function " + std::to_string(function) + " is claimed; " + shown(came) + " came to " +
                             shown(asked));
            }
        }
        return {verdict::holds,
                unasked.empty() ? unasked : "not looked for, as a request may change something: " + unasked,
                {}};
    }

    judgement response_times()
    {
        std::vector<line_time> times;
        for (unsigned i = 0; i < 100 and noted_signal() == 0; ++i) {
            line_answer const answer = unit_.ask("READ", which_.id);
            if (not answer.bytes.empty()) {
                times.push_back(answer.took);
            }
        }
        if (times.empty()) {
            return fails("no answer in 100 requests");
        }
        std::ranges::sort(times);
        auto const at = [&](unsigned percent) { return ms_text(times[(times.size() - 1) * percent / 100]); };
        return {verdict::told,
                "smallest " + at(0) + ", median " + at(50) + ", 99 of 100 " + at(99) + ", largest " + at(100),
                {}};
    }

    judgement turn_around()
    {
        line_time const least = rtuwire::to_chrono(unit_.line().wire().t3_5());
        line_time smallest = line_time::max();
        for (unsigned i = 0; i < 20; ++i) {
            line_answer const answer = unit_.ask("READ", which_.id);
            smallest = answer.bytes.empty() ? smallest : std::min(smallest, answer.took);
        }
        if (smallest < line_time{0}) {
            return {verdict::does_not_apply, "answers begin before their requests can have ended: this is no wire", {}};
        }
        return smallest >= least
                   ? judgement{}
                   : fails("an answer began " + ms_text(smallest) + " behind its request; t3.5 is " + ms_text(least));
    }

    judgement thousand()
    {
        for (unsigned i = 0; i < 1'000 and noted_signal() == 0; ++i) {
            if (not is_read_answered()) {
                return fails("request " + std::to_string(i + 1) + " of 1000 was not answered");
            }
        }
        return {};
    }

    judgement late_answers()
    {
        line_bytes const& late = unit_.line().late_answer();
        return late.empty() ? judgement{} : fails(shown(late) + " came behind the time-out of its request (--timeout)");
    }

    checked_unit& unit_;
    clause const& which_;
};

/// What a wrong answer says of the unit where it is no fault: it has a function that nobody should have, or lacks one.
std::string why_none(clause const& which, std::size_t step, line_bytes const& came, line_bytes const& asked)
{
    bool const is_answer = has_right_crc(came) and came.size() > 3 and came[0] == asked[0];
    if (which.needs == "unknown" and is_answer and came[1] == asked[1] and not is_refusal(came, asked)) {
        return "function " + std::to_string(std::to_integer<unsigned>(asked[1])) + " is there";
    }
    bool const lacks_silence = which.id == listen_only and step == 0 and is_answer and is_refusal(came, asked);
    return lacks_silence and came[2] == std::byte{1} ? "the unit does not have that sub-function" : std::string{};
}

/// Step by step, up to the first answer that may not come.
judgement steps_judged(checked_unit& unit, clause const& which)
{
    std::vector<std::string_view> const sends = steps_of(which.sends), comes = steps_of(which.comes);
    line_bytes before;
    std::size_t end_of_run = 0;
    for (std::size_t i = 0; i < sends.size(); ++i) {
        if (i == end_of_run) {
            auto const run = unit.run_of(std::span{sends}.subspan(i));
            if (not unit.feed_before(run)) {
                bool const is_judged = i > 0 and sends.back() == "READ"; // as that one
                return {is_judged ? verdict::fails : verdict::not_tried,
                        "a plain read before step " + std::to_string(i + 1) + " of " + std::to_string(sends.size()) +
                            ", as the unit supervises the line, was not answered",
                        {}};
            }
            end_of_run += run.size();
        }
        std::vector<sent_piece> const pieces = pieces_of(sends[i], unit.where());
        line_bytes const asked = bytes_of(pieces);
        line_bytes const came = unit.ask(pieces, which.id).bytes;
        if (not is_allowed(comes[i], came, asked, before, unit.where())) {
            if (not unit.line().has_kept_silences()) {
                return {verdict::not_tried, "this machine did not keep the silences inside of the frame", {}};
            }
            if (std::string why = why_none(which, i, came, asked); not why.empty()) {
                return {verdict::does_not_apply, std::move(why), {}};
            }
            std::string const step =
                sends.size() == 1 ? std::string{}
                                  : "step " + std::to_string(i + 1) + " of " + std::to_string(sends.size()) + ": ";
            return fails(step + shown(came) + " came to " + shown(asked) + "; " +
                         (comes[i] == "-" ? "nothing" : std::string{comes[i]}) + " may come");
        }
        before = came;
    }
    return {};
}

judgement judged_once(checked_unit& unit, clause const& which)
{
    try {
        bool const is_hostile = which.id.starts_with('H') and which.sends.starts_with('@');
        check_choices const& how = unit.how();
        return is_hostile                     ? hostile_judged(unit, which, std::chrono::seconds{how.hostile}, how.seed)
               : which.sends.starts_with('@') ? procedures{unit, which}.run()
                                              : steps_judged(unit, which);
    } catch (unknown_place const& missing) {
        return {verdict::does_not_apply, "no place " + std::string{missing.what()} + " was found on this unit", {}};
    }
}

} // namespace

std::string_view name_of(verdict how)
{
    switch (how) {
    case verdict::holds: return "holds";
    case verdict::fails: return "fails";
    case verdict::known: return "known deviation";
    case verdict::does_not_apply: return "does not apply";
    case verdict::not_tried: return "not tried";
    case verdict::told: break;
    }
    return "told";
}

judgement judged(checked_unit& unit, clause const& which)
{
    static_cast<void>(unit.line().take_passed());
    // Where time is part of a clause, what fails once of three times is told, and holds.
    bool const is_timed =
        which.sends.find('~') != which.sends.npos or which.id == "L40" or which.id == "L41" or which.id == "T02";
    judgement found = judged_once(unit, which);
    std::string first = found.why;
    for (unsigned turn = 1; is_timed and turn < 3 and
                            (found.how == verdict::fails or found.how == verdict::not_tried) and noted_signal() == 0;
         ++turn) {
        if (not unit.establish(which.state)) {
            break;
        }
        found = judged_once(unit, which);
    }
    if (is_timed and found.how == verdict::holds and not first.empty()) {
        found.why = "not at once: " + first;
    }
    if (which.id == listen_only and found.how != verdict::holds) {
        static_cast<void>(unit.line().ask(pieces_of("U 08 00 01 00 00 CRC", unit.where()))); // it is not left silenced
    }
    if (found.how == verdict::fails) {
        unit.forget(which.id);
    }
    std::vector<passed_bytes> last = unit.line().take_passed();
    if (found.passed.empty()) {
        found.passed = std::move(last); // what broke it was said long before, where that was looked for
    }
    return found;
}

} // namespace tool
