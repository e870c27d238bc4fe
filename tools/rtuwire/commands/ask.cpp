// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Asks a unit by any function, and shows both frames. What only reads is free; what else is sent by the rules of `write`.
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "commands/commands.hpp"
#include "frame/decode.hpp"
#include "frame/frame_fit.hpp"
#include "frame/frame_printer.hpp"
#include "frame/function_text.hpp"
#include "frame/hex_text.hpp"
#include "frame/names_by_file.hpp"
#include "line/end_wish.hpp"
#include "line/line_words.hpp"
#include "line/open_line.hpp"
#include "line/raw_request.hpp"
#include "line/reading.hpp"
#include "line/who_is_it.hpp"
#include "line/write_log.hpp"
#include "motion/checked_values.hpp"
#include "motion/question.hpp"
#include "motion/raw_effect.hpp"
#include "output/plain_text.hpp"

namespace tool {

namespace {

using byte_list = std::vector<std::byte>;
using rtuwire::errc;
using rtuwire::frame_role;

/// The bytes of a word: pairs of hexadecimal digits, with or without 0x in front.
byte_list bytes_in(std::string_view word)
{
    std::string_view const digits = word.substr(word.starts_with("0x") or word.starts_with("0X") ? 2 : 0);
    auto const is_hex = [](char each) { return std::isxdigit(static_cast<unsigned char>(each)) != 0; };
    if (digits.empty() or not std::ranges::all_of(digits, is_hex)) {
        refuse_word("'" + std::string{word} + "' is no hexadecimal number: data is typed as 0C820001 or 0C 82 00 01");
    }
    if (digits.size() % 2 != 0) {
        refuse_word("'" + std::string{word} + "' has " + std::to_string(digits.size()) +
                    (digits.size() == 1 ? " digit" : " digits") + ": a byte has two, such as 0C");
    }
    byte_list found;
    for (std::size_t at = 0; at < digits.size(); at += 2) {
        found.push_back(static_cast<std::byte>(std::stoul(std::string{digits.substr(at, 2)}, nullptr, 16)));
    }
    return found;
}

/// Function and data; a function may have one digit.
byte_list pdu_in(std::vector<std::string> const& words)
{
    byte_list pdu;
    for (std::string const& word : words) {
        for (std::size_t at = 0;
             at < word.size();) { // several in one word, as a shell keeps them that was given quotes
            std::size_t const end = std::min(word.find(' ', at), word.size());
            std::string const one = word.substr(at, end - at);
            byte_list const more =
                one.empty() ? byte_list{} : bytes_in(pdu.empty() and one.size() == 1 ? '0' + one : one);
            pdu.insert(pdu.end(), more.begin(), more.end());
            at = end + 1;
        }
    }
    std::size_t const most = rtuwire::max_pdu_size;
    if (pdu.empty()) {
        refuse_word("which function? It is typed in hexadecimal, 01 to 7F, and its data behind it: 03 0C820001");
    }
    if (pdu.size() >= rtuwire::min_adu_size and pdu.size() <= rtuwire::max_adu_size and rtuwire::crc16(pdu) == 0) {
        refuse_word("this is a whole frame with unit and CRC: ask takes a function and its data, " +
                    hex_of(rtuwire::byte_view{pdu}.subspan(1, pdu.size() - 3)) + ", and adds both");
    }
    if (pdu[0] == std::byte{0} or pdu[0] > std::byte{0x7F}) {
        refuse_word("'" + hex_of({pdu.data(), 1}) + "' is no function: there are 01 to 7F, in hexadecimal");
    }
    if (pdu.size() > most) {
        refuse_word(std::to_string(pdu.size() - 1) + " bytes of data: a request has at most " +
                    std::to_string(most - 1) + " behind its function");
    }
    return pdu;
}

class asking {
public:
    explicit asking(choices const& chosen)
        : chosen_{chosen}, pdu_{pdu_in(chosen.words)}, is_free_{only_reads(pdu_)},
          is_broadcast_{chosen.line.unit == "0"}, printer_{chosen.form}
    {
        if (not is_free_) {
            refuse_without_write();
            refuse_unreadable(pdu_);
            printer_.need_reader();
        }
        if (is_broadcast_) {
            refuse_broadcast(pdu_, chosen_);
        } else {
            unit_ = is_free_ ? unit_in(chosen.line) : unit_to_change(chosen);
            drive_ = unit_->drive.empty() ? nullptr : catalog_or_none(unit_->drive);
        }
        refuse_frame_within(frame_of(std::byte{unit_ ? unit_->unit.byte() : std::uint8_t{0}}, pdu_),
                            functions_within::any);
    }

