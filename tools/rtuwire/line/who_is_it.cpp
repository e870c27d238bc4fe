// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/who_is_it.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "catalog/drive_family.hpp"
#include "output/plain_text.hpp"
#include "words/suggestion.hpp"

namespace tool {

namespace {

using candidates = std::vector<drive_catalog const*>;
using rtuwire::errc;

/// Whether it says of itself that it is one.
bool calls_itself_drive(identity_words const& who)
{
    return names_a_drive(who.product) or names_a_drive(who.vendor) or names_a_drive(who.revision);
}

std::string text_of_bytes(rtuwire::byte_view bytes)
{
    std::string text;
    for (std::byte const each : bytes) {
        text += static_cast<char>(std::to_integer<unsigned char>(each));
    }
    return text.erase(std::min(text.find_last_not_of(std::string{" \0", 2}) + 1, text.size()));
}

std::string* place_of(identity_words& who, std::uint8_t object)
{
    switch (object) {
    case rtuwire::vendor_name: return &who.vendor;
    case rtuwire::product_code: return &who.product;
    case rtuwire::major_minor_revision: return &who.revision;
    default: return nullptr;
    }
}

errc read_one(open_line& line, unit_address unit, std::uint16_t address)
{
    return line.ask(unit, rtuwire::read_holding_registers{.start = address, .count = 1}).error();
}

/// A read that leaves open which drive a unit is.
struct open_read {
    exit_status outcome;
    std::string why; ///< "127.0.0.1:502: the connection is gone", "reading register 3201 ends with no response in time"
};

open_read open_read_of(open_line const& line, std::uint16_t address, errc outcome)
{
    exit_status const status = status_of(outcome);
    std::string const why = line.words_of_failure(outcome);
    return {status,
            (status == exit_status::port ? "" : "reading register " + std::to_string(address) + " ends with ") + why};
}

void leave_open(open_read const& at, std::string const& so_far, identity_words& who)
{
    who.outcome = at.outcome;
    who.has_answered = at.outcome != exit_status::port;
    who.note = (who.has_answered ? so_far + "which drive it is stays open, because " : std::string{}) + at.why;
}

/// Drops those whose own registers the unit does not have. Returns the read that did not tell, if one did not.
std::optional<open_read> tell_apart(open_line& line, unit_address unit, candidates& left)
{
    for (std::size_t i = 0; left.size() > 1 and i < left.size();) {
        drive_catalog const& other = *left[i == 0 ? 1 : 0];
        auto const address = only_in(*left[i], other);
        if (not address) {
            ++i;
            continue;
        }
        errc const outcome = read_one(line, unit, *address);
        if (outcome == errc::none) {
            std::erase(left, &other);
        } else if (outcome == errc::illegal_data_address) {
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
        } else {
            return open_read_of(line, *address, outcome);
        }
    }
    return std::nullopt;
}

/// Those of the family that the product's code begins with.
candidates of_family(std::string const& product)
{
    candidates found;
    for (drive_catalog const* const each : all_catalogs()) {
        if (not product.empty() and family_of(each->reference) == family_of(product)) {
            found.push_back(each);
        }
    }
    return found;
}

/// Drives that a unit may be by the registers that it has: what one has and another has not is read, once each.
class fingerprint {
public:
    fingerprint(open_line& line, unit_address unit) : line_{line}, unit_{unit} {}

    /// Those whose own registers the unit has, while it refuses what only others have: a device that has any register
    /// is none of them.
    candidates among(candidates const& all)
    {
        candidates found;
        for (drive_catalog const* const each : all) {
            // One register alone may be anybody's: low addresses are those of most modules.
            bool fits = has(each->layout.eta, errc::none) and has(each->layout.lft, errc::none);
            for (drive_catalog const* const other : all) {
                fits = fits and (other == each or (has(only_in(*each, *other), errc::none) and
                                                   has(only_in(*other, *each), errc::illegal_data_address)));
            }
            if (fits) {
                found.push_back(each);
            }
        }
        return found;
    }

    /// Whether anything but silence was heard.
    bool is_there() const { return is_there_; }

    /// The read at which the port failed, else the first that nobody answered.
    std::optional<open_read> const& open() const { return open_; }

