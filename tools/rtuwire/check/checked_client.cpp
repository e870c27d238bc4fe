// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "check/checked_client.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

#include "frame/hex_text.hpp"
#include "line/end_wish.hpp"
#include "words/time_words.hpp"
#include "words/words.hpp"

namespace tool {

namespace {

constexpr std::size_t not_told = static_cast<std::size_t>(-1);
constexpr line_time look_step{10'000};      ///< between two looks at what the client prints
constexpr line_time end_of_request{20'000}; ///< of a function whose length is not known
constexpr line_time start_time{10'000'000};
constexpr line_time wait_for_request{30'000'000}; ///< of a client that asks by itself
constexpr line_time turnaround{50'000};
constexpr unsigned most_tries = 3;

std::vector<std::string> words_of(std::string_view text)
{
    std::istringstream in{std::string{text}};
    std::vector<std::string> words;
    for (std::string word; in >> word;) {
        words.push_back(word);
    }
    return words;
}

std::uint16_t word_at(line_bytes const& frame, std::size_t at)
{
    return static_cast<std::uint16_t>(std::to_integer<unsigned>(frame[at]) << 8U |
                                      std::to_integer<unsigned>(frame[at + 1]));
}

void add_register(line_bytes& bytes, unsigned value)
{
    bytes.push_back(static_cast<std::byte>(value >> 8U & 0xFFU));
    bytes.push_back(static_cast<std::byte>(value & 0xFFU));
}

/// What the registers of the served unit hold, and those of its neighbour.
unsigned value_of(unsigned address) { return 0x1000U + (address & 0xFFFU); }
unsigned other_value_of(unsigned address) { return 0x2000U + (address & 0xFFFU); }

constexpr std::size_t shortest_request = 8;

/// The whole size of a request by what it says of itself; nothing while that has not come, or of other functions.
std::optional<std::size_t> request_size(line_bytes const& came)
{
    if (came.size() < shortest_request) {
        return std::nullopt;
    }
    unsigned const function = std::to_integer<unsigned>(came[1]);
    bool const is_block = function == 0x0F or function == 0x10;
    return is_block                          ? std::optional{9 + std::to_integer<std::size_t>(came[6])}
           : function >= 1 and function <= 6 ? std::optional{shortest_request}
                                             : std::nullopt;
}

/// Byte count and registers, of which there may be others than it says.
line_bytes registers_body(unsigned address, unsigned said, unsigned there, unsigned (*value)(unsigned))
{
    line_bytes body{static_cast<std::byte>(2 * said)};
    for (unsigned i = 0; i < there; ++i) {
        add_register(body, value(address + i));
    }
    return body;
}

/// What stands behind the function of the right answer; empty for a function that is not served.
line_bytes body_of(line_bytes const& asked)
{
    unsigned const function = std::to_integer<unsigned>(asked[1]);
    if (not request_size(asked)) {
        return {};
    }
    unsigned const address = word_at(asked, 2), count = word_at(asked, 4);
    if (function <= 2) {
        line_bytes body((count + 7U) / 8U + 1U);
        body.front() = static_cast<std::byte>(body.size() - 1);
        return body;
    }
    return function <= 4 ? registers_body(address, count, std::min(count, 125U), value_of)
                         : line_bytes{asked.begin() + 2, asked.begin() + 6};
}

std::string with_silence(line_bytes const& frame, std::size_t every, char const* silence)
{
    std::string words;
    for (std::size_t i = 0; i < frame.size(); ++i) {
        words += (i > 0 and i % every == 0 ? std::string{silence} + " " : std::string{}) + hex_of({&frame[i], 1}) + " ";
    }
    return words;
}

/// A word of `client_table.cpp` in those of `clause_words.hpp`.
std::string plain_words(std::string const& word, line_bytes const& asked, line_time timeout)
{
    unsigned const function = std::to_integer<unsigned>(asked[1]);
    unsigned const address = word_at(asked, 2), count = word_at(asked, 4);
    line_bytes const body = body_of(asked);
    std::byte const function_byte = asked[1], refusal = static_cast<std::byte>(function | 0x80U);
    if (word.starts_with("~T")) {
        auto const ms = timeout.count() * std::stol(word.substr(2)) / 100'000;
        return "~" + std::to_string(ms) + "ms";
    }
    if (word == "GOOD") {
        return body.empty() ? "U " + hex_of({&refusal, 1}) + " 01 CRC"
                            : "U " + hex_of({&function_byte, 1}) + " " + hex_of(body) + " CRC";
    }
    if (word == "EACH" or word == "SPLIT") {
        line_bytes frame{asked[0], asked[1]};
        frame.insert(frame.end(), body.begin(), body.end());
        frame = framed(frame);
        return word == "EACH" ? with_silence(frame, 1, "~1ms") : with_silence(frame, frame.size() / 2 + 1, "~25ms");
    }
    line_bytes changed = body;
    if (word == "VALUE" or word == "PLACE") {
        (word == "VALUE" ? changed.back() : changed[1]) ^= std::byte{1};
        return hex_of(changed);
    }
    return word == "FN"      ? hex_of({&function_byte, 1})
           : word == "EX"    ? hex_of({&refusal, 1})
           : word == "BODY"  ? hex_of(body)
           : word == "ECHO"  ? hex_of(asked)
           : word == "OTHER" ? hex_of(registers_body(address, count, count, other_value_of))
           : word == "FEWER" ? hex_of(registers_body(address, count - 1, count - 1, value_of))
           : word == "MORE"  ? hex_of(registers_body(address, count + 1, count + 1, value_of))
           : word == "SHORT" ? hex_of(registers_body(address, count - 1, count, value_of))
           : word == "LONG"  ? hex_of(registers_body(address, count + 1, count, value_of))
           : word == "HALF"  ? hex_of(rtuwire::byte_view{body}.first(body.size() / 2 + 1))
                             : word;
}

std::vector<told_request> requests_told(std::string_view text, std::uint8_t unit)
{
    std::vector<told_request> all;
    for (std::string_view const each : parts_of(text, " / ")) {
        std::vector<std::string> const words = words_of(each);
        all.push_back({words[0] == "write", static_cast<std::uint8_t>(words[1] == "U" ? unit : std::stoul(words[1])),
                       static_cast<std::uint16_t>(std::stoul(words[2])),
                       static_cast<std::uint16_t>(std::stoul(words[3]))});
    }
    return all;
}

std::vector<std::string> words_of(told_request const& each)
{
    return {each.is_write ? "write" : "read", std::to_string(each.unit), std::to_string(each.address),
            std::to_string(each.number)};
}

std::string text_of(told_request const& each)
{
    std::string text;
    for (std::string const& word : words_of(each)) {
        text += (text.empty() ? "" : " ") + word;
    }
    return text;
}

bool asks(line_bytes const& frame, told_request const& which)
{
    if (not request_size(frame) or not has_right_crc(frame) or frame[0] != std::byte{which.unit} or
        word_at(frame, 2) != which.address) {
        return false;
    }
    unsigned const function = std::to_integer<unsigned>(frame[1]);
    return which.is_write ? (function == 0x06 and word_at(frame, 4) == which.number) or
                                (function == 0x10 and frame.size() == 11 and word_at(frame, 7) == which.number)
                          : function == 0x03 and word_at(frame, 4) == which.number;
}

std::string due_text(told_request const& which)
{
    if (which.is_write) {
        return "ok";
    }
    std::string text;
    for (unsigned i = 0; i < which.number; ++i) {
        text += (i > 0 ? " " : "") + std::to_string(value_of(which.address + i));
    }
    return text;
}

enum class client_result { right, wrong, error };

client_result result_of(client_run const& run, std::size_t request)
{
    if (request >= run.printed.size() or run.printed[request].text.starts_with("error")) {
        return client_result::error;
    }
    std::string const& printed = run.printed[request].text;
    std::string const due = due_text(run.told[request]);
    bool const is_right = due == "ok" ? printed.starts_with("ok") : words_of(printed) == words_of(due);
    return is_right ? client_result::right : client_result::wrong;
}

std::size_t count_of(client_run const& run, std::size_t request)
{
    return static_cast<std::size_t>(std::ranges::count(run.requests, request, &client_request::which));
}

std::string shortened(std::string const& text)
{
    constexpr std::size_t most = 60;
    return text.size() > most ? text.substr(0, most) + "..." : text;
}

/// The first of them: a client may ask without end.
std::string list_text(std::vector<line_time> const& times)
{
    constexpr std::size_t most = 8;
    std::string text;
    for (std::size_t i = 0; i < std::min(times.size(), most); ++i) {
        text += (i > 0 ? ", " : "") + ms_text(times[i]);
    }
    return text + (times.size() > most ? " and " + std::to_string(times.size() - most) + " more" : std::string{});
}

line_time between(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point until)
{
    return std::chrono::duration_cast<line_time>(until - from);
}

judgement client_fails(std::string why) { return {verdict::fails, std::move(why), {}}; }
judgement client_not_tried(std::string why) { return {verdict::not_tried, std::move(why), {}}; }
/// What another clause is for.
judgement client_hidden(std::string why) { return {verdict::not_tried, std::move(why), {}, true}; }

/// "any / right" of "any / right; waits T".
std::string_view results_in(clause const& which) { return which.applies.substr(0, which.applies.find(';')); }

/// "waits T"; empty where there is none.
std::string_view rule_in(clause const& which)
{
    std::size_t const at = which.applies.find("; ");
    return at == which.applies.npos ? std::string_view{} : which.applies.substr(at + 2);
}

} // namespace

checked_client::checked_client(served_port& port, exchange_log& log, rtuwire::line_timing const& wire,
                               std::uint8_t unit, client_call const& call)
    : port_{port}, log_{log}, wire_{wire}, call_{call}
{
    where_.unit = unit;
    where_.other = unit == 247 ? 246 : static_cast<std::uint8_t>(unit + 1);
}

void checked_client::begin()
{
    heard_.clear();
    due_.clear();
    last_said_.reset();
}

void checked_client::send_due(client_run& run)
{
    for (auto next = due_.begin(); next != due_.end() and next->at <= clock::now(); next = due_.begin()) {
        due_bytes const now = std::move(*next);
        due_.erase(next);
        if (now.bytes.empty()) {
            continue;
        }
        // Reckoned from before it was written: a silence behind it is measured too long, never too short.
        auto const began = clock::now();
        if (not port_.write(now.bytes, any_port::now() + rtuwire::milliseconds(1'000))) {
            due_.clear(); // nobody reads: what is due is lost, as on a wire, and nothing waits for it
            return;
        }
        last_said_ = began + (port_.has_wire() ? rtuwire::to_chrono(wire_.characters(now.bytes.size())) : line_time{0});
        run.passed.push_back({began, true, now.bytes});
        log_.take({.bytes = now.bytes, .at = any_port::now(), .role = rtuwire::frame_role::response, .is_own = true});
    }
}

void checked_client::take(line_bytes frame, answering const& answer, client_run& run)
{
    client_request request{first_byte_, std::move(frame), not_told,
                           last_said_ ? between(*last_said_, first_byte_) : line_time::max()};
    for (std::size_t i = 0; i < run.told.size() and request.which == not_told; ++i) {
        request.which = asks(request.frame, run.told[i]) ? i : not_told;
    }
    run.passed.push_back({last_byte_, false, request.frame});
    log_.take({.bytes = request.frame, .at = any_port::now(), .role = rtuwire::frame_role::request, .is_own = false});
    run.requests.push_back(request);
    std::string const words = answer(request);
    if (words.empty()) {
        return;
    }
    // A wire wants a silence before the answer, too.
    auto at = last_byte_ + (port_.has_wire() ? rtuwire::to_chrono(wire_.t3_5()) : line_time{0});
    for (sent_piece const& each : pieces_of(words, where_)) {
        double const characters = each.characters * static_cast<double>(wire_.characters(1).microseconds);
        at += line_time{static_cast<std::int64_t>(characters) + 1'000 * std::int64_t{each.ms}};
        auto const behind = std::ranges::find_if(due_, [at](due_bytes const& other) { return other.at > at; });
        due_.insert(behind, {at, each.bytes});
    }
}

void checked_client::hear(rtuwire::byte_view bytes, answering const& answer, client_run& run)
{
    auto const now = clock::now();
    first_byte_ = heard_.empty() ? now : first_byte_;
    last_byte_ = now;
    heard_.insert(heard_.end(), bytes.begin(), bytes.end());
    for (auto size = request_size(heard_); size and heard_.size() >= *size; size = request_size(heard_)) {
        auto const end = heard_.begin() + static_cast<std::ptrdiff_t>(*size);
        line_bytes frame{heard_.begin(), end};
        heard_.erase(heard_.begin(), end);
        take(std::move(frame), answer, run);
        first_byte_ = now;
    }
}

void checked_client::pass(clock::time_point until, answering const& answer, client_run& run)
{
    std::array<std::byte, 1'024> place;
    auto const end = due_.empty() ? until : std::min(until, due_.front().at);
    line_time const left = std::max(between(clock::now(), end), line_time{0});
    rtuwire::byte_span const came = port_.read(place, any_port::now() + rtuwire::to_duration(left));
    if (not came.empty()) {
        hear(came, answer, run);
    } else if (not heard_.empty() and clock::now() - last_byte_ > end_of_request) {
        take(std::exchange(heard_, {}), answer, run); // what is no request of these
    }
    send_due(run);
}

std::string checked_client::answer_to(client_request const& request, std::string_view answered, client_run const& run)
{
    if (request.which == not_told) {
        return {};
    }
    std::size_t const times = count_of(run, request.which);
    std::vector<std::string_view> const turns = parts_of(parts_of(answered, " / ")[request.which], " then ");
    std::string_view text = turns[std::min(times, turns.size()) - 1];
    if (text.starts_with("LAST ")) {
        text = times < times_sent() ? std::string_view{"-"} : text.substr(5);
    }
    std::string words;
    for (std::string const& each : text == "-" ? std::vector<std::string>{} : words_of(text)) {
        words += plain_words(each, request.frame, call_.timeout) + " ";
    }
    return words;
}

line_time checked_client::limit(std::size_t requests) const
{
    auto const count = static_cast<std::int64_t>(requests);
    return hangs_ ? 2 * count * call_.timeout + line_time{2'000'000} : start_time + 11 * count * call_.timeout;
}

client_run checked_client::run_by(std::string_view asked, std::string_view answered)
{
    client_run run;
    run.told = requests_told(asked, where_.unit);
    port_.renew();
    begin();
    std::vector<std::string> words = call_.command;
    words.push_back(call_.port.empty() ? port_.name() : call_.port);
    words.push_back(std::to_string(call_.timeout.count() / 1'000));
    for (told_request const& each : run.told) {
        std::vector<std::string> const more = words_of(each);
        words.insert(words.end(), more.begin(), more.end());
    }
    auto const answer = [&](client_request const& request) { return answer_to(request, answered, run); };
    client_process process{words};
    auto const give_up = clock::now() + limit(run.told.size());
    bool is_running = true;
    while (is_running and clock::now() < give_up and noted_signal() == 0) {
        pass(clock::now() + look_step, answer, run);
        is_running = process.look();
    }
    pass(clock::now(), answer, run); // what it sent last
    run.has_ended = not is_running;
    run.took = run.requests.empty() ? line_time{0} : between(run.requests.front().at, clock::now());
    run.printed = process.printed();
    std::string const last = process.last_complaint(), end = process.end();
    run.end =
        end.empty() ? std::string{} : "the client " + end + (last.empty() ? "" : ", and said: " + shortened(last));
    return run;
}

client_run const& checked_client::known_run(std::string_view asked, std::string_view answered)
{
    std::string const key = std::string{asked} + '\n' + std::string{answered};
    auto const known = known_.find(key);
    return known != known_.end() ? known->second : known_.emplace(key, run_by(asked, answered)).first->second;
}

std::size_t checked_client::times_sent()
{
    // Behind it: a run inside of a run would have the line to itself.
    auto const known = known_.find("read U 100 2\n-");
    return known == known_.end() or not known->second.has_ended ? 0 : count_of(known->second, 0);
}

bool checked_client::is_usable() { return result_of(known_run("read U 100 2", "GOOD"), 0) == client_result::right; }

/// Of a run that was cut, or did not get to all of its requests.
judgement checked_client::without_result(client_run const& run)
{
    if (not run.has_ended) {
        return client_hidden("the client did not end: clause K11");
    }
    for (std::size_t i = 1; i < run.told.size(); ++i) {
        if (count_of(run, i) == 0) {
            std::string const why = "the client did not send request " + std::to_string(i + 1) + " (" +
                                    text_of(run.told[i]) + ") behind the one before" +
                                    (run.end.empty() ? "" : ": " + run.end);
            client_run const& behind_silence = known_run("read U 100 2 / read U 300 2", "- / GOOD"); // clause K70
            bool const is_seen = &behind_silence == &run or count_of(behind_silence, 1) > 0;
            return is_seen ? client_fails(why) : client_hidden(why + "; it ends at its first error: clause K70");
        }
    }
    return {};
}

judgement checked_client::judged_results(clause const& which, client_run const& run)
{
    std::vector<std::string_view> const due = parts_of(results_in(which), " / ");
    judgement const cut = without_result(run);
    for (std::size_t i = 0; i < due.size(); ++i) {
        client_result const result = result_of(run, i);
        bool const is_due = due[i] == "any" or (result == client_result::right and due[i] != "error") or
                            (result == client_result::error and due[i] != "right");
        if (is_due and (result != client_result::right or count_of(run, i) > 0)) {
            continue;
        }
        if (is_due) {
            return client_fails("request " + std::to_string(i + 1) + " (" + text_of(run.told[i]) + "): '" +
                                shortened(run.printed[i].text) + "' was printed, and no such request came");
        }
        bool const is_printed = i < run.printed.size();
        if (not is_printed and cut.how != verdict::holds and which.id != "K01") {
            return cut;
        }
        std::string const wanted = due[i] == "error" ? "an error" : due_text(run.told[i]);
        return client_fails("request " + std::to_string(i + 1) + " (" + text_of(run.told[i]) +
                            "): " + (is_printed ? "'" + shortened(run.printed[i].text) + "' was" : "nothing was") +
                            " printed, " + shortened(wanted) + " is due" + (run.end.empty() ? "" : "; " + run.end));
    }
    return cut;
}

judgement checked_client::judged_requests(std::string_view rule, client_run const& run) const
{
    std::size_t const times = count_of(run, 0);
    if (run.requests.empty()) {
        return client_not_tried("no request came" + (run.end.empty() ? "" : ": " + run.end));
    }
    if (rule == "ends") {
        return run.has_ended ? judgement{}
                             : client_fails("it still ran " + ms_text(run.took) +
                                            " behind its first request; the time-out is " + ms_text(call_.timeout));
    }
    if (rule == "repeated" or rule == "not repeated") {
        bool const is_repeated = times > 1;
        return is_repeated == (rule == "repeated")
                   ? judgement{}
                   : client_fails("it was sent " + std::to_string(times) + (times == 1 ? " time" : " times"));
    }
    std::vector<line_time> all;
    line_time least = line_time::max();
    bool const is_of_answers = rule == "waits t3.5";
    for (std::size_t i = 1; i < run.requests.size(); ++i) {
        line_time const gap =
            is_of_answers ? run.requests[i].silence : between(run.requests[i - 1].at, run.requests[i].at);
        all.push_back(gap);
        least = std::min(least, gap);
    }
    std::string const gaps = list_text(all);
    if (rule == "told") {
        return {verdict::told,
                "sent " + std::to_string(times) + (times == 1 ? " time" : " times") +
                    (gaps.empty() ? "" : ", " + gaps + " apart") + "; ended " + ms_text(run.took) + " behind the first",
                {}};
    }
    if (is_of_answers) {
        line_time const due = rtuwire::to_chrono(wire_.t3_5());
        return port_.is_network()        ? client_not_tried("a network has no silences between frames")
               : run.requests.size() < 2 ? client_not_tried("the client sent one request only")
               : least < due
                   ? client_fails("requests began " + gaps + " behind the answer; " + ms_text(due) + " is due")
                   : judgement{};
    }
    bool const is_timeout = rule == "waits T";
    std::string given_up;
    if (is_timeout and not run.printed.empty()) {
        line_time const gap = between(run.requests.back().at, run.printed.front().at);
        given_up = "given up " + ms_text(gap) + " behind the last request";
        least = std::min(least, gap);
    }
    line_time const due = is_timeout ? call_.timeout * 9 / 10 : turnaround;
    std::string const seen = gaps.empty() ? "" : "requests came " + gaps + " apart";
    return least >= due ? judgement{}
                        : client_fails(seen + (seen.empty() or given_up.empty() ? "" : ", ") + given_up + "; " +
                                       ms_text(is_timeout ? call_.timeout : due) + " are due");
}

judgement checked_client::judged_by_command(clause const& which)
{
    if (which.id != "K01" and not is_usable()) {
        return client_hidden("clause K01 fails: the client does not read a register");
    }
    bool const needs_times = which.needs == "repeats" or which.comes.starts_with("LAST");
    if (needs_times) {
        static_cast<void>(known_run("read U 100 2", "-"));
        if (times_sent() == 0) {
            return client_hidden("the client did not end: clause K11");
        }
        if (which.needs == "repeats" and times_sent() == 1) {
            return {verdict::does_not_apply, "the client repeats no read", {}};
        }
    }
    judgement found;
    std::string_view const rule = rule_in(which);
    for (std::string_view const answered : parts_of(which.comes, " | ")) {
        client_run const& run = known_run(which.sends, answered);
        hangs_ = hangs_ or (which.id == "K11" and not run.has_ended);
        found = rule == "ends" and not run.has_ended ? judged_requests(rule, run) : judged_results(which, run);
        found = found.how == verdict::holds and not rule.empty() ? judged_requests(rule, run) : found;
        found.passed = run.passed;
        if (found.how != verdict::holds) {
            found.why += which.comes.find(" | ") == which.comes.npos ? "" : "; answered was " + std::string{answered};
            return found;
        }
    }
    return found;
}

judgement checked_client::judged_by_line(clause const& which)
{
    std::string_view const rule = rule_in(which), results = results_in(which);
    bool const is_recovery = rule.empty() and results == "any / right"; // that it goes on
    bool const is_seen = rule == "ends" or rule == "waits T" or rule == "waits t3.5" or is_recovery;
    if (not is_seen or which.sends.starts_with("write")) {
        return client_not_tried("without the client's command (behind --) only its requests are seen");
    }
    // One that is answered well, the one of the clause, and what comes behind.
    std::string_view const first = parts_of(which.comes, " / ").front();
    std::size_t const wanted = rule == "waits t3.5" ? 6 : 3;
    client_run run;
    begin();
    auto const answer = [&](client_request const& request) {
        bool const is_ours = request.frame.size() >= shortest_request and has_right_crc(request.frame) and
                             request.frame[0] == std::byte{where_.unit};
        if (not is_ours) {
            run.requests.pop_back();
            return std::string{};
        }
        run.requests.back().which = 0;
        std::string_view const text = run.requests.size() == 2 ? first : "GOOD";
        std::string words;
        for (std::string const& each : text == "-" ? std::vector<std::string>{} : words_of(text)) {
            words += plain_words(each, request.frame, call_.timeout) + " ";
        }
        return words;
    };
    for (auto end = clock::now() + wait_for_request;
         run.requests.size() < wanted and clock::now() < end and noted_signal() == 0;) {
        std::size_t const before = run.requests.size();
        pass(std::min(end, clock::now() + line_time{100'000}), answer, run);
        end = run.requests.size() > before ? clock::now() + wait_for_request : end;
    }
    judgement found;
    if (run.requests.size() < 2) {
        found = client_not_tried("no request to unit " + std::to_string(where_.unit) + " came within 30 s");
    } else if (run.requests.size() < wanted and rule != "waits T") {
        found = client_fails("no request came within 30 s behind it");
    } else if (rule == "waits T" or rule == "waits t3.5") {
        run.requests.erase(run.requests.begin()); // the known state
        if (rule == "waits T") {
            run.requests.resize(std::min<std::size_t>(run.requests.size(), 2), run.requests.front());
        }
        found = judged_requests(rule, run);
    }
    found.passed = run.passed;
    return found;
}

judgement checked_client::judged(clause const& which)
{
    if (call_.command.empty()) {
        return judged_by_line(which);
    }
    // Where time is part of a clause, what fails once of three times is told, and holds. A silence is never measured too short.
    bool const is_timed = which.comes.find('~') != which.comes.npos or which.comes == "EACH" or
                          which.comes == "SPLIT" or rule_in(which) == "waits T" or rule_in(which) == "waits 50 ms";
    judgement found = judged_by_command(which);
    std::string const first = found.why;
    for (unsigned turn = 1; is_timed and turn < most_tries and found.how == verdict::fails and noted_signal() == 0;
         ++turn) {
        for (std::string_view const answered : parts_of(which.comes, " | ")) {
            known_.erase(std::string{which.sends} + '\n' + std::string{answered});
        }
        found = judged_by_command(which);
    }
    if (is_timed and found.how == verdict::holds and not first.empty()) {
        found.why = "not at once: " + first;
    }
    return found;
}

} // namespace tool