    exit_status run()
    {
        if (not is_free_) {
            refuse_wrong_log();
        }
        open_line line{chosen_.line};
        if (not is_free_) {
            if (not may_be_sent(line)) {
                return exit_status::refused;
            }
            refuse_wrong_log(1 + values_.size()); // room for what is noted of it
        }
        return is_broadcast_ ? send_to_all(line) : send(line);
    }

private:
    rtuwire::raw_pdu<> raw() const
    {
        return {static_cast<rtuwire::function_code>(pdu_[0]), rtuwire::byte_view{pdu_}.subspan(1)};
    }

    /// Of a function that is not public, whose typed digits are a public one's in decimal.
    std::string likely_function() const
    {
        auto const typed = std::to_integer<unsigned>(pdu_[0]);
        auto const meant = static_cast<rtuwire::function_code>(10 * (typed >> 4U) + (typed & 0xFU));
        bool const is_likely = not rtuwire::all_functions.contains(static_cast<rtuwire::function_code>(typed)) and
                               (typed & 0xFU) < 10 and rtuwire::all_functions.contains(meant);
        return is_likely ? "; function " + function_number(meant) + ", " + function_text(meant) + ", is typed " +
                               hex_of(std::array{static_cast<std::byte>(meant)})
                         : std::string{};
    }

    void refuse_without_write() const
    {
        if (not chosen_.allowed.may_write) {
            refuse_for_safety(words_of_function(pdu_) + likely_function() +
                              ": it may change something, and this program only reads; to send it, "
                              "say --write");
        }
    }

    /// Checks it as a write of the same, and asks whoever is there. From here on a signal ends the command by its own words.
    bool may_be_sent(open_line& line)
    {
        write_rules const rules = is_broadcast_ ? write_rules{} : rules_to_write(line, *unit_, chosen_.allowed);
        if (not is_broadcast_) {
            values_ = checked_request(pdu_, line, *unit_, rules, chosen_);
            drive_ = rules.drive;
        }
        if (is_asked(chosen_.allowed)) {
            std::fprintf(stderr, "%s: %s\n", plain_text(to_whom()).c_str(), plain_text(what()).c_str());
            if (not is_answered_yes("send?")) {
                return false;
            }
            if (not is_broadcast_ and not(rules_to_write(line, *unit_, chosen_.allowed) == rules)) {
                throw ended{exit_status::refused, "another unit answers than when you were asked; nothing is sent"};
            }
            if (not is_broadcast_) {
                refuse_changed_values(values_, checked_request(pdu_, line, *unit_, rules, chosen_));
            }
        }
        note_signals();
        return true;
    }

    std::string to_whom() const { return is_broadcast_ ? "all units" : "unit " + std::to_string(unit_->unit.byte()); }

    std::string what() const
    {
        std::string text = words_of_function(pdu_) + ": " + hex_of(pdu_);
        for (value_to_write const& each : values_) {
            text += "; " + label_of({each.where, each.entry}) + " = " + each.text;
        }
        return text;
    }

    /// A drive's registers are its own, whatever a file says.
    register_names const* names()
    {
        if (drive_ != nullptr) {
            names_ = std::make_unique<names_by_drive>(*drive_);
        } else if (unit_->names != nullptr) {
            names_ = std::make_unique<names_by_file>(*unit_->names);
        }
        return names_.get();
    }

    void show(frame_decoder& decoder, byte_list const& frame, frame_role role, std::string const& error = {})
    {
        decoded_frame known = frame.size() < rtuwire::min_adu_size
                                  ? decoded_frame{0, frame, false, false, {{.as = "response"}}}
                                  : decoder.decode_as(frame, role);
        if (not error.empty()) {
            known.readings.back().fields.push_back({0, 0, "error", error});
        }
        printer_.put(known, frame.empty() ? std::string{} : "frame");
    }

    exit_status send(open_line& line)
    {
        std::byte const unit{unit_->unit.byte()};
        frame_decoder decoder{names()};
        if (is_free_) {
            auto request = line.with(rtuwire::single_request{rtuwire::unit_id{unit_->unit}, raw_request{raw()}});
            return tell(line, decoder, unit, line.run(request));
        }
        auto request = line.with(sent_once{rtuwire::unit_id{unit_->unit}, raw_request{raw()}});
        return tell(line, decoder, unit, line.run(request));
    }

