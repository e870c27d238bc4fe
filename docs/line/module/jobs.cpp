// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "jobs.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include <rtuwire/altivar/all.hpp>
#include <rtuwire/maintenance.hpp>

#include "backup/saved_settings.hpp"
#include "catalog/drive_family.hpp"
#include "catalog/value_text.hpp"

namespace line_page {

namespace {

using rtuwire::errc;
using candidates = std::vector<tool::drive_catalog const*>;

constexpr std::uint8_t read_holding = 3;

bool is_refusal_of_unit(errc why)
{
    return rtuwire::is_exception(why) and why != errc::gateway_path_unavailable and
           why != errc::gateway_target_failed_to_respond;
}

std::string text_of(rtuwire::byte_view bytes)
{
    std::string text;
    for (std::byte const each : bytes) {
        auto const letter = std::to_integer<unsigned char>(each);
        text += letter >= ' ' and letter < 0x7F ? static_cast<char>(letter) : ' ';
    }
    return text.erase(text.find_last_not_of(' ') + 1);
}

/// What a unit has told of its registers, each asked once.
class register_marks {
public:
    register_marks(asked_line& line, std::uint8_t unit) : line_{line}, unit_{unit} {}

    /// What reading a register ends with.
    steps look(std::uint16_t address, errc& outcome)
    {
        auto const known = std::ranges::find(outcomes_, address, [](auto const& each) { return each.first; });
        if (known != outcomes_.end()) {
            outcome = known->second;
            co_return;
        }
        outcome = is_silent_ ? errc::timed_out : (co_await line_.ask(unit_, read_holding, address, 1)).why;
        is_there_ = is_there_ or outcome == errc::none or is_refusal_of_unit(outcome);
        is_silent_ = not is_there_;
        outcomes_.emplace_back(address, outcome);
    }

