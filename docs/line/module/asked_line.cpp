// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "asked_line.hpp"

#include <algorithm>
#include <cstdlib>
#include <type_traits>
#include <utility>

#include "frame/damage.hpp"
#include "frame/hex_text.hpp"
#include "frame/summary.hpp"
#include "read_gate.hpp"

namespace line_page {

namespace {

using rtuwire::byte_view;

constexpr microseconds listen_time = 1'000'000;
constexpr microseconds longest_pass = 250'000;
constexpr microseconds told_as_slowed = 1'500'000;
constexpr microseconds longest_late = 5'000'000;    // behind a time-out, for an answer that was given up
constexpr std::size_t most_stray = 3;               // bytes, as an adapter makes them when its port is opened
constexpr std::size_t largest_capture = 16'000'000; // bytes; later frames are not kept

bool are_same(byte_view left, byte_view right) { return std::ranges::equal(left, right); }

rtuwire::line_timing timing_of(line_setting how) { return rtuwire::line_timing::usb(how.baud, how.format); }

std::string_view name_of(phase which)
{
    switch (which) {
    case phase::listening: return "listening";
    case phase::quiet: return "quiet";
    case phase::others: return "others";
    case phase::noise: return "noise";
    }
    return "";
}

template <typename Response> std::vector<std::uint16_t> words_of(Response const& response)
{
    std::vector<std::uint16_t> words;
    if constexpr (requires { response.registers; }) {
        for (std::size_t i = 0; i < response.registers.size(); ++i) {
            words.push_back(response.registers[i]);
        }
    } else if constexpr (requires { response.values; }) {
        for (std::size_t i = 0; i < response.values.size(); ++i) {
            words.push_back(response.values[i] ? 1 : 0);
        }
    }
    return words;
}

} // namespace

asked_line::asked_line(line_setting how, microseconds now, microseconds unix_time)
    : client_{timing_of(how), options()}, listener_{timing_of(how), rtuwire::milliseconds(1'200)}, how_{how}, now_{now},
      calendar_ahead_{unix_time - now}, listens_until_{now + listen_time}
{
    byte_view const head = blocks_.begin({.bits_per_second = how.baud}, {unix_time, instant_of(now)});
    capture_.assign(head.begin(), head.end());
    client_.advance(instant_of(now));
}

void asked_line::set(line_setting how, microseconds now)
{
    stop("set anew");
    how_ = how;
    is_drive_.fill(false); // at another bit rate others may answer
    has_consent_.fill(false);
    client_ = client{timing_of(how), options()};
    client_.advance(instant_of(now));
    listener_ = rtuwire::line_listener{timing_of(how), rtuwire::milliseconds(1'200)};
    leaving_.clear();
    owed_.clear(); // what comes at the bit rate before is no frame now
    if (phase_ != phase::quiet) {
        listen();
    }
}

rtuwire::client_options asked_line::options() noexcept { return {.retries = 0}; }

void asked_line::receive(byte_view bytes, microseconds now)
{
    now_ = now;
    std::size_t const room = rtuwire::max_adu_size - std::min(received_.size(), rtuwire::max_adu_size);
    byte_view const kept = bytes.first(std::min(bytes.size(), room));
    received_.insert(received_.end(), kept.begin(), kept.end());
    heard_bytes_ += bytes.size();
    client_.receive(bytes, instant_of(now));
    listener_.receive(bytes, instant_of(now), [this](auto const& heard) { take(heard); });
}

void asked_line::receive_error(microseconds now)
{
    now_ = now;
    ++heard_bytes_;
    client_.receive_error(instant_of(now));
    listener_.receive_error(instant_of(now), [this](auto const& heard) { take(heard); });
}

void asked_line::sent(microseconds now)
{
    now_ = now;
    if (leaving_.empty()) {
        return;
    }
    last_sent_ = std::exchange(leaving_, {});
    // The port has the bytes; they are on the wire for as long as they take there.
    microseconds const on_wire = timing_of(how_).characters(last_sent_.size()).microseconds;
    client_.sent(instant_of(std::max(now, left_at_ + on_wire)));
    if (not client_.has_seen_echo()) { // else the line itself tells the listener
        listener_.receive(last_sent_, instant_of(now), [this](auto const& heard) { take(heard); });
    }
}

byte_view asked_line::pass(microseconds now)
{
    if (now - now_ > told_as_slowed and (is_busy() or phase_ == phase::listening)) {
        tell("slowed", [&](json_text& out) { out.put("milliseconds", (now - now_) / 1000); });
        if (phase_ == phase::listening) {
            listens_until_ = now + listen_time; // nobody listened meanwhile
        }
    }
    now_ = now;
    blocks_.advance(instant_of(now), now + calendar_ahead_);
    client_.advance(instant_of(now));
    listener_.advance(instant_of(now), [this](auto const& heard) { take(heard); });
    keep_listening();
    resume();
    visit();
    if (not leaving_.empty()) {
        return {};
    }
    byte_view const frame = client_.poll_transmit();
    if (frame.empty()) {
        return {};
    }
    if (not is_read(frame)) {
        std::abort(); // a defect: the page stops, and nothing leaves
    }
    if (not may_leave(frame)) {
        client_.cancel(instant_of(now));
        return {};
    }
    leaving_.assign(frame.begin(), frame.end());
    is_sent_ = true;
    left_at_ = now;
    return leaving_;
}

bool asked_line::may_leave(byte_view frame) const noexcept
{
    return phase_ == phase::quiet and may_poll(std::to_integer<std::uint8_t>(frame[0]));
}

microseconds asked_line::time_left() const noexcept
{
    microseconds left = longest_pass;
    auto const note = [&](microseconds until) { left = std::min(left, until > now_ ? until - now_ : 0); };
    rtuwire::instant const now = instant_of(now_);
    auto const note_deadline = [&](rtuwire::deadline const& next) {
        if (next) {
            note(reached(now, *next) ? now_ : now_ + (*next - now).microseconds);
        }
    };
    note_deadline(client_.poll_deadline());
    note_deadline(listener_.poll_deadline());
    if (phase_ == phase::listening) {
        note(listens_until_);
    }
    if (waiting_ and wakes_at_ != 0) {
        note(wakes_at_);
    }
    return left;
}

void asked_line::listen()
{
    stop("listens again");
    listens_until_ = now_ + listen_time;
    heard_bytes_ = heard_frames_ = 0;
    change_phase(phase::listening);
}

void asked_line::change_phase(line_page::phase to)
{
    phase_ = to;
    tell("phase", [&](json_text& out) {
        out.put("phase", name_of(to));
        out.put("bytes", heard_bytes_);
        out.put("frames", heard_frames_);
    });
}

void asked_line::keep_listening()
{
    if (phase_ != phase::listening or now_ < listens_until_) {
        return;
    }
    change_phase(heard_frames_ > 0 ? phase::others : heard_bytes_ > most_stray ? phase::noise : phase::quiet);
}

/// Another client on the line: this one ends what it does.
void asked_line::note_others()
{
    if (phase_ == phase::quiet) {
        stop("another client is on the line");
        client_.cancel(instant_of(now_));
        change_phase(phase::others);
    }
}

void asked_line::take(rtuwire::heard_frame const& heard)
{
    bool const is_request = heard.frame.role == rtuwire::frame_role::request and not heard.is_unanswered;
    bool const is_own = is_request and are_same(heard.frame.bytes, last_sent_);
    bool const is_good = heard.frame.verdict == rtuwire::frame_verdict::good and not heard.is_unanswered;
    frames_.add({.begin_us = now_ - (instant_of(now_) - heard.first_byte).microseconds,
                 .end_us = now_ - (instant_of(now_) - heard.frame.at).microseconds,
                 .from = not is_request ? playground::sender::drive
                         : is_own       ? playground::sender::client
                                        : playground::sender::person,
                 .is_damaged = heard.frame.verdict == rtuwire::frame_verdict::damaged,
                 .is_unanswered = heard.is_unanswered,
                 .is_exception = heard.is_exception(),
                 .bytes = {heard.frame.bytes.begin(), heard.frame.bytes.end()},
                 .request = {heard.request.begin(), heard.request.end()},
                 .summary = tool::summary_of(heard, names_[heard.unit()])});
    if (not heard.is_unanswered and capture_.size() < largest_capture) {
        auto frame = heard.frame;
        frame.is_own = is_own;
        byte_view const block = blocks_.packet(frame);
        capture_.insert(capture_.end(), block.begin(), block.end());
    } else if (not heard.is_unanswered and not std::exchange(is_capture_full_, true)) {
        tell("full", [](json_text&) {});
    }
    if (is_good and not is_request) { // the one that was given up, where it is of its form
        auto const part = [&](std::size_t at) { return std::to_integer<std::uint8_t>(heard.frame.bytes[at]); };
        auto const late = std::ranges::find(owed_, response_form{part(0), part(1), part(2)}, &owed_response::form);
        if (late != owed_.end()) {
            owed_.erase(late);
        }
    }
    heard_frames_ += is_good and not is_own ? 1U : 0U;
    if (is_request and is_good and not is_own) {
        note_others();
    }
}

void asked_line::run(std::string_view name, steps what)
{
    if (is_busy()) {
        stop("another was begun");
    }
    waiting_ = {};
    job_name_ = name;
    if (phase_ != phase::quiet) {
        tell("end", [&](json_text& out) {
            out.put("job", job_name_);
            out.put("how", "not begun");
        });
        return;
    }
    tell("begin", [&](json_text& out) { out.put("job", job_name_); });
    job_ = std::move(what);
    is_told_ended_ = false;
    job_.begin();
    note_end();
}

void asked_line::note_end()
{
    if (job_.is_over() and not std::exchange(is_told_ended_, true)) {
        job_ = {};
        tell("end", [&](json_text& out) {
            out.put("job", job_name_);
            out.put("how", "done");
        });
    }
}

void asked_line::stop(std::string_view why)
{
    if (is_busy()) {
        note_owed();
        client_.cancel(instant_of(now_));
        read_.emplace<std::monostate>();
        waiting_ = {};
        job_ = {};
        is_told_ended_ = true;
        tell("end", [&](json_text& out) {
            out.put("job", job_name_);
            out.put("how", why);
        });
    }
}

/// The answer to the request under way may come when nobody waits for it.
void asked_line::note_owed()
{
    if (std::exchange(is_sent_, false) and not std::holds_alternative<std::monostate>(read_) and form_.size != 0) {
        owed_.push_back({form_, now_ + longest_late});
    }
}

void asked_line::begin(any_read read, response_form form, std::coroutine_handle<> who)
{
    std::uint8_t const unit = form.unit;
    read_ = std::move(read);
    form_ = form;
    waiting_ = who;
    wakes_at_ = 0;
    received_.clear();
    is_answer_ready_ = is_sent_ = false;
    std::erase_if(owed_, [&](owed_response const& each) { return each.until <= now_; });
    for (owed_response const& each : owed_) {
        auto const whom = rtuwire::unit_id::checked(unit);
        if (whom and each.form == form) { // which nobody could tell from the answer to this request
            client_.hold(*whom, instant_of(each.until));
            tell("held", [&](json_text& out) {
                out.put("unit", unit);
                out.put("milliseconds", (each.until - now_) / 1000);
            });
        }
    }
    if (std::holds_alternative<std::monostate>(read_) or not may_poll(unit)) {
        answer_ = {.why = rtuwire::errc::invalid_function};
        read_.emplace<std::monostate>();
        is_answer_ready_ = true;
    }
}

/// Gives the line to the request under way.
void asked_line::visit()
{
    std::visit(
        [&]<typename Read>(Read& read) {
            if constexpr (not std::same_as<Read, std::monostate>) {
                client_.converse(read, instant_of(now_), {.response_timeout = timeout_, .retries = 0});
                if (read.settled()) {
                    auto const outcome = read.outcome();
                    settle(outcome);
                    if (outcome) {
                        if (auto const response = outcome->template to<typename Read::request_type>()) {
                            answer_.words = words_of(*response);
                        }
                    }
                    read_.template emplace<std::monostate>();
                    is_answer_ready_ = true;
                }
            }
        },
        read_);
    if (is_answer_ready_) {
        resume();
    }
}

void asked_line::settle(rtuwire::result<rtuwire::response> const& outcome)
{
    answer_ = {.why = outcome.error()};
    bool const has_echo = client_.has_seen_echo() and received_.size() >= last_sent_.size();
    byte_view const came = byte_view{received_}.subspan(has_echo ? last_sent_.size() : 0);
    auto const part = [&](std::size_t at) { return std::to_integer<std::uint8_t>(came[at]); };
    // What begins as the response does is the response, with bytes lost, where nobody else's is due.
    bool const has_begun = came.size() > 1 and part(0) == form_.unit and (part(1) & 0x7FU) == form_.function and
                           std::ranges::none_of(owed_, [&](auto const& each) { return each.form.unit == form_.unit; });
    if (not answer_.is_there() and not has_begun and answer_.why != rtuwire::errc::crc_mismatch and
        answer_.why != rtuwire::errc::line_echo) {
        note_owed();
    }
    if (outcome) {
        byte_view const pdu = outcome->pdu();
        answer_.pdu.assign(pdu.begin(), pdu.end());
    } else if (answer_.why == rtuwire::errc::timed_out) { // of another unit, or of none
        answer_.bytes = tool::hex_of(came);
    } else if (auto const refused = client_.refused()) {
        answer_.bytes = tool::hex_of(refused->bytes);
        answer_.cause = answer_.why == rtuwire::errc::wrong_length
                            ? std::string{}
                            : tool::cause_of_damage(refused->bytes, refused->asked);
    }
}

void asked_line::resume()
{
    bool const is_time = waiting_ and wakes_at_ != 0 and now_ >= wakes_at_;
    if (not is_time and not is_answer_ready_) {
        return;
    }
    is_answer_ready_ = false;
    wakes_at_ = 0;
    if (auto const who = std::exchange(waiting_, {})) {
        who.resume();
        note_end();
    }
}

asked_line::waiting_for_answer asked_line::ask(std::uint8_t unit, std::uint8_t function, std::uint16_t start,
                                               std::uint16_t count)
{
    any_read read;
    if (auto const whom = rtuwire::unit_id::checked(unit)) {
        switch (function) {
        case 1: read.emplace<1>(*whom, rtuwire::read_coils{.start = start, .count = count}); break;
        case 2: read.emplace<2>(*whom, rtuwire::read_discrete_inputs{.start = start, .count = count}); break;
        case 3: read.emplace<3>(*whom, rtuwire::read_holding_registers{.start = start, .count = count}); break;
        case 4: read.emplace<4>(*whom, rtuwire::read_input_registers{.start = start, .count = count}); break;
        default: break;
        }
    }
    std::size_t const size = function <= 2 ? (std::size_t{count} + 7) / 8 : std::size_t{2} * count;
    return {*this, std::move(read), {unit, function, static_cast<std::uint8_t>(size)}};
}

asked_line::waiting_for_answer asked_line::ask_identity(std::uint8_t unit, std::uint8_t object)
{
    any_read read;
    if (auto const whom = rtuwire::unit_id::checked(unit)) {
        read.emplace<5>(*whom, rtuwire::read_device_identification{rtuwire::identification_access::basic, object});
    }
    return {*this, std::move(read), {unit, 43, 0}};
}

void asked_line::tell_failure(std::uint8_t unit, std::string_view what, answer const& failed)
{
    tell("failure", [&](json_text& out) {
        out.put("unit", unit);
        out.put("what", what);
        out.put("error", static_cast<unsigned>(failed.why));
        out.put("name", std::string_view{rtuwire::name(failed.why)});
        out.put("bytes", failed.bytes);
        out.put("cause", failed.cause);
    });
}

json_text asked_line::begin_event(std::string_view event) const
{
    json_text out;
    out.open_object();
    out.put("event", event);
    out.put("time", now_);
    return out;
}

void asked_line::end_event(json_text& out)
{
    out.close_object();
    events_.append(events_.empty() ? "" : ",").append(out.text());
}

std::string asked_line::take_events()
{
    std::string text = "[" + events_ + "]";
    events_.clear();
    return text;
}

} // namespace line_page
