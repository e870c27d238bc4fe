// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/open_line.hpp"

#include <algorithm>
#include <array>
#include <atomic>

#include "../support/platform.hpp"
#include "frame/damage.hpp"
#include "frame/hex_text.hpp"
#include "line/line_words.hpp"
#include "line/traffic.hpp"
#include "output/passing_text.hpp"
#include "port/port_word.hpp"

namespace tool {

namespace {

std::string hex_byte(std::uint8_t byte)
{
    constexpr char digits[] = "0123456789ABCDEF";
    return {digits[byte >> 4U], digits[byte & 0xFU]};
}

/// Said to a person, once.
void tell_of_supervision()
{
    static std::atomic<bool> is_told{false};
    if (not is_told.exchange(true) and is_terminal(STDERR_FILENO)) {
        tell_at_once(
            "note: any request restarts a drive's supervision of its line, and begins it where the drive is idle\n");
    }
}

/// No response of the unit.
bool is_lost(rtuwire::errc why)
{
    return why != rtuwire::errc::none and not is_refusal_of_unit(why) and status_of(why) != exit_status::port;
}

any_port traced_port(line_choices const& chosen, line_setting const& how)
{
    exchange_log::open_file(chosen);
    return open_port(chosen, how);
}

rtuwire::client_options options_in(line_choices const& chosen, bool has_numbers)
{
    rtuwire::client_options options;
    options.response_timeout = seconds_in(chosen.response_timeout.value_or(1.0));
    options.late_response = seconds_in(chosen.late_response);
    options.retries = static_cast<std::uint8_t>(chosen.retries);
    // Over Modbus TCP nothing comes back but messages.
    options.has_line_echo = chosen.has_echo and not has_numbers;
    options.max_leading_noise = has_numbers ? std::uint8_t{0} : static_cast<std::uint8_t>(chosen.noise);
    return options;
}

} // namespace

any_port open_port(line_choices const& chosen, line_setting const& how)
{
    if (chosen.port.empty()) {
        refuse_word(std::string{"which line? say --port "} + example_port +
                    ", tcp://host:4001, mbap://host or sim:atv320:1" +
                    (chosen.typed.stray_port.empty() ? "" : "; did you mean -p " + chosen.typed.stray_port + "?"));
    }
    port_choice const which = read_port_word(chosen.port);
    if (which.refused) {
        refuse_word(which.refused->sentence);
    }
    if (auto const* const file = std::get_if<capture_file>(&which.port)) {
        refuse_word(file->path +
                    " is a capture, in which nobody answers: sniff, replay, timing and decode show what it holds");
    }
    if (chosen.must_switch_rs485 and not std::holds_alternative<serial_device>(which.port)) {
        refuse_word(option_words(chosen.typed.form, line_option::rs485) + ": " + chosen.port +
                    " is no serial device, whose driver could switch a transceiver");
    }
    any_port port;
    auto const opened = port.open(which.port, serial_settings_in(chosen, how));
    if (opened == rtuwire::errc::device_setting_refused) {
        throw setting_refused{exit_status::port, port.failure()};
    }
    if (not opened) {
        throw ended{exit_status::port, port.failure()};
    }
    port.keep_pause(rtuwire::milliseconds(chosen.pause));
    return port;
}

rtuwire::serial_settings serial_settings_in(line_choices const& chosen, line_setting const& how)
{
    rtuwire::serial_settings settings{.bits_per_second = how.baud, .format = how.format};
    settings.rs485 = chosen.must_switch_rs485 ? rtuwire::rs485_mode::required : rtuwire::rs485_mode::leave;
    return settings;
}

line_setting setting_in(line_choices const& line) { return {baud_in(line.baud), format_in(line.format)}; }

open_line::open_line(line_choices const& chosen, line_setting const& how)
    : port_{traced_port(chosen, how)}, form_{chosen.typed.form}, options_{options_in(chosen, port_.has_numbers())},
      exchange_{exchange_log::of(chosen, how, port_)}, client_{port_, port_.timing(), options_}
{
    client_.trace_to(exchange_);
    exchange_.owed().begin(options_, port_.has_numbers());
    // A server of Modbus TCP lets nobody hear what it says to others.
    if (not chosen.must_not_listen and not port_.is_simulated() and not port_.has_numbers()) {
        refuse_traffic(port_, seconds_in(chosen.listen), form_);
    }
    if (not port_.is_simulated()) {
        tell_of_supervision();
    }
}

void open_line::let_pass(std::chrono::microseconds time)
{
    std::array<std::byte, rtuwire::max_adu_size> place;
    auto const until = port_.now() + rtuwire::microseconds(static_cast<std::uint32_t>(time.count()));
    auto const heard = port_.read(place, until);
    if (not heard) {
        throw ended{exit_status::port, port_.failure()};
    }
    if (not heard->empty()) {
        exchange_.owed().note_unawaited(*heard);
    }
}

void open_line::begin_turn(earlier_turns* of)
{
    turns_ = of;
    if (of != nullptr) {
        of->next_ = 0;
        of->fresh_ = 0;
        of->has_asked_ = false;
        of->is_first_ = of->endings_.empty();
    }
}

earlier_turns::ending const* open_line::asked_before()
{
    if (turns_ == nullptr) {
        return nullptr;
    }
    std::vector<earlier_turns::ending> const& endings = turns_->endings_;
    if (turns_->next_ < endings.size()) {
        return &endings[turns_->next_++];
    }
    auto const is_same = [this](earlier_turns::ending const& each) {
        return each.request == request_ and request_.size() > 1 and not is_lost(each.why);
    };
    auto const same =
        std::find_if(endings.begin() + static_cast<std::ptrdiff_t>(turns_->fresh_), endings.end(), is_same);
    if (asks_in_turns() and same != endings.end()) {
        turns_->endings_.push_back(earlier_turns::ending{*same});
        turns_->next_ = endings.size();
        return &endings.back();
    }
    if (asks_in_turns() and turns_->has_asked_) {
        throw turn_is_over{};
    }
    return nullptr;
}

void open_line::ask_rest_at_once()
{
    if (asks_in_turns() and turns_->has_asked_) {
        throw turn_is_over{};
    }
    turns_ = nullptr;
}

void open_line::keep_for_later_turns(rtuwire::errc outcome, unsigned long sendings,
                                     std::chrono::duration<double, std::milli> took)
{
    std::size_t const which = turns_->endings_.size();
    bool const was_lost = is_lost(outcome) ? not turns_->lost_.insert(which).second : turns_->lost_.erase(which) > 0;
    if (is_lost(outcome) and not was_lost and not turns_->is_first_) {
        turns_->endings_.clear();
        throw turn_is_over{};
    }
    turns_->endings_.push_back(
        {request_, outcome, outcome == rtuwire::errc::none ? response_ : std::vector<std::byte>{}});
    turns_->next_ = turns_->endings_.size();
    turns_->has_asked_ = true;
    bool const was_missed = took >= rtuwire::to_chrono(options_.response_timeout);
    turns_->is_slow_ = turns_->is_slow_ or (sendings > 1 and was_missed);
}

void open_line::note(rtuwire::errc outcome, std::chrono::duration<double, std::milli> took)
{
    if (counts_ == nullptr) {
        return;
    }
    ++counts_->asked;
    bool const is_refused = rtuwire::is_exception(outcome);
    bool const is_silent = status_of(outcome) == exit_status::no_answer;
    counts_->refused += is_refused ? 1U : 0U;
    counts_->silent += is_silent ? 1U : 0U;
    counts_->damaged += outcome != rtuwire::errc::none and not is_refused and not is_silent ? 1U : 0U;
    if (outcome == rtuwire::errc::none or is_refused) {
        counts_->note_response(took.count());
    }
}

std::string open_line::words_of_failure(rtuwire::errc why) const
{
    using rtuwire::errc;
    if (status_of(why) == exit_status::port) {
        return port_.failure();
    }
    // Over Modbus TCP no CRC and no wires are to blame.
    bool const is_tcp = port_.has_numbers();
    std::string text = why == errc::wrong_length and is_tcp ? "wrong length" : words_of(why);
    if (why == errc::line_echo and is_tcp) {
        return "the request itself came back as its answer: what answers here gives back what it is sent";
    }
    std::string const no_echo =
        " (say " + option_words(form_, line_option::echo) + ", or switch the adapter's receiver off while it sends)";
    if (why == errc::line_echo) {
        return text + no_echo;
    }
    if (why == errc::timed_out) {
        bool const is_untold = client_.has_seen_echo() and not options_.has_line_echo and not is_tcp;
        return text + exchange_.owed().words_of_silence(form_) + port_.words_of_silence(form_) +
               (is_untold ? "; the line echoes" + no_echo : std::string{});
    }
    auto const refused = client_.refused();
    if (not refused) {
        return text;
    }
    rtuwire::byte_view const bytes = port_.passed(refused->bytes);
    if (why == errc::wrong_length) {
        text += ": the unit departs from the function's format: " + std::to_string(bytes.size()) + " bytes came";
        std::size_t const due = refused->due - std::min(refused->due, refused->bytes.size() - bytes.size());
        text += due == 0 ? "" : ", " + std::to_string(due) + " are due";
    } else {
        text += ": " + std::to_string(bytes.size()) + " bytes came";
    }
    std::string const cause =
        why == errc::wrong_length or is_tcp ? "" : cause_of_damage(refused->bytes, refused->asked, form_);
    return text + ": " + hex_of(bytes) + (cause.empty() ? "" : "; " + cause);
}

rtuwire::byte_view open_line::refused() const
{
    auto const refused = client_.refused();
    return refused ? rtuwire::byte_view{refused->bytes} : rtuwire::byte_view{};
}

exit_status status_of(rtuwire::errc why)
{
    using rtuwire::errc;
    if (why == errc::none) {
        return exit_status::done;
    }
    if (why >= errc::device_not_found and why <= errc::device_failed) {
        return exit_status::port;
    }
    // Whatever was heard is something else than silence: an exception, a damaged frame, another's response.
    bool const is_silence = why == errc::timed_out or why == errc::cancelled or why == errc::unit_lost;
    return is_silence ? exit_status::no_answer : exit_status::differs;
}

bool is_refusal_of_unit(rtuwire::errc why)
{
    using rtuwire::errc;
    return rtuwire::is_exception(why) and why != errc::gateway_path_unavailable and
           why != errc::gateway_target_failed_to_respond;
}

std::string words_of(rtuwire::errc why)
{
    std::string const text{rtuwire::name(why)};
    if (why == rtuwire::errc::unlisted_exception) {
        return "exception with code 0 or above 0x7E, which no specification lists";
    }
    if (not rtuwire::is_exception(why)) {
        return text;
    }
    std::string const code = hex_byte(static_cast<std::uint8_t>(why));
    return text == "exception" ? "exception 0x" + code + ", which no specification lists"
                               : text + " (exception 0x" + code + ")";
}

} // namespace tool