    [[nodiscard]] bool is_there() const noexcept { return is_there_; }

private:
    asked_line& line_;
    std::vector<std::pair<std::uint16_t, errc>> outcomes_{};
    std::uint8_t unit_;
    bool is_there_{false};
    bool is_silent_{false};
};

steps ask_identity(asked_line& line, std::uint8_t unit, identity& who, answer& last)
{
    for (std::uint8_t object = 0;;) {
        last = co_await line.ask_identity(unit, object);
        auto const page = rtuwire::device_identification::decode(last.pdu);
        if (last.why != errc::none or not page) {
            last.why = last.why == errc::none ? page.error() : last.why;
            co_return;
        }
        for (auto at = page->first(); at; at = page->after(*at)) {
            switch (at->id) {
            case rtuwire::vendor_name: who.vendor = text_of(at->value); break;
            case rtuwire::product_code: who.product = text_of(at->value); break;
            case rtuwire::major_minor_revision: who.revision = text_of(at->value); break;
            default: break;
            }
        }
        if (not page->more_follows or page->next_object <= object) {
            co_return;
        }
        object = page->next_object;
    }
}

/// Drops those whose own registers the unit does not have.
steps tell_apart(register_marks& marks, candidates& left)
{
    for (std::size_t i = 0; left.size() > 1 and i < left.size();) {
        tool::drive_catalog const* const other = left[i == 0 ? 1 : 0];
        auto const address = tool::only_in(*left[i], *other);
        errc outcome = errc::busy;
        if (address) {
            co_await marks.look(*address, outcome);
        }
        if (outcome == errc::none) {
            std::erase(left, other);
        } else if (outcome == errc::illegal_data_address) {
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
        } else {
            ++i;
        }
    }
}

/// Those whose status and fault registers a unit has, and its command register. Whatever has them, or has those that other
/// drives number as CiA 402 does, may be a drive.
steps find_by_registers(register_marks& marks, candidates& found, bool& may_be_drive)
{
    constexpr std::uint16_t status_object = 0x6041, control_object = 0x6040;
    auto const has = [](errc outcome) { return outcome == errc::none; };
    for (auto const* const each : tool::all_catalogs()) {
        errc status{}, fault{}, command{};
        co_await marks.look(each->layout.eta, status);
        if (not marks.is_there()) {
            co_return;
        }
        co_await marks.look(each->layout.cmd, command);
        may_be_drive = may_be_drive or (has(status) and has(command));
        if (has(status)) {
            co_await marks.look(each->layout.lft, fault);
        }
        if (has(status) and has(fault)) {
            found.push_back(each);
        }
    }
    if (found.empty() and not may_be_drive) {
        errc status{}, control{};
        co_await marks.look(status_object, status);
        if (has(status)) {
            co_await marks.look(control_object, control);
        }
        may_be_drive = has(status) and has(control);
    }
}

/// A device that has any register is no known drive: it would have what only others have, too.
steps find_drive(register_marks& marks, bool refuses_identity, identity& who)
{
    candidates found;
    co_await find_by_registers(marks, found, who.may_be_drive);
    if (refuses_identity) {
        std::erase_if(found, [](auto const* each) {
            return each->functions.contains(rtuwire::function_code::encapsulated_interface);
        });
    }
    candidates fitting;
    for (auto const* const each : found) {
        bool fits = true;
        for (auto const* const other : tool::all_catalogs()) {
            auto const own = tool::only_in(*each, *other), others = tool::only_in(*other, *each);
            errc has_own = errc::none, has_others = errc::illegal_data_address;
            if (other != each and fits and own) {
                co_await marks.look(*own, has_own);
            }
            if (other != each and fits and others) {
                co_await marks.look(*others, has_others);
            }
            fits = fits and has_own == errc::none and has_others == errc::illegal_data_address;
        }
        if (fits) {
            fitting.push_back(each);
        }
    }
    who.drive = fitting.size() == 1 ? fitting.front() : nullptr;
}

steps find_out(asked_line& line, std::uint8_t unit, identity& who)
{
    who = {}; // known at its end: what is cut short is asked anew
    line.note_drive(unit, false);
    register_marks marks{line, unit};
    answer last;
    co_await ask_identity(line, unit, who, last);
    if (last.why == errc::none) {
        who.is_there = true;
        candidates left;
        for (auto const* const each : tool::all_catalogs()) {
            if (not who.product.empty() and tool::family_of(each->reference) == tool::family_of(who.product)) {
                left.push_back(each);
            }
        }
        co_await tell_apart(marks, left);
        who.drive = left.size() == 1 ? left.front() : nullptr;
        who.may_be_drive = not left.empty() or tool::names_a_drive(who.product) or tool::names_a_drive(who.vendor) or
                           tool::names_a_drive(who.revision);
    } else {
        co_await find_drive(marks, is_refusal_of_unit(last.why), who);
        who.is_there = is_refusal_of_unit(last.why) or marks.is_there();
        who.may_be_drive = who.may_be_drive or who.drive != nullptr;
        who.note = who.is_there ? "does not say who it is (" + std::string{rtuwire::name(last.why)} + ")"
                                : std::string{rtuwire::name(last.why)};
        if (not who.is_there) {
            line.tell_failure(unit, "identify", last);
        }
    }
    who.is_known = who.is_there;
    line.note_drive(unit, who.may_be_drive);
}

void tell_unit(asked_line& line, std::uint8_t unit, identity const& who)
{
    line.tell("unit", [&](json_text& out) {
        out.put("unit", unit);
        out.put("vendor", who.vendor);
        out.put("product", who.product);
        out.put("revision", who.revision);
        out.put("drive", who.drive == nullptr ? std::string_view{} : who.drive->name);
        out.put("mayBeDrive", who.may_be_drive);
        out.put("note", who.note);
    });
}

/// Registers that one request reads.
struct block {
    std::uint8_t function;
    std::uint16_t start;
    std::uint16_t count;
    std::vector<std::size_t> points; ///< by their places in the list
};

/// Neighbours go together, without a register between that nobody asked for.
std::vector<block> blocks_of(std::vector<point> const& points, std::uint16_t most)
{
    std::vector<std::size_t> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = i;
    }
    std::ranges::stable_sort(order, {}, [&](std::size_t at) {
        return std::tuple{points[at].space, points[at].address};
    });
    std::vector<block> blocks;
    for (std::size_t const at : order) {
        point const& each = points[at];
        std::uint32_t const end = each.address + std::uint32_t{each.count};
        block* const last = blocks.empty() ? nullptr : &blocks.back();
        bool const fits = last != nullptr and last->function == each.function() and
                          each.address <= last->start + std::uint32_t{last->count} and end - last->start <= most;
        if (fits) {
            last->count = std::max(last->count, static_cast<std::uint16_t>(end - last->start));
            last->points.push_back(at);
        } else {
            blocks.push_back({each.function(), each.address, each.count, {at}});
        }
    }
    return blocks;
}

void put_value(json_text& out, point const& of, point_value const& value)
{
    out.open_object();
    out.put("name", of.name);
    if (not value.number.empty()) {
        out.put_literal("number", value.number);
    }
    out.put("text", value.text);
    if (not value.wide.empty()) {
        out.put("wide", value.wide);
        out.put("step", tool::number_text(1, of.step));
    }
    out.put("unit", of.unit);
    out.close_object();
}

void tell_values(asked_line& line, std::uint8_t unit, block const& of, std::vector<point> const& points,
                 tool::drive_catalog const* drive, answer const& came)
{
    line.tell("values", [&](json_text& out) {
        out.put("unit", unit);
        out.open_list("values");
        for (std::size_t const at : of.points) {
            point const& each = points[at];
            std::span const words{came.words};
            put_value(out, each,
                      value_of(each, drive, words.subspan(std::size_t{each.address} - of.start, each.count)));
        }
        out.close_list();
    });
}

std::string what_of(block const& of, std::vector<point> const& points)
{
    std::string what = points[of.points.front()].name;
    return of.points.size() == 1 ? what : what + " to " + points[of.points.back()].name;
}

/// Ends with whether the line has an end: an echo, or nobody.
steps read_blocks(asked_line& line, identity const& who, std::uint8_t unit, std::vector<point> const& points,
                  std::vector<block>& blocks)
{
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        answer const came = co_await line.ask(unit, blocks[i].function, blocks[i].start, blocks[i].count);
        if (came.why == errc::none and came.words.size() >= blocks[i].count) {
            tell_values(line, unit, blocks[i], points, who.drive, came);
            continue;
        }
        bool const is_of_block = came.why == errc::illegal_data_address or came.why == errc::illegal_data_value;
        if (is_of_block and blocks[i].points.size() > 1) { // one of them alone may be missing
            block const whole = std::move(blocks[i]);
            blocks.erase(blocks.begin() + static_cast<std::ptrdiff_t>(i));
            for (std::size_t n = 0; n < whole.points.size(); ++n) {
                point const& each = points[whole.points[n]];
                blocks.insert(blocks.begin() + static_cast<std::ptrdiff_t>(i + n),
                              {whole.function, each.address, each.count, {whole.points[n]}});
            }
            --i;
            continue;
        }
        line.tell_failure(unit, what_of(blocks[i], points), came);
    }
}

