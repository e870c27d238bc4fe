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
    if (phase_ != phase::quiet) {
        listen();
    }
}

rtuwire::client_options asked_line::options() noexcept { return {.retries = 0}; }

void asked_line::receive(byte_view bytes, microseconds now)
{
    now_ = now;
    received_ += bytes.size();
    heard_bytes_ += bytes.size();
    client_.receive(bytes, instant_of(now));
    listener_.receive(bytes, instant_of(now), [this](auto const& heard) { take(heard); });
}

void asked_line::receive_error(microseconds now)
{
    now_ = now;
    ++received_;
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
    has_foreign_frame_ = false;
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
    job_.begin();
}

void asked_line::stop(std::string_view why)
{
    if (is_busy()) {
        client_.cancel(instant_of(now_));
        read_.emplace<std::monostate>();
        waiting_ = {};
        job_ = {};
        tell("end", [&](json_text& out) {
            out.put("job", job_name_);
            out.put("how", why);
        });
    }
}

void asked_line::begin(any_read read, std::uint8_t unit, std::coroutine_handle<> who)
{
    read_ = std::move(read);
    unit_ = unit;
    waiting_ = who;
    wakes_at_ = 0;
    received_ = 0;
    is_answer_ready_ = false;
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
    answer_ = {.why = outcome.error(), .is_heard = received_ > 0};
    if (outcome) {
        byte_view const pdu = outcome->pdu();
        answer_.pdu.assign(pdu.begin(), pdu.end());
    } else if (auto const refused = client_.refused(); refused and answer_.why != rtuwire::errc::timed_out) {
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
        if (job_.is_over()) {
            job_ = {};
            tell("end", [&](json_text& out) {
                out.put("job", job_name_);
                out.put("how", "done");
            });
        }
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
    return {*this, std::move(read), unit};
}

asked_line::waiting_for_answer asked_line::ask_identity(std::uint8_t unit, std::uint8_t object)
{
    any_read read;
    if (auto const whom = rtuwire::unit_id::checked(unit)) {
        read.emplace<5>(*whom, rtuwire::read_device_identification{rtuwire::identification_access::basic, object});
    }
    return {*this, std::move(read), unit};
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

std::string asked_line::take_events()
{
    std::string text = "[" + events_ + "]";
    events_.clear();
    return text;
}

} // namespace line_page
