// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "opened_line.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <thread>
#include <utility>
#include <variant>

#include "../support/platform.hpp"
#include "line/reading.hpp"
#include "line/time_text.hpp"
#include "line/who_is_it.hpp"
#include "line/write_log.hpp"
#include "motion/checked_values.hpp"
#include "motion/unsafe_write.hpp"
#include "output/plain_text.hpp"
#include "words/named_value.hpp"

namespace tool::gateway {

namespace {

using rtuwire::errc;

/// A gateway on the way says of a unit that it does not respond.
bool is_silence(errc why)
{
    return status_of(why) == exit_status::no_answer or why == errc::gateway_path_unavailable or
           why == errc::gateway_target_failed_to_respond;
}

/// Nobody is heard who could be asked on.
bool is_unheard(errc why) { return is_silence(why) or is_damage(why); }

/// What came is no response of the unit: nothing, or something damaged.
bool is_no_response(errc why) { return why != errc::none and not is_refusal_of_unit(why); }

std::optional<double> number_of(cell const& value)
{
    if (auto const* const amount = std::get_if<double>(&value)) {
        return *amount;
    }
    if (auto const* const large = std::get_if<std::uint64_t>(&value)) {
        return static_cast<double>(*large);
    }
    auto const* const count = std::get_if<std::int64_t>(&value);
    return count != nullptr ? std::optional{static_cast<double>(*count)} : std::nullopt;
}

/// "#25", "0x19": words for whoever looks at registers, ten times the value where its scale is 0.1.
bool is_raw_count(chosen_register const& which, std::string_view text)
{
    text.remove_prefix(std::min(text.find_first_not_of(" +-"), text.size()));
    return which.where.form.type != value_type::text and
           (text.starts_with('#') or text.starts_with("0x") or text.starts_with("0X"));
}

/// Why a value that was read is none; empty where it is one.
std::string why_invalid(device_value const& value, reading const& it, std::vector<std::uint16_t> const& words)
{
    if (std::holds_alternative<std::monostate>(it.value)) {
        return it.text;
    }
    std::optional<double> const number = number_of(it.value);
    if (number and not std::isfinite(*number)) {
        return it.text + " is no number";
    }
    named_place const* const named = value.which.named;
    if (named == nullptr) {
        return {};
    }
    if (is_no_value(*named, words)) {
        return it.text;
    }
    if (not named->choices.empty() and number) {
        return it.text;
    }
    bool const is_outside =
        number and (*number < named->lowest.value_or(*number) or *number > named->highest.value_or(*number));
    return is_outside ? it.text + " is outside its limits" : std::string{};
}

/// By which values are read, and so what may be taken for another's.
bool reads_registers(std::byte function) { return function <= std::byte{4}; }

/// So long as it lives, a setting may leave.
class on_its_way {
public:
    on_its_way(waiting_setting const*& place, waiting_setting const& setting) : place_{place} { place_ = &setting; }
    on_its_way(on_its_way const&) = delete;
    on_its_way& operator=(on_its_way const&) = delete;
    ~on_its_way() { place_ = nullptr; }

private:
    waiting_setting const*& place_;
};

/// Of one that has said who it is before.
std::string why_unsaid(device_plan const& device)
{
    return "unit " + std::to_string(device.unit.unit.byte()) + " does not say who it is, as it did, and is to be '" +
           device.names->vendor + ' ' + device.names->product + '\'';
}

} // namespace

opened_line::opened_line(line_plan const& plan, std::function<void(std::string const&)> tell)
    : plan_{plan}, tell_{std::move(tell)}, has_said_(plan.devices.size()), looks_(plan.devices.size()),
      settings_(plan.devices.size())
{
    serve(plan.serve);
    for (device_part& each : parts_of(plan)) {
        device_plan const& device = plan.devices[each.device];
        std::vector<chosen_register> registers;
        for (std::size_t const which : each.values) {
            registers.push_back(device.values[which].which);
        }
        register_reader reader{registers, {device.drive, device.names.get()}};
        parts_.push_back({std::move(each), std::move(reader)});
    }
}

void opened_line::serve(std::optional<serve_choices> const& by)
{
    clients_.reset();
    if (by) {
        clients_.emplace(choices{.line = plan_.choices, .serve = *by}, tell_);
    }
    if (clients_ and line_) {
        clients_->begin(*line_);
    }
}

std::uint64_t opened_line::unix_time() const { return unix_now(); }

void opened_line::wait(clock::time_point until)
{
    if (clients_) {
        clients_->wait(line_ ? line_->port().descriptor_number() : -1, until);
        if (line_) { // what has come meanwhile
            line_->let_pass(std::chrono::microseconds{0});
        }
    } else if (line_) {
        auto const left = std::chrono::ceil<std::chrono::microseconds>(until - now());
        line_->let_pass(std::max(left, std::chrono::microseconds{0}));
    } else {
        std::this_thread::sleep_until(until);
    }
}

/// Of the port, for a response.
void opened_line::wait(int descriptor, rtuwire::instant until)
{
    rtuwire::host_deadline const end{until};
    for (bool is_over = false; not is_over;) {
        std::chrono::microseconds const left = rtuwire::to_chrono(end.left());
        is_over = left <= beat_period;
        if (wait_for_bytes(descriptor, std::min<std::chrono::microseconds>(left, beat_period))) {
            return;
        }
        beat();
    }
}

bool opened_line::wait_for_bytes(int descriptor, std::chrono::microseconds time)
{
    if (clients_) {
        return clients_->wait_for_bytes(descriptor, now() + time);
    }
    pollfd port = watched_port(descriptor, POLLIN);
    timespec const left{time.count() / 1'000'000, time.count() % 1'000'000 * 1'000};
    return ::ppoll(&port, 1, &left, nullptr) > 0;
}

void opened_line::serve_one()
{
    if (clients_) {
        clients_->serve_one();
    }
}

void opened_line::open()
{
    line_.emplace(plan_.choices);
    line_->count_in(&counts_);
    line_->port().attend(*this);
    if (clients_) {
        clients_->begin(*line_);
    }
}

void opened_line::close()
{
    std::ranges::for_each(parts_, &read_part::begin_anew);
    std::ranges::for_each(looks_, &earlier_turns::begin_anew);
    std::ranges::for_each(settings_, &earlier_turns::begin_anew);
    if (clients_) {
        clients_->end();
    }
    line_.reset();
}

void opened_line::note_asked(device_plan const& device)
{
    if (clients_) {
        clients_->note_asked(device.unit.unit.byte());
    }
}

void opened_line::note_outcome(device_plan const& device, bool has_responded)
{
    if (clients_) {
        clients_->note_outcome(device.unit.unit.byte(), has_responded);
    }
}

void opened_line::hold_clients(device_plan const& device)
{
    std::uint8_t const unit = device.unit.unit.byte();
    if (clients_) {
        for (auto const& [function, until] : line_->exchange().owed().functions_owed(std::byte{unit})) {
            clients_->leave_alone(unit, function, until);
        }
    }
}

bool opened_line::is_left_alone(std::size_t device) const
{
    std::uint8_t const unit = plan_.devices[device].unit.unit.byte();
    if (not line_) {
        return false;
    }
    owed_answers const& owed = line_->exchange().owed();
    // Of one that is late whatever may come holds up the line until it has, where that is asked meanwhile.
    bool const is_late = owed.is_late(std::byte{unit});
    return now() < owed.rests_until(std::byte{unit}) or
           std::ranges::any_of(owed.functions_owed(std::byte{unit}), [&](auto const& each) {
               return (is_late or reads_registers(each.first)) and now() < each.second;
           });
}

void opened_line::keep_turn(std::size_t device)
{
    if (clients_) {
        clients_->keep_turn(plan_.devices[device].unit.unit.byte());
    }
}

device_finding opened_line::who_answers(std::size_t which)
{
    device_plan const& device = plan_.devices[which];
    auto const found = [](std::string why) {
        return why.empty() ? device_finding{} : device_finding{device_finding::kind::wrong, std::move(why)};
    };
    unit_address const unit = device.unit.unit;
    // Most meters say nothing to function 43: one that need not say who it is costs one time-out.
    std::optional<errc> silence;
    if (device.drive == nullptr and device.names->vendor.empty()) {
        using identity = rtuwire::read_device_identification;
        errc const asked =
            line_->ask_once(device.unit.unit, identity{rtuwire::identification_access::basic, 0}).error();
        silence = is_silence(asked) ? std::optional{asked} : std::nullopt;
    }
    identity_words const who = who_is_it(*line_, unit, silence);
    if (who.outcome == exit_status::port) {
        throw ended{exit_status::port, line_->port().failure()};
    }
    std::string const says =
        "unit " + std::to_string(unit.byte()) + " calls itself '" + who.vendor + ' ' + who.product + '\'';
    if (device.drive != nullptr) {
        bool const is_other = who.is_another or is_of_another_family(who, *device.drive);
        return found(is_other ? (who.product.empty()
                                     ? "unit " + std::to_string(unit.byte()) +
                                           (who.drive.empty() ? " is none of these drives" : " is an " + who.drive)
                                     : says) +
                                    ", and the file says that it is an " + device.unit.drive
                              : std::string{});
    }
    bool const is_drive = not who.drive.empty() or who.may_be_drive;
    unnamed_drive const unnamed = is_drive ? unnamed_drive{} : look_for_unnamed_drive(*line_, unit, who);
    if (is_damage(unnamed.open)) {
        return {device_finding::kind::silent, line_->words_of_failure(unnamed.open)};
    }
    if ((is_drive or unnamed.may_be_one) and not device.feeds_supervision) {
        return found((who.product.empty() ? "unit " + std::to_string(unit.byte()) : says + " and") +
                     (who.drive.empty() ? " may be a drive" : " is an " + who.drive) +
                     (unnamed.open == errc::none ? "" : ", which stays open because of " + words_of(unnamed.open)) +
                     ": reading it feeds its supervision of the line, which the file does not say: drive = \"...\" and "
                     "feeds_supervision = true");
    }
    if (device.names->vendor.empty()) {
        return {};
    }
    bool const is_said = not who.product.empty();
    if (not is_said and has_said_[which]) {
        auto const what = who.is_another ? device_finding::kind::wrong : device_finding::kind::silent;
        return {what, why_unsaid(device)};
    }
    std::string why =
        is_said ? why_another_device(unit, who, device.names->vendor, device.names->product) : std::string{};
    has_said_[which] = has_said_[which] or (is_said and why.empty());
    if (not is_said) {
        return {device_finding::kind::right,
                "it does not say who it is (function 43), as its register file has it: until it does, another "
                "one in its place is found by a silence alone"};
    }
    return found(std::move(why));
}

device_finding opened_line::look_at(std::size_t which, bool is_known_silent)
{
    device_plan const& device = plan_.devices[which];
    // One that is away costs one request.
    auto const look = is_known_silent ? look_at_place : read_place;
    held_words const first = look(*line_, device.unit.unit, device.values.front().which.where);
    if (status_of(first.why) == exit_status::port) {
        throw ended{exit_status::port, line_->port().failure()};
    }
    return is_unheard(first.why) ? device_finding{device_finding::kind::silent, first.failure} : who_answers(which);
}

device_finding opened_line::identify(std::size_t which, bool is_known_silent)
{
    using enum device_finding::kind;
    device_plan const& device = plan_.devices[which];
    note_asked(device);
    auto const found = line_->ask_on(looks_[which], [&] { return look_at(which, is_known_silent); });
    for (read_part& each : parts_) {
        if (found and found->what != right and each.what.device == which) {
            each.begin_anew();
        }
    }
    hold_clients(device);
    if (found) {
        note_outcome(device, found->what != silent);
    }
    return found.value_or(device_finding{open});
}

slot_value opened_line::value_of(device_plan const& device, device_value const& value,
                                 register_reader const& from) const
{
    reading const it = reading_of(value.which, from, device.drive);
    if (not it.is_read) {
        return {.state = value_state::failed, .why = it.text};
    }
    std::string why = why_invalid(value, it, from.held(value.which.where).words);
    return why.empty() ? slot_value{.state = value_state::valid, .value = it.value}
                       : slot_value{.state = value_state::invalid, .why = std::move(why)};
}

part_reading opened_line::read(std::size_t which)
{
    read_part& part = parts_[which];
    device_plan const& device = plan_.devices[part.what.device];
    note_asked(device);
    part_reading found{.is_through = part.reader.read_on(*line_, device.unit.unit),
                       .has_responded = part.has_responded,
                       .was_repeated = part.reader.was_repeated(),
                       .why = part.reader.first_failure()};
    for (std::size_t const each : part.what.values) {
        device_value const& value = device.values[each];
        if (not part.reader.is_of_last_turn(value.which.where)) {
            found.values.emplace_back();
            continue;
        }
        errc const why = part.reader.held(value.which.where).why;
        found.has_responded = found.has_responded or not is_no_response(why);
        found.has_fallen_silent = found.has_fallen_silent or is_silence(why);
        found.values.emplace_back(value_of(device, value, part.reader));
    }
    part.has_responded = not found.is_through and found.has_responded;
    if (found.was_repeated) {
        constexpr std::string_view joint{"; "};
        std::string const words = line_->exchange().owed().words_of_silence(line_->form());
        found.late = words.substr(std::min(joint.size(), words.size()));
    }
    hold_clients(device);
    note_outcome(device, found.has_responded and not found.has_fallen_silent);
    return found;
}

std::optional<setting_outcome> opened_line::write(waiting_setting const& setting, bool goes_on,
                                                  setting_look const& last_look)
{
    std::size_t const which = setting.request.device;
    device_plan const& device = plan_.devices[which];
    earlier_turns& so_far = settings_[which];
    if (not goes_on) {
        so_far.begin_anew();
        looks_[which].begin_anew(); // it would be old behind this
    }
    note_asked(device);
    auto outcome = line_->ask_on(so_far, [&] { return set(setting, last_look); });
    hold_clients(device);
    return outcome;
}

setting_outcome opened_line::set(waiting_setting const& setting, setting_look const& last_look)
{
    setting_request const& request = setting.request;
    device_plan const& device = plan_.devices[request.device];
    chosen_register const& which = device.values[request.value].which;
    std::string const label = label_of(which);
    if (request.text.empty() or request.text.size() > 256 or plain_text(request.text) != request.text) {
        return {setting_result::refused, "no value is empty, longer than 256 bytes or has control characters"};
    }
    if (is_raw_count(which, request.text)) {
        return {setting_result::refused, "'" + request.text + "' is a raw count: a setting is a value in the unit of " +
                                             label + ", or the name of a choice"};
    }
    choices chosen{.line = plan_.choices, .allowed = {.may_write = true, .knows_run = false}};
    chosen.line.unit = std::to_string(device.unit.unit.byte());
    try {
        if (std::string const why = why_nothing_can_be_noted(); not why.empty()) {
            return {setting_result::refused, "nothing could be noted: " + why};
        }
        write_rules const rules = rules_to_write(*line_, device.unit, chosen.allowed);
        if (has_said_[request.device] and not rules.says_it_is_none) {
            return {setting_result::failed, why_unsaid(device)};
        }
        value_list const values = checked_values({label + '=' + request.text}, *line_, device.unit, rules, chosen);
        if (values.size() != 1 or values[0].where != which.where) {
            return {setting_result::refused, "'" + request.text + "' is no value of " + label};
        }
        if (rules.drive == nullptr) {
            refuse_frame_within(device.unit.unit, values);
        }
        line_->ask_anew();
        held_words const before = read_place(*line_, device.unit.unit, values[0].where);
        bool const is_held = before.why == errc::none and values[0].is_held_by(before.words);
        if (is_held or line_->asks_in_turns()) { // what it said may be of another one, seconds ago
            if (std::string why = why_exchanged(*line_, device.unit.unit, rules); not why.empty()) {
                return {setting_result::failed, std::move(why)};
            }
        }
        if (is_held) {
            return {setting_result::done, "it is " + values[0].text + " already, and is not written again"};
        }
        line_->ask_rest_at_once();
        if (rules.drive != nullptr) {
            if (auto const why = why_not_now(values, *line_, device.unit.unit, *rules.drive, chosen.allowed)) {
                return {why->status == exit_status::refused ? setting_result::refused : setting_result::failed,
                        why->what()};
            }
        }
        return send(setting, values, rules, before, last_look);
    } catch (ended const& why) {
        if (why.status == exit_status::port) {
            return lost(why.what(), false);
        }
        bool const is_refused = why.status == exit_status::usage or why.status == exit_status::refused;
        return {is_refused ? setting_result::refused : setting_result::failed, why.what()};
    }
}

setting_outcome opened_line::lost(std::string why, bool was_sent)
{
    std::string port = line_->port().failure();
    return {setting_result::failed, why, was_sent, port.empty() ? why : std::move(port)};
}

setting_outcome opened_line::send(waiting_setting const& setting, value_list const& values, write_rules const& rules,
                                  held_words const& before, setting_look const& last_look)
{
    device_plan const& device = plan_.devices[setting.request.device];
    value_to_write const& value = values[0];
    unit_address const unit = device.unit.unit;
    if (auto stopped = last_look()) {
        return std::move(*stopped);
    }
    std::string note;
    // Once: what became of a request without a response is read, and nothing is written again.
    errc const outcome = [&] {
        on_its_way const mark{sent_, setting};
        return value_sender{*line_, unit, device.drive != nullptr}.send(values, note);
    }();
    if (outcome == errc::cancelled) { // what the unit owed, or what was heard, has kept it back
        return {setting_result::expired, why_too_late};
    }
    std::string failure = outcome == errc::none ? std::string{} : line_->words_of_failure(outcome);
    if (status_of(outcome) == exit_status::port) {
        return lost("written or not, nobody knows: " + failure, true);
    }
    held_words const after = read_place(*line_, unit, value.where);
    std::string const was = before.why == errc::none ? value.text_of_words(before.words) : "unknown";
    std::string const is = after.why == errc::none ? value.text_of_words(after.words) : "unknown";
    bool const is_held = after.why == errc::none and value.is_held_by(after.words);
    setting_outcome done{setting_result::done, note, true};
    // What answers behind a response that was lost may be another one, which holds the same.
    std::string const other = is_held and outcome != errc::none and not is_refusal_to_write(outcome)
                                  ? why_exchanged(*line_, unit, rules)
                                  : std::string{};
    if (not other.empty()) {
        done.result = setting_result::failed;
        done.why = failure + "; " + other;
    } else if (not is_held or is_refusal_to_write(outcome)) {
        done.result = is_refusal_to_write(outcome) ? setting_result::refused : setting_result::failed;
        done.why = outcome != errc::none     ? failure
                   : after.why != errc::none ? "it could not be read back: " + after.failure
                                             : "the unit holds " + is;
    }
    bool const was_not_written =
        is_refusal_to_write(outcome) and after.why == errc::none and before.words == after.words;
    std::string const missed =
        was_not_written ? std::string{}
                        : log_write({plan_.choices.port, unit.byte(), label_of({value.where, value.entry}), was, is});
    done.why += missed.empty() ? "" : (done.why.empty() ? "" : "; ") + std::string{"not noted: "} + missed;
    if (status_of(after.why) == exit_status::port) {
        return lost("written, and not read back: " + line_->port().failure(), true);
    }
    return done;
}

} // namespace tool::gateway