void tell_consent_missing(asked_line& line, std::uint8_t unit, identity const& who)
{
    line.tell("consent", [&](json_text& out) {
        out.put("unit", unit);
        out.put("drive", who.drive == nullptr ? std::string_view{} : who.drive->name);
    });
}

std::string made_by()
{
    constexpr int part = 100;
    int const version = rtuwire::version;
    return "rtuwire " + std::to_string(version / part / part) + "." + std::to_string(version / part % part) + "." +
           std::to_string(version % part);
}

std::string json_quoted(std::string_view text)
{
    json_text out;
    out.put("", text);
    return out.text();
}

/// Every parameter of a map: a block that the drive refuses is asked for again in halves, until the register that it refuses
/// stands alone.
steps read_map(asked_line& line, std::uint8_t unit, tool::saved_settings& to, answer& last)
{
    auto const is_any = [](rtuwire::altivar::parameter const&) { return true; };
    rtuwire::altivar::block_walk walk{to.drive->limits.read};
    std::size_t const size = to.drive->map.size();
    while (walk.find(to.drive->map, is_any)) {
        auto const block = walk.block();
        last = co_await line.ask(unit, read_holding, block.start, block.count);
        bool const is_of_registers = last.why == errc::illegal_data_address or last.why == errc::illegal_data_value or
                                     last.why == errc::server_device_failure;
        if (last.why == errc::none) {
            for (std::uint16_t i = 0; i < block.count; ++i) {
                if (auto const* const entry = to.drive->at(static_cast<std::uint16_t>(block.start + i))) {
                    to.parameters.push_back({entry, last.words[i], {}, {}});
                }
            }
            walk.pass();
        } else if (not is_of_registers) {
            co_return;
        } else if (walk.refuse()) {
            if (auto const* const entry = to.drive->at(block.start)) {
                to.parameters.push_back({entry, std::nullopt, std::string{rtuwire::name(last.why)}, {}});
            }
            walk.pass();
        }
        line.tell("progress", [&](json_text& out) {
            out.put("done", to.parameters.size());
            out.put("of", size);
        });
    }
    last.why = errc::none;
}

std::optional<std::uint16_t> word_of(tool::saved_settings const& all, std::string_view code)
{
    auto const found = std::ranges::find_if(all.parameters, [&](auto const& each) { return each.entry->code == code; });
    return found == all.parameters.end() ? std::nullopt : found->word;
}

