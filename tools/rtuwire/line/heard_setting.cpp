// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/heard_setting.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <optional>
#include <set>
#include <string>

#include <rtuwire/trace.hpp>

#include "line/end_wish.hpp"
#include "line/line_words.hpp"
#include "line/open_line.hpp"
#include "line/scan_log.hpp"
#include "line/usual_settings.hpp"
#include "output/output.hpp"
#include "output/plain_text.hpp"
#include "output/progress.hpp"

namespace tool {

namespace {

using time_span = std::chrono::duration<double>;

/// What was heard at one setting.
class hearing {
public:
    void note(rtuwire::heard_frame const& it)
    {
        bool const is_frame = it.frame.role != rtuwire::frame_role::unknown and not it.is_unanswered and
                              it.frame.verdict != rtuwire::frame_verdict::damaged;
        frames_ += is_frame ? 1U : 0U;
        if (is_frame) {
            units_.insert(it.unit());
        }
    }

    /// Bytes came, whole or damaged: one burst as long as none is silent for longer than two frames of a conversation are apart.
    void note_bytes(std::chrono::steady_clock::time_point now)
    {
        constexpr time_span apart{0.05};
        bursts_ += not last_ or now - *last_ > apart ? 1U : 0U;
        last_ = now;
    }

    /// A CRC of 16 bits lets one of 65 536 wrong frames through: one alone is none.
    bool is_right() const { return frames_ >= 2; }
    bool is_wrong() const { return frames_ == 0 and bursts_ > 3; }
    bool is_silent() const { return bursts_ == 0; }

    std::int64_t frames() const { return static_cast<std::int64_t>(frames_); }
    std::string units() const
    {
        std::string all;
        for (unsigned const each : units_) {
            all += (all.empty() ? "" : ",") + std::to_string(each);
        }
        return all;
    }

private:
    std::size_t frames_{0};
    std::size_t bursts_{0};
    std::optional<std::chrono::steady_clock::time_point> last_{};
    std::set<unsigned> units_{};
};

/// Listens at one setting until it is known whether it is the line's, at most for so long.
hearing heard_at(choices const& chosen, line_setting const& how, time_span longest)
{
    any_port port = open_port(chosen.line, how);
    rtuwire::line_listener tap{port.timing()};
    hearing found;
    auto const note = [&found](rtuwire::heard_frame const& it) { found.note(it); };
    std::array<std::byte, 512> place{};
    auto const began = std::chrono::steady_clock::now();
    while (noted_signal() == 0 and not found.is_right() and not found.is_wrong() and
           std::chrono::steady_clock::now() - began < longest) {
        std::size_t const before = port.heard();
        auto const bytes = port.read(place, port.now() + rtuwire::milliseconds(20));
        if (not bytes) {
            throw ended{exit_status::port, port.failure()};
        }
        tap.receive(*bytes, port.now(), note);
        if (port.take_receive_error()) {
            tap.receive_error(port.now(), note);
        }
        tap.advance(port.now(), note);
        if (port.heard() != before) {
            found.note_bytes(std::chrono::steady_clock::now());
        }
    }
    return found;
}

std::string sniff_at(choices const& chosen, line_setting const& how)
{
    line_choices line = chosen.line;
    line.typed.rate = typed_rate(how);
    return shown_command(line, "sniff");
}

void tell_note(std::string const& text) { std::fprintf(stderr, "note: %s\n", plain_text(text).c_str()); }

exit_status tell_silence(choices const& chosen, time_span longest)
{
    line_choices line = chosen.line;
    line.typed.rate.clear();
    tell_note(
        "nobody talks on this line: nothing came within " +
        time_in_words(std::chrono::ceil<std::chrono::seconds>(longest)) +
        ". A client that asks more seldom needs a longer --for; one that is there is at the same two wires? Where "
        "there "
        "is none, units only answer: `" +
        shown_command(line, "scan --find") + "` asks them, and only reads");
    return exit_status::no_answer;
}

} // namespace

exit_status find_heard_setting(choices const& chosen)
{
    if (not chosen.file.empty()) {
        refuse_word("--find shows no frames: -o " + chosen.file + " is for the sniff behind it");
    }
    refuse_without_rate(chosen.line, "--find");
    note_signals();
    constexpr time_span usual{10};
    time_span const each_time = chosen.last ? time_span{*chosen.last} : usual;
    auto const& settings = usual_settings();
    std::string const one = time_in_words(std::chrono::ceil<std::chrono::seconds>(each_time));
    tell_note("listens at " + std::to_string(settings.size()) +
              " settings of bit rate and format, at each until it is told from " +
              "the others by what comes, for at most " + one + ", " +
              time_in_words(std::chrono::ceil<std::chrono::seconds>(each_time * settings.size())) +
              " in all; where nothing comes at the first it ends. It sends nothing; Ctrl-C ends it");
    output results{chosen.form, false};
    progress bar{settings.size()};
    std::size_t done = 0;
    for (line_setting const& how : settings) {
        bar.show(done, ", listening at " + words_of(how));
        std::optional<hearing> heard;
        try {
            heard = heard_at(chosen, how, each_time);
        } catch (setting_refused const&) { // one that this adapter does not have
        }
        if (noted_signal() != 0) {
            return static_cast<exit_status>(128 + noted_signal());
        }
        if (heard and heard->is_right()) {
            bar.clear();
            results.put({{"baud", std::int64_t{how.baud}},
                         {"format", name_of_format(how.format)},
                         {"frames", heard->frames()},
                         {"units", heard->units()},
                         {"note", note_of_format(how)}});
            results.finish();
            tell_note(
                "somebody talks here at " + words_of(how) + ": `" + sniff_at(chosen, how) +
                "` shows what, and sends nothing. Two clients on one line disturb each other: end that one before you "
                "ask");
            return exit_status::done;
        }
        if (heard and heard->is_silent() and done == 0) {
            bar.clear();
            return tell_silence(chosen, each_time);
        }
        ++done;
    }
    bar.clear();
    tell_note(
        "bytes come, and are Modbus RTU at none of the usual bit rates and formats: another protocol, an uncommon bit "
        "rate, "
        "or an open line without bias that makes noise; `" +
        shown_command(chosen.line, "sniff") + "` shows the bytes");
    return exit_status::differs;
}

} // namespace tool