    /// Whether the unit has a register: `none` where it has, an exception that says so where it has not, and otherwise what
    /// leaves that open. Nobody asks a silent unit twice.
    errc outcome_at(std::uint16_t address)
    {
        auto const known = outcomes_.find(address);
        if (known != outcomes_.end()) {
            return known->second;
        }
        if (is_silent_) {
            return silence_;
        }
        errc const outcome = read_one(line_, unit_, address);
        is_there_ = is_there_ or outcome == errc::none or is_refusal_of_unit(outcome);
        exit_status const status = status_of(outcome);
        is_silent_ = not is_there_ or status == exit_status::port;
        silence_ = status == exit_status::port ? outcome : silence_;
        if (status == exit_status::port or (status == exit_status::no_answer and not open_)) {
            open_ = open_read_of(line_, address, outcome);
        }
        outcomes_.emplace(address, outcome);
        return outcome;
    }

private:
    /// Whether reading it ends so.
    bool has(std::optional<std::uint16_t> address, errc expected)
    {
        return not address or outcome_at(*address) == expected;
    }

    open_line& line_;
    unit_address unit_;
    std::map<std::uint16_t, errc> outcomes_{};
    bool is_there_{false};
    std::optional<open_read> open_{};
    errc silence_{errc::timed_out}; ///< or how the port has failed
    bool is_silent_{false};
};

/// What tells a drive of whatever name: a status word and a command word.
struct drive_marks {
    std::uint16_t address{0}; ///< of the status word; where that is not known, of what was asked
    std::uint16_t command{0};
    bool has_all{false};
    errc open{errc::none}; ///< why it is not known; none where it is
};

/// Whether an outcome tells if a register is there. A unit that is busy, has failed or is not reached by its gateway may
/// have it all the same.
bool is_telling(errc outcome)
{
    return outcome == errc::none or outcome == errc::illegal_function or outcome == errc::illegal_data_address or
           outcome == errc::illegal_data_value;
}

/// Those of the drives of this program, and those of others that number them as CiA 402 does.
drive_marks marks_of_drive(open_line& line, unit_address unit)
{
    constexpr std::uint16_t status_object = 0x6041, control_object = 0x6040;
    fingerprint known{line, unit};
    std::vector<drive_marks> all{{status_object, control_object}};
    for (drive_catalog const* const each : all_catalogs()) {
        all.insert(all.begin(), {each->layout.eta, each->layout.cmd});
    }
    for (drive_marks each : all) {
        for (std::uint16_t const address : {each.address, each.command}) {
            errc const outcome = known.outcome_at(address);
            if (not is_telling(outcome)) {
                return {.address = address, .open = outcome};
            }
            each.has_all = outcome == errc::none;
            if (not each.has_all) {
                break;
            }
        }
        if (each.has_all) {
            return each;
        }
    }
    return {};
}

candidates all_drives() { return {all_catalogs().begin(), all_catalogs().end()}; }

/// Drives that do not answer function 43: they refuse it, or say nothing to it.
candidates without_identity(candidates all)
{
    std::erase_if(all, [](drive_catalog const* each) {
        return each->functions.contains(rtuwire::function_code::encapsulated_interface);
    });
    return all;
}

/// Of a unit that says nothing of itself. One that refuses to is a drive that cannot; one that is silent may be any,
/// behind something that does not let function 43 pass.
void recognise_by_registers(open_line& line, unit_address unit, errc outcome, identity_words& who)
{
    std::string const why = line.words_of_failure(outcome);
    fingerprint marks{line, unit};
    candidates found = marks.among(all_drives());
    who.may_be_drive = not found.empty();
    if (is_refusal_of_unit(outcome)) {
        found = without_identity(std::move(found));
    }
    if (found.size() == 1) {
        who.drive = std::string{found.front()->name};
    } else if (marks.open() and
               (marks.open()->outcome == exit_status::port or is_refusal_of_unit(outcome) or marks.is_there())) {
        leave_open(*marks.open(), "answers, but does not say who it is (" + why + "), and ", who);
    } else if (is_refusal_of_unit(outcome) or marks.is_there()) {
        who.note = "answers, but does not say who it is (" + why +
                   "), and its registers are those of no drive of this program, or of several";
        who.outcome = exit_status::differs;
        who.has_answered = true;
        // A drive that answers function 43 does not refuse it.
        who.is_another = outcome == errc::illegal_function and found.empty();
    } else {
        who.note = why;
        who.outcome = status_of(outcome);
    }
}

} // namespace

errc read_identity(open_line& line, unit_address unit, identity_words& who)
{
    for (std::uint8_t object = 0;;) {
        auto const page =
            line.ask(unit, rtuwire::read_device_identification{rtuwire::identification_access::basic, object});
        if (not page) {
            return page.error();
        }
        for (auto at = page->first(); at; at = page->after(*at)) {
            if (std::string* const place = place_of(who, at->id)) {
                *place = text_of_bytes(at->value);
            }
        }
        if (not page->more_follows) {
            return errc::none;
        }
        if (page->next_object <= object) {
            return errc::malformed;
        }
        object = page->next_object;
    }
}

identity_words who_is_it(open_line& line, unit_address unit, std::optional<errc> asked)
{
    identity_words who;
    errc const outcome = asked ? *asked : read_identity(line, unit, who);
    if (status_of(outcome) == exit_status::port) {
        who.note = line.words_of_failure(outcome);
        who.outcome = exit_status::port;
    } else if (outcome != errc::none) {
        recognise_by_registers(line, unit, outcome, who);
    } else {
        candidates left = of_family(who.product);
        who.is_another = left.empty();
        if (auto const open = tell_apart(line, unit, left)) {
            leave_open(*open, "", who);
        }
        who.drive = left.size() == 1 ? std::string{left.front()->name} : std::string{};
        who.may_be_drive = not left.empty() or calls_itself_drive(who);
    }
    return who;
}

unnamed_drive look_for_unnamed_drive(open_line& line, unit_address unit, identity_words const& who)
{
    bool const was_heard = who.has_answered or who.outcome == exit_status::done;
    if (not who.product.empty() or not was_heard) {
        return {};
    }
    drive_marks const marks = marks_of_drive(line, unit);
    return {marks.has_all or status_of(marks.open) == exit_status::differs, marks.open};
}

bool is_of_another_family(identity_words const& who, drive_catalog const& drive)
{
    drive_catalog const* const known = who.drive.empty() ? nullptr : catalog_named(who.drive);
    candidates const found = known != nullptr ? candidates{known} : of_family(who.product);
    return found.empty() ? calls_itself_drive(who) : family_of(found.front()->reference) != family_of(drive.reference);
}

std::string why_another_device(unit_address unit, identity_words const& who, std::string const& vendor,
                               std::string const& product)
{
    bool const is_another =
        (not vendor.empty() and who.vendor != vendor) or (not product.empty() and who.product != product);
    return not is_another ? std::string{}
                          : "unit " + std::to_string(unit.byte()) + " calls itself '" + who.vendor + ' ' + who.product +
                                "', and is to be '" + vendor + ' ' + product + "'";
}

void tell_another_device(open_line& line, named_unit const& unit)
{
    identity_words who;
    bool const is_said = unit.names != nullptr and not unit.names->vendor.empty() and
                         read_identity(line, unit.unit, who) == rtuwire::errc::none;
    std::string const why =
        is_said ? why_another_device(unit.unit, who, unit.names->vendor, unit.names->product) : std::string{};
    if (not why.empty()) {
        tell_error(why);
    }
}

drive_catalog const& catalog_chosen(std::string const& name)
{
    if (drive_catalog const* const found = catalog_named(name)) {
        return *found;
    }
    if (name == no_drive) {
        refuse_word("--drive none: this is a command for drives; say which one it is");
    }
    std::vector<std::string_view> known;
    std::string all;
    for (drive_catalog const* const each : all_catalogs()) {
        known.push_back(each->name);
        all += (all.empty() ? "" : ", ") + std::string{each->name};
    }
    refuse_word("there is no drive '" + name + "', only " + all + suggestion(name, known));
}

drive_catalog const* catalog_or_none(std::string const& name)
{
    return name == no_drive ? nullptr : &catalog_chosen(name);
}

namespace {

/// The catalog of a drive that was recognised. Ends where it is none.
drive_catalog const& catalog_of(identity_words const& who, unit_address unit)
{
    if (not who.drive.empty()) {
        return catalog_chosen(who.drive);
    }
    std::string const number = "unit " + std::to_string(unit.byte());
    std::string const say_drive = who.may_be_drive ? "; say --drive" : "; say --drive, which may be none";
    if (not who.note.empty() and (who.product.empty() or who.outcome != exit_status::done)) {
        throw ended{who.outcome, number + ": " + who.note + (who.has_answered ? say_drive : "")};
    }
    throw ended{exit_status::differs,
                number + " is a '" + who.vendor + " " + who.product + "', no drive of this program" + say_drive};
}

std::string text_of(identity_words const& who) { return who.vendor + ' ' + who.product + ' ' + who.revision; }

/// Of one that is of no known drive.
write_rules rules_of_no_drive(open_line& line, named_unit const& unit, identity_words const& who,
                              permissions const& allowed)
{
    std::string const number = "unit " + std::to_string(unit.unit.byte());
    bool const is_said = not who.vendor.empty() or not who.product.empty();
    if (unit.names != nullptr and is_said) {
        if (auto const why = why_another_device(unit.unit, who, unit.names->vendor, unit.names->product);
            not why.empty()) {
            refuse_for_safety(why);
        }
    }
    if (calls_itself_drive(who)) {
        refuse_for_safety(number + " calls itself '" + who.vendor + ' ' + who.product + "', a drive" +
                          (allowed.knows_run ? "; --drive none is for what is none" : ""));
    }
    drive_marks const marks = marks_of_drive(line, unit.unit);
    if (marks.open != errc::none) {
        exit_status const status = status_of(marks.open);
        throw ended{status == exit_status::differs ? exit_status::refused : status,
                    number + ": whether it is a drive is not known, so nothing is written: reading register " +
                        std::to_string(marks.address) + ", where a drive has its status or its command, ends with " +
                        line.words_of_failure(marks.open)};
    }
    if (marks.has_all and not allowed.may_run) {
        refuse_for_safety(
            number + (who.product.empty() ? "" : ", a '" + who.product + "',") +
            " may be a drive: it has the status word and the command word of one, " + std::to_string(marks.address) +
            " and " + std::to_string(marks.command) +
            (allowed.knows_run ? "; --drive none is for what is none; if it is none, say --allow-run besides" : ""));
    }
    return {nullptr, marks.has_all ? std::optional{marks.command} : std::nullopt, not who.product.empty(),
            text_of(who)};
}

} // namespace

drive_catalog const& catalog_of(open_line& line, unit_address unit, std::string const& chosen)
{
    return chosen.empty() ? catalog_of(who_is_it(line, unit), unit) : catalog_chosen(chosen);
}

write_rules rules_to_write(open_line& line, named_unit const& unit, permissions const& allowed)
{
    std::string const number = "unit " + std::to_string(unit.unit.byte());
    if (not unit.drive.empty() and unit.drive != no_drive) {
        drive_catalog const& said = catalog_chosen(unit.drive);
        identity_words says;
        if (read_identity(line, unit.unit, says) == errc::none and is_of_another_family(says, said)) {
            refuse_for_safety(number + " calls itself '" + says.vendor + ' ' + says.product +
                              "', and is said to be an " + std::string{said.name});
        }
        return {.drive = &said, .says = text_of(says)};
    }
    if (unit.drive.empty()) {
        identity_words const who = who_is_it(line, unit.unit);
        return {.drive = &catalog_of(who, unit.unit), .says = text_of(who)};
    }
    identity_words const who = who_is_it(line, unit.unit);
    if (not who.drive.empty()) {
        if (not allowed.may_run) {
            refuse_for_safety(number + " is an " + who.drive + ", and is said to be no drive" +
                              (allowed.knows_run ? ": leave --drive none out, or say --allow-run besides" : ""));
        }
        return {.drive = catalog_named(who.drive), .says = text_of(who)};
    }
    return rules_of_no_drive(line, unit, who, allowed);
}

std::string why_exchanged(open_line& line, unit_address unit, write_rules const& rules)
{
    if (rules.says == text_of(identity_words{})) {
        return {};
    }
    identity_words now;
    errc const why = read_identity(line, unit, now);
    if (why == errc::none and text_of(now) == rules.says) {
        return {};
    }
    return "unit " + std::to_string(unit.byte()) + " has said that it is '" + rules.says + "', and now " +
           (why == errc::none ? "that it is '" + text_of(now) + '\'' : line.words_of_failure(why));
}

write_rules rules_of_whoever(open_line& line, named_unit const& unit, permissions const& allowed,
                             std::optional<errc> asked)
{
    std::string const number = "unit " + std::to_string(unit.unit.byte());
    bool const is_said = not unit.drive.empty() and unit.drive != no_drive;
    drive_catalog const* const said = is_said ? &catalog_chosen(unit.drive) : nullptr;
    identity_words const who = who_is_it(line, unit.unit, asked);
    if (who.outcome != exit_status::done and who.outcome != exit_status::differs and not who.has_answered) {
        throw ended{who.outcome, number + ": " + who.note};
    }
    bool const is_drive = not who.drive.empty() or who.may_be_drive;
    if (said != nullptr and (not is_drive or is_of_another_family(who, *said))) {
        refuse_for_safety(number + " is said to be an " + std::string{said->name} + ", and " +
                          (is_drive ? "is not" : "nothing of it tells that it is"));
    }
    if (not who.drive.empty()) {
        return {.drive = catalog_named(who.drive), .says = text_of(who)};
    }
    // Which of its family it is, somebody may know better.
    return said != nullptr ? write_rules{.drive = said, .says = text_of(who)}
                           : rules_of_no_drive(line, unit, who, allowed);
}

} // namespace tool