/// As the command line tool writes it: a parameter a line, by group and address.
std::string backup_text(tool::saved_settings& all)
{
    constexpr std::pair<char const*, char const*> of_drive[]{
        {"rating", "NCV"}, {"mains", "VCAL"}, {"rated current", "INV"}, {"firmware", "VDP"}, {"power firmware", "MPV"}};
    for (auto const& [name, code] : of_drive) {
        auto const* const entry = all.drive->by_code(code);
        if (auto const word = word_of(all, code); word and entry != nullptr) {
            all.head.emplace_back(name, tool::text_of(*entry, *word));
        }
    }
    std::ranges::stable_sort(all.parameters, {}, [](auto const& each) {
        return std::tuple{each.entry->group, each.entry->address};
    });
    std::string text = "{\n";
    for (auto const& [name, value] : all.head) {
        text += json_quoted(name) + ": " + json_quoted(value) + ",\n";
    }
    text += "\"rows\": \"" + std::to_string(all.parameters.size()) + "\",\n\"parameters\": [";
    for (tool::saved_parameter const& each : all.parameters) {
        tool::register_entry const& entry = *each.entry;
        tool::saved_value const value =
            each.word ? tool::value_to_save(entry, *all.drive, *each.word, word_of(all, entry.steps_set_by))
                      : tool::saved_value{};
        json_text row;
        row.open_object();
        row.put("group", entry.group);
        row.put("address", entry.address);
        row.put("register", entry.code);
        if (not entry.menu.empty()) {
            row.put("menu", entry.menu);
        }
        if (each.word) {
            row.put("raw", *each.word);
        } else {
            row.put("error", each.error);
        }
        if (value.is_number) {
            row.put_literal("value", value.text);
        } else if (not value.text.empty()) {
            row.put("value", value.text);
        }
        if (not value.unit.empty()) {
            row.put("unit", value.unit);
        }
        if (not entry.name.empty()) {
            row.put("name", entry.name);
        }
        row.close_object();
        text += (&each == all.parameters.data() ? "\n" : ",\n") + row.text();
    }
    return text + "\n]}\n";
}

} // namespace

steps scan(asked_line& line, identities& all, std::uint8_t first, std::uint8_t last)
{
    constexpr std::uint16_t asked_register = 3201; // ETA; of a meter any: a refusal is an answer
    for (unsigned unit = first; unit <= last; ++unit) {
        line.tell("progress", [&](json_text& out) {
            out.put("done", unit - first);
            out.put("of", last - first + 1U);
            out.put("unit", unit);
        });
        auto const address = static_cast<std::uint8_t>(unit);
        all[unit] = {};
        line.note_drive(address, false); // one request to each, before anybody knows who it is
        answer const came = co_await line.ask(address, read_holding, asked_register, 1);
        if (came.is_there()) {
            identity& who = all[unit];
            co_await find_out(line, address, who);
            tell_unit(line, address, who);
        } else if (came.why != errc::timed_out or not came.bytes.empty()) {
            line.tell_failure(address, "scan", came);
        }
        if (came.why == errc::line_echo) {
            co_return;
        }
    }
}

steps identify(asked_line& line, identities& all, std::uint8_t unit)
{
    co_await find_out(line, unit, all[unit]);
    if (all[unit].is_there) {
        tell_unit(line, unit, all[unit]);
    }
}

steps watch(asked_line& line, identities& all, std::uint8_t unit, std::vector<point> points, microseconds period,
            std::uint16_t most)
{
    if (not all[unit].is_known) {
        co_await identify(line, all, unit);
        if (not all[unit].is_there) {
            co_return;
        }
    }
    if (not line.may_poll(unit)) {
        tell_consent_missing(line, unit, all[unit]);
        co_return;
    }
    auto const* const drive = all[unit].drive;
    auto blocks = blocks_of(points, drive == nullptr ? most : std::min(most, drive->limits.read));
    for (;;) {
        microseconds const next = line.now() + period;
        co_await read_blocks(line, all[unit], unit, points, blocks);
        line.tell("round", [&](json_text& out) { out.put("unit", unit); });
        if (period == 0) {
            co_return;
        }
        co_await line.wait_until(std::max(next, line.now()));
    }
}

steps back_up(asked_line& line, identities& all, std::uint8_t unit, std::string time_text, std::string& file)
{
    file.clear();
    if (not all[unit].is_known) {
        co_await identify(line, all, unit);
    }
    identity const& who = all[unit];
    if (not line.may_poll(unit)) {
        tell_consent_missing(line, unit, who);
        co_return;
    }
    if (who.drive == nullptr) {
        line.tell("nothing", [&](json_text& out) { out.put("unit", unit); });
        co_return;
    }
    tool::saved_settings read;
    read.drive = who.drive;
    answer last;
    co_await read_map(line, unit, read, last);
    if (last.why != errc::none) {
        line.tell_failure(unit, "backup", last);
        co_return;
    }
    read.head = {
        {"format", "rtuwire backup 1"}, {"made by", made_by()},         {"time", std::move(time_text)},
        {"port", "Web Serial"},         {"unit", std::to_string(unit)}, {"drive", std::string{who.drive->name}},
        {"vendor", who.vendor},         {"product", who.product},       {"revision", who.revision}};
    file = backup_text(read);
    line.tell("backup", [&](json_text& out) {
        out.put("unit", unit);
        out.put("rows", read.parameters.size());
        out.put("refused", std::ranges::count_if(read.parameters, [](auto const& each) { return not each.word; }));
    });
}

} // namespace line_page