    exit_status tell(open_line& line, frame_decoder& decoder, std::byte unit,
                     rtuwire::result<rtuwire::response> const& outcome)
    {
        errc why = outcome.error();
        if (status_of(why) == exit_status::port) {
            note("unknown");
            throw ended{exit_status::port, line.port().failure()};
        }
        byte_list const response = came(line, unit, outcome);
        if (outcome) {
            why = is_echo(line, response)
                      ? errc::line_echo
                      : flaw_of_response(pdu_, rtuwire::byte_view{response}.subspan(1, response.size() - 3));
        }
        std::string const failure = why == errc::none                    ? std::string{}
                                    : outcome and why != errc::line_echo ? words_of(why)
                                                                         : line.words_of_failure(why);
        std::string const told = failure.empty() ? "answered" : failure;
        note(told);
        show_all(told, [&] {
            show(decoder, frame_of(unit, pdu_), frame_role::request);
            show(decoder, response, frame_role::response, failure);
        });
        return noted(status_of(why));
    }

    /// What was sent is told, though the output takes nothing.
    template <typename Show> void show_all(std::string const& outcome, Show const& show_frames)
    {
        try {
            show_frames();
            printer_.finish_run();
        } catch (ended const& why) {
            if (is_free_) {
                throw;
            }
            throw ended{why.status,
                        std::string{why.what()} + "; " + to_whom() + ": " + what() + " was sent: " + outcome};
        }
    }

    /// Whether a response that is its request, as those of several functions are, is what a line gives back: a read tells,
    /// whose response is another than its request.
    bool is_echo(open_line& line, byte_list const& response) const
    {
        if (chosen_.line.has_echo or response != frame_of(std::byte{unit_->unit.byte()}, pdu_)) {
            return false;
        }
        auto probe = line.with(rtuwire::line_echo_probe{unit_->unit});
        static_cast<void>(line.run(probe));
        auto const found = probe.outcome();
        return found and *found;
    }

    /// What came; empty where nothing is known of it.
    byte_list came(open_line const& line, std::byte unit, rtuwire::result<rtuwire::response> const& outcome) const
    {
        if (outcome) {
            return frame_of(unit, outcome->pdu());
        }
        if (rtuwire::is_exception(outcome.error()) and outcome.error() != errc::unlisted_exception) {
            std::byte const refusal[]{pdu_[0] | std::byte{0x80}, static_cast<std::byte>(outcome.error())};
            return frame_of(unit, refusal);
        }
        rtuwire::byte_view const refused = line.refused();
        return {refused.begin(), refused.end()};
    }

    exit_status send_to_all(open_line& line)
    {
        auto request = line.with(sent_once{rtuwire::broadcast, raw_request{raw()}});
        errc const why = line.run(request).error();
        note(why == errc::none ? "sent to all" : words_of(why));
        if (why != errc::none) {
            throw ended{status_of(why) == exit_status::port ? exit_status::port : exit_status::differs,
                        status_of(why) == exit_status::port ? line.port().failure() : line.words_of_failure(why)};
        }
        frame_decoder decoder{nullptr};
        show_all("nobody answers a broadcast",
                 [&] { show(decoder, frame_of(std::byte{0}, pdu_), frame_role::request); });
        std::fputs("note: nobody answers a broadcast: what the units made of it is not known\n", stderr);
        return noted(exit_status::done);
    }

    /// In the file of what was written, where it may have changed something. What the file lacks is told here: nobody else
    /// knows that it was sent.
    void note(std::string const& outcome)
    {
        if (is_free_) {
            return;
        }
        unsigned const unit = unit_ ? unit_->unit.byte() : 0;
        std::string failure = log_write({chosen_.line.port, unit, "ask " + hex_of(pdu_), "unknown", outcome});
        bool const has_frame = failure.empty();
        for (value_to_write const& each : values_) {
            if (failure.empty()) {
                failure = log_write(
                    {chosen_.line.port, unit, label_of({each.where, each.entry}), "unknown", each.text + " was sent"});
            }
        }
        is_log_missed_ = not failure.empty();
        if (is_log_missed_) {
            std::string const told =
                to_whom() + ": " + what() + " was sent: " + outcome +
                (has_frame ? "; the frame is noted in writes.log, and not all that it wrote"
                           : "; nothing of it is noted in writes.log, and what was there before is not known");
            std::fprintf(stderr, "rtuwire: %s: %s\n", plain_text(told).c_str(), plain_text(failure).c_str());
        }
    }

    exit_status noted(exit_status outcome) const
    {
        return outcome == exit_status::done and is_log_missed_ ? exit_status::port : outcome;
    }

    choices const& chosen_;
    byte_list pdu_;
    bool is_free_;
    bool is_broadcast_;
    std::optional<named_unit> unit_{};
    drive_catalog const* drive_{nullptr};
    bool is_log_missed_{false};
    std::unique_ptr<register_names const> names_{};
    std::vector<value_to_write> values_{};
    frame_printer printer_;
};

} // namespace

exit_status run_ask(choices const& chosen) { return asking{chosen}.run(); }

} // namespace tool
