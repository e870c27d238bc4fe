// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "serve/served_line.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "frame/frame_fit.hpp"
#include "frame/hex_text.hpp"
#include "line/line_words.hpp"
#include "line/raw_request.hpp"
#include "line/reading.hpp"
#include "line/write_log.hpp"
#include "motion/raw_effect.hpp"

namespace tool {

namespace {

using rtuwire::byte_view;
using rtuwire::errc;
using std::chrono::steady_clock;

rtuwire::raw_pdu<> raw_in(served_request const& request)
{
    return {static_cast<rtuwire::function_code>(request.pdu[0]), byte_view{request.pdu}.subspan(1)};
}

/// A gateway's own words of a unit behind it that does not answer.
bool is_gateway_silence(errc why)
{
    return why == errc::gateway_path_unavailable or why == errc::gateway_target_failed_to_respond;
}

bool has_gone_by_silence(errc why) { return status_of(why) == exit_status::no_answer or is_gateway_silence(why); }

std::string number_of(std::uint8_t unit) { return "unit " + std::to_string(unit); }

} // namespace

reopened_line::reopened_line(choices const& chosen, serve_settings const& settings, served_clients& clients,
                             serve_counts& counts, serve_events const& events)
    : chosen_{chosen}, clients_{clients}, counts_{counts}, events_{events},
      line_{std::make_unique<open_line>(chosen.line)}, served_{chosen, settings, clients, counts, events}
{
    begin();
}

void reopened_line::begin()
{
    line_->port().attend(clients_);
    served_.begin(*line_);
}

void reopened_line::run()
{
    while (not clients_.is_ending()) {
        bool const is_up = line_ != nullptr or open_again();
        serve_time const until = is_up ? steady_clock::now() + std::chrono::minutes{1} : next_opening_;
        if (not clients_.wait_for_request(is_up ? line_->port().descriptor_number() : -1, until)) {
            lose(line_->port().device() + ": the port has gone");
            continue;
        }
        if (auto const request = clients_.is_ending() ? std::nullopt : clients_.take()) {
            served_.handle(*request);
            if (is_up and not served_.has_line()) {
                lose(served_.why_lost());
            }
            tell_back();
        }
    }
}

bool reopened_line::open_again()
{
    if (steady_clock::now() < next_opening_) {
        return false;
    }
    line_choices again = chosen_.line;
    again.must_not_listen = true; // it was this program's line
    auto const began = steady_clock::now();
    auto const failure = ended_by([&] { line_ = std::make_unique<open_line>(again); });
    if (failure) { // a host that does not answer keeps everybody waiting for as long as it is tried
        auto const now = steady_clock::now();
        next_opening_ = now + std::max<steady_clock::duration>(reopening_pause, 3 * (now - began));
        tell_away("port_away", failure->what(), "it is tried again and again");
        return false;
    }
    begin();
    opened_ = steady_clock::now();
    tell_back();
    return true;
}

void reopened_line::tell_away(std::string const& event, std::string const& why, std::string const& behind)
{
    constexpr std::size_t most_told = 16; // where each shows other bytes
    if (told_away_.size() < most_told and told_away_.insert(why).second) {
        events_.tell(event, {{"port", chosen_.line.port}}, why + "; " + behind);
    }
}

void reopened_line::tell_back()
{
    if (told_away_.empty() or line_ == nullptr or (line_->port().is_connection() and line_->port().heard() == 0)) {
        return;
    }
    told_away_.clear();
    events_.tell("port_opened", {{"port", chosen_.line.port}}, chosen_.line.port + " is open again");
}

void reopened_line::lose(std::string const& why)
{
    // A server that hangs up behind its answers is there; where it cannot be reached again, that is told.
    bool const is_news = not line_->port().is_connection() or line_->port().heard() == 0;
    served_.end();
    line_.reset();
    ++counts_.port_losses;
    next_opening_ = opened_ + reopening_pause; // at once, but for one that goes again and again
    if (is_news) {
        tell_away("port_lost", why, "clients get exception 0B until it is back");
    }
}

void served_line::begin(open_line& line)
{
    line_ = &line;
    counts_.is_port_up = true;
}

void served_line::end()
{
    line_ = nullptr;
    known_.clear();
    silent_.forget();
    counts_.is_port_up = false;
}

void served_line::lose(std::string const& why)
{
    why_lost_ = why;
    end();
}

void served_line::handle(served_request const& request)
{
    std::uint8_t const unit = request.unit;
    if (line_ == nullptr) {
        refuse_as(request, errc::gateway_target_failed_to_respond, "port", "the port is away");
        return;
    }
    if (unit == 0) {
        broadcast(request);
        return;
    }
    silent_.note_request(unit, steady_clock::now());
    bool const may_be_asked =
        silent_.is_due(unit, steady_clock::now()) and not clients_.is_held(request, steady_clock::now());
    if (not may_be_asked and not is_word_that_stops(request.pdu)) {
        clients_.refuse(request, errc::gateway_target_failed_to_respond);
        return;
    }
    named_unit const who = unit_at(unit);
    bool const is_read = only_reads(request.pdu);
    forget_old(unit, is_read);
    bool const is_said_to_be_drive = not who.drive.empty() and who.drive != no_drive;
    if (not settings_.names_units() and is_said_to_be_drive) {
        tell_not_served(unit, "is said to be an " + who.drive);
        clients_.refuse(request, errc::gateway_path_unavailable);
        return;
    }
    if ((not is_read or not settings_.names_units()) and not identify(request, who)) {
        return;
    }
    if (not settings_.names_units() and known_.at(unit).may_be_drive()) {
        known_unit const& found = known_.at(unit);
        tell_not_served(unit, found.rules and found.rules->drive != nullptr
                                  ? "is an " + std::string{found.rules->drive->name}
                                  : "may be a drive (" + found.why + ")");
        clients_.refuse(request, errc::gateway_path_unavailable);
        return;
    }
    if (is_read) {
        if (holds_no_frame(request)) {
            forward(request, who);
        }
    } else if (auto const values = judge_write(request, who)) {
        std::string const sender = clients_.client_of(request);
        note_write(request, *values, sender, forward(request, who));
    }
}

void served_line::forget_old(std::uint8_t unit, bool is_read)
{
    auto const known = known_.find(unit);
    if (known == known_.end()) {
        return;
    }
    constexpr std::chrono::seconds longest_of_read{60};
    constexpr std::chrono::seconds longest_of_write{1};
    constexpr std::chrono::seconds longest_of_doubt{10};
    auto const now = steady_clock::now();
    auto const age = now - known->second.asked;
    bool const is_in_doubt = (not known->second.rules and age >= longest_of_doubt) or
                             (known->second.has_said_nothing and age >= longest_of_read);
    if (is_in_doubt or now - known->second.heard >= (is_read ? longest_of_read : longest_of_write)) {
        known_.erase(known);
    }
}

bool served_line::holds_no_frame(served_request const& request)
{
    auto const why = ended_by(
        [&] { refuse_frame_within(frame_of(std::byte{request.unit}, request.pdu), functions_within::public_ones); });
    if (why) {
        refuse_as(request, errc::illegal_function, "unsafe", number_of(request.unit) + ": " + why->what());
    }
    return not why;
}

void served_line::broadcast(served_request const& request)
{
    choices to_all = chosen_;
    to_all.allowed.may_run = true; // --allow-broadcast says it: what drives have is refused all the same
    auto const why = ended_by([&] {
        refuse_unreadable(request.pdu);
        refuse_broadcast(request.pdu, to_all);
        refuse_frame_within(frame_of(std::byte{0}, request.pdu), functions_within::public_ones);
    });
    if (why) {
        refuse_as(request, errc::illegal_function, "unsafe", why->what());
        return;
    }
    if (not can_be_noted(request, 1)) {
        return;
    }
    auto conversation = line_->with(sent_once{rtuwire::broadcast, raw_request{raw_in(request)}});
    errc const outcome = line_->run(conversation).error();
    note_write(request, {}, clients_.client_of(request), outcome == errc::none ? "" : line_->words_of_failure(outcome));
    if (status_of(outcome) == exit_status::port) {
        lose(line_->words_of_failure(outcome));
    }
    clients_.finish(request);
}

served_line::look served_line::look_for(named_unit const& unit)
{
    using identity = rtuwire::read_device_identification;
    auto asked = line_->once(
        request_once<identity>{rtuwire::unit_id{unit.unit}, identity{rtuwire::identification_access::basic, 0}});
    errc const first = line_->run(asked).error();
    if (not has_gone_by_silence(first)) {
        return {first};
    }
    using read = rtuwire::read_holding_registers;
    auto then = line_->once(
        request_once<read>{rtuwire::unit_id{unit.unit}, read{.start = all_catalogs().front()->layout.eta, .count = 1}});
    return {line_->run(then).error(), first};
}

bool served_line::identify(served_request const& request, named_unit const& unit)
{
    std::uint8_t const number = request.unit;
    if (known_.count(number) > 0) {
        return true;
    }
    auto const began = steady_clock::now();
    auto const [there, silence] = look_for(unit);
    if (status_of(there) == exit_status::port) {
        lose(line_->words_of_failure(there));
        clients_.refuse(request, errc::gateway_target_failed_to_respond);
        return false;
    }
    note_outcome(number, not has_gone_by_silence(there), began);
    if (has_gone_by_silence(there)) {
        clients_.refuse(request, is_gateway_silence(there) ? there : errc::gateway_target_failed_to_respond);
        return false;
    }
    known_unit found;
    auto const why =
        ended_by([&, asked = silence] { found.rules = rules_of_whoever(*line_, unit, chosen_.allowed, asked); });
    if (why and why->status == exit_status::port) {
        lose(why->what());
        clients_.refuse(request, errc::gateway_target_failed_to_respond);
        return false;
    }
    found.why = why ? why->what() : "";
    found.has_said_nothing = silence.has_value();
    found.asked = found.heard = steady_clock::now();
    known_.emplace(number, found);
    return true;
}

std::optional<std::vector<value_to_write>> served_line::judge_write(served_request const& request,
                                                                    named_unit const& unit)
{
    known_unit const& found = known_.at(request.unit);
    if (not found.rules) {
        refuse_as(request, errc::illegal_function, "unsafe", found.why);
        return std::nullopt;
    }
    choices judged = chosen_;
    // A command that a message shows: the port is taken, and a client may say nothing but 0000.
    judged.line.typed = {.program = chosen_.line.typed.program,
                         .options = " -p " + clients_.place(),
                         .unit = " -u " + std::to_string(request.unit),
                         .stop = "stop --freewheel"};
    std::vector<value_to_write> values;
    auto const began = steady_clock::now();
    auto const why = ended_by([&] { values = refuse_for_client(request.pdu, *line_, unit, *found.rules, judged); });
    if (why and why->status == exit_status::port) {
        lose(why->what());
        clients_.refuse(request, errc::gateway_target_failed_to_respond);
    } else if (why and why->status == exit_status::no_answer) {
        note_outcome(request.unit, false, began);
        clients_.refuse(request, errc::gateway_target_failed_to_respond);
    } else if (why) {
        std::string const text = why->what();
        std::string const number = number_of(request.unit);
        refuse_as(request, errc::illegal_function, "unsafe", text.starts_with(number) ? text : number + ": " + text);
    }
    bool const may_go = not why and can_be_noted(request, std::max<std::size_t>(values.size(), 1));
    return may_go ? std::optional{std::move(values)} : std::nullopt;
}

bool served_line::can_be_noted(served_request const& request, std::size_t rows)
{
    std::string const why = why_nothing_can_be_noted(rows);
    if (not why.empty()) {
        refuse_as(request, errc::server_device_failure, "log",
                  "nothing is written, because nothing could be noted: " + why);
    }
    return why.empty();
}

void served_line::note_write(served_request const& request, std::vector<value_to_write> const& values,
                             std::string const& sender, std::string const& outcome)
{
    std::string const how = "sent by " + sender + (outcome.empty() ? "" : ": " + outcome);
    std::string missed;
    for (value_to_write const& each : values) {
        missed = missed.empty() ? log_write({chosen_.line.port, request.unit, label_of({each.where, each.entry}),
                                             "unknown", each.text + " was " + how})
                                : missed;
    }
    if (values.empty()) {
        missed = log_write({chosen_.line.port, request.unit, "serve " + hex_of(request.pdu), "unknown", how});
    }
    if (not missed.empty()) {
        events_.tell("not_noted", {{"unit", std::uint64_t{request.unit}}, {"client", sender}},
                     number_of(request.unit) + ": " + hex_of(request.pdu) + " was " + how +
                         "; not noted in writes.log: " + missed);
    }
}

std::string served_line::forward(served_request const& request, named_unit const& unit)
{
    std::vector<std::byte> response;
    auto const began = steady_clock::now();
    auto asked = line_->once(sent_once{rtuwire::unit_id{unit.unit}, raw_request{raw_in(request)}});
    auto const heard = line_->run(asked);
    errc const why = heard.error();
    if (heard) {
        response.assign(heard->pdu().begin(), heard->pdu().end());
    }
    bool const is_response = why == errc::none or is_refusal_of_unit(why);
    if (is_response) {
        counts_.note_round_trip(request.unit, steady_clock::now() - began);
    }
    errc const flaw = why == errc::none ? flaw_of_response(request.pdu, response) : why;
    std::string const outcome = flaw == errc::none ? "" : line_->words_of_failure(flaw);
    if (status_of(why) == exit_status::port) {
        lose(outcome);
        clients_.refuse(request, errc::gateway_target_failed_to_respond);
        return outcome;
    }
    bool const says_who = request.pdu[0] == static_cast<std::byte>(rtuwire::function_code::encapsulated_interface);
    if (not is_response or says_who) {
        known_.erase(request.unit); // another may be there already
    }
    bool const is_lost = why != errc::none and not rtuwire::is_exception(why);
    if ((is_lost or request.sent > 0) and not line_->port().has_numbers()) { // an answer may come yet, to one of two
        auto const now = steady_clock::now();
        auto const all = is_lost ? now + rtuwire::to_chrono(line_->options().late_response) : now;
        clients_.leave_alone(request, all, only_reads(request.pdu) ? now + longest_lateness : all);
    }
    if (is_lost and is_to_be_repeated(request)) {
        served_request again = request;
        ++again.sent;
        clients_.put_back(std::move(again));
        return outcome;
    }
    note_outcome(request.unit, not has_gone_by_silence(why), began);
    if (flaw == errc::none) {
        clients_.answer(request, response);
    } else if (rtuwire::is_exception(why) and why != errc::unlisted_exception) {
        clients_.refuse(request, why);
    } else {
        clients_.refuse(request, errc::gateway_target_failed_to_respond);
    }
    return outcome;
}

bool served_line::is_to_be_repeated(served_request const& request) const
{
    return request.sent < line_->options().retries and only_reads(request.pdu) and
           silent_.has_answered(request.unit) and not clients_.is_ending();
}

void served_line::note_outcome(std::uint8_t unit, bool has_responded, serve_time began)
{
    auto const now = steady_clock::now();
    bool const is_news = silent_.note(unit, has_responded, now, now - began);
    if (not has_responded) {
        counts_.note_silence(unit);
        known_.erase(unit); // another may answer there next
    } else if (auto const known = known_.find(unit); known != known_.end()) {
        known->second.heard = now;
    }
    if (is_news) {
        events_.tell(has_responded ? "back" : "silent", {{"unit", std::uint64_t{unit}}},
                     number_of(unit) + (has_responded
                                            ? " answers again"
                                            : " does not answer" + line_->port().words_of_silence(line_->form())));
    }
}

void served_line::refuse_as(served_request const& request, errc exception, std::string const& kind,
                            std::string const& why)
{
    clients_.note_refused(kind, request, why);
    clients_.refuse(request, exception);
}

void served_line::tell_not_served(std::uint8_t unit, std::string const& what)
{
    counts_.note_refused("drive");
    if (told_units_.insert(unit).second) {
        events_.tell("refused", {{"kind", std::string{"drive"}}, {"unit", std::uint64_t{unit}}},
                     number_of(unit) + ' ' + what +
                         ", and is not served: each read would feed its supervision of the line, so that a motor whose "
                         "controller has gone runs on; to serve it all the same, name it: --units " +
                         std::to_string(unit));
    }
}

named_unit served_line::unit_at(std::uint8_t number) const
{
    line_choices one = chosen_.line;
    one.unit = std::to_string(number);
    return unit_in(one);
}

} // namespace tool
