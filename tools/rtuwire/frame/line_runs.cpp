// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/line_runs.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>

#include "frame/decode.hpp"

namespace tool {

namespace {

using byte_row = std::vector<std::byte>;
using word_row = std::vector<line_word>;

/// Words from `first` to before `last`, and how they are written.
struct word_range {
    std::size_t first{0};
    std::size_t last{0};
    bool is_hex{true};
    bool is_decimal{true};

    [[nodiscard]] bool empty() const { return first == last; }
};

byte_row bytes_of(word_row const& line, word_range const& range, bool as_decimal)
{
    byte_row made;
    for (std::size_t at = range.first; at < range.last; ++at) {
        if (as_decimal) {
            made.push_back(*line[at].decimal);
        } else {
            made.insert(made.end(), line[at].bytes.begin(), line[at].bytes.end());
        }
    }
    return made;
}

/// Whether bytes are frames with right CRCs, and nothing besides.
bool are_frames(byte_row const& run)
{
    auto const frames = frame_decoder{nullptr}.decode(run);
    return std::all_of(frames.begin(), frames.end(), [](auto const& each) { return each.has_right_crc; }) and
           not frames.empty();
}

/// The runs of a line. A word that no notation of its run has is no byte.
std::vector<word_range> runs_of(word_row const& line)
{
    std::vector<word_range> runs;
    word_range open{};
    auto const close = [&](std::size_t next) {
        if (not open.empty()) {
            runs.push_back(open);
        }
        open = {next, next};
    };
    for (std::size_t at = 0; at < line.size(); ++at) {
        line_word const& word = line[at];
        bool const is_hex = open.is_hex and not word.bytes.empty();
        bool const is_decimal = open.is_decimal and word.decimal.has_value();
        bool const is_apart = word.is_literal or (at > 0 and line[at - 1].is_literal);
        if (not word.is_byte() or is_apart or not(is_hex or is_decimal)) {
            close(at);
        }
        if (not word.is_byte()) {
            close(at + 1);
            continue;
        }
        open.is_hex = open.is_hex and not word.bytes.empty();
        open.is_decimal = open.is_decimal and word.decimal.has_value();
        open.last = at + 1;
    }
    close(line.size());
    return runs;
}

/// What parts most words of a run.
std::string usual_parting(word_row const& line, word_range const& run)
{
    std::map<std::string, std::size_t> counts;
    for (std::size_t at = run.first + 1; at < run.last; ++at) {
        ++counts[line[at].before];
    }
    auto const most = std::max_element(counts.begin(), counts.end(),
                                       [](auto const& one, auto const& other) { return one.second < other.second; });
    return most == counts.end() ? std::string{} : most->first;
}

/// Where the parts of a run begin, and its end: words that are parted otherwise than most stand at an end of one.
std::vector<std::size_t> parts_of_run(word_row const& line, word_range const& run)
{
    std::string const usual = usual_parting(line, run);
    std::vector<std::size_t> begins{run.first};
    for (std::size_t at = run.first + 1; at < run.last; ++at) {
        bool const is_behind = at > run.first + 1 and line[at - 1].before != usual;
        if (line[at].before != usual or is_behind) {
            begins.push_back(at);
        }
    }
    begins.push_back(run.last);
    return begins;
}

/// The longest piece of a run, from one of its parts to another, that is frames; empty where none is.
word_range frames_in(word_row const& line, word_range const& run, bool as_decimal)
{
    constexpr std::size_t most_parts = 12;
    auto const begins = parts_of_run(line, run);
    word_range found{run.first, run.first};
    std::size_t size = 0;
    for (std::size_t first = 0; first + 1 < begins.size(); ++first) {
        for (std::size_t last = begins.size() - 1; last > first; --last) {
            bool const is_whole = first == 0 and last + 1 == begins.size();
            word_range const piece{begins[first], begins[last], run.is_hex, run.is_decimal};
            if ((begins.size() > most_parts and not is_whole) or piece.last - piece.first <= size) {
                continue;
            }
            if (are_frames(bytes_of(line, piece, as_decimal))) {
                found = piece;
                size = piece.last - piece.first;
            }
        }
    }
    return found;
}

bool is_text(word_row const& line, std::size_t at) { return at < line.size() and not line[at].is_byte(); }

/// A run without what is none of its bytes: a counter in front, of other digits and parted otherwise; a number beside text.
word_range without_numbers(word_row const& line, word_range run)
{
    auto const begins = parts_of_run(line, run);
    bool const has_parts = begins.size() > 2;
    if (has_parts and begins[1] == run.first + 1 and line[run.first].bytes.size() > 2) {
        run.first = begins[1];
    }
    bool const is_last_alone = has_parts and begins[begins.size() - 2] + 1 == run.last;
    if (is_last_alone and line[run.last - 1].before.find('(') != std::string::npos and is_text(line, run.last)) {
        --run.last;
    }
    return run;
}

std::size_t size_of(word_row const& line, word_range const& run)
{
    return run.is_hex ? bytes_of(line, run, false).size() : run.last - run.first;
}

/// Names of what a line shows, in front of a byte that stands alone.
bool is_role(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char each) {
        return static_cast<char>(each >= 'A' and each <= 'Z' ? each + 32 : each);
    });
    constexpr std::string_view names[] = {"tx", "rx", "send", "sent", "recv", "received", "receive", "read", "write"};
    return std::find(std::begin(names), std::end(names), text) != std::end(names);
}

/// Whether a byte that stands alone is one: nothing but the name of a role is with it, and it is written as a byte.
bool is_byte_alone(word_row const& line, word_range const& run)
{
    for (std::size_t at = 0; at < line.size(); ++at) {
        if (at != run.first and not is_role(line[at].text)) {
            return false;
        }
    }
    return line.size() == 1 or line[run.first].text.size() > 1;
}

/// A number right beside a run that is none of its bytes: nobody's label, so that it may be one with a slip of the pen.
std::optional<std::size_t> wrong_beside(word_row const& line, std::vector<word_range> const& runs,
                                        word_range const& run)
{
    auto const is_of_other_run = [&](std::size_t at) {
        return std::any_of(runs.begin(), runs.end(), [&](word_range const& each) {
            return each.first != run.first and at >= each.first and at < each.last;
        });
    };
    for (std::size_t const at : {run.first - 1, run.last}) {
        if (at >= line.size() or line[at].is_literal or line[run.first].is_literal) {
            continue;
        }
        std::string const& between = line[at < run.first ? run.first : at].before;
        bool const is_close = between.size() <= 1;
        if (line[at].is_wrong_number() or (is_close and is_of_other_run(at))) {
            return at;
        }
    }
    return std::nullopt;
}

line_refusal refusal_of(line_word const& word) { return {word.column, word.text, why_no_byte(word)}; }

/// The frames of all runs, one after the other; the same bytes once more in another notation are left out.
byte_run frames_of_line(word_row const& line, std::vector<word_range> const& runs)
{
    byte_run found;
    byte_row latest;
    for (word_range const& run : runs) {
        word_range piece = run.is_hex ? frames_in(line, run, false) : word_range{run.first, run.first};
        bool const as_decimal = piece.empty() and run.is_decimal;
        if (as_decimal) {
            piece = frames_in(line, run, true);
        }
        byte_row const its = bytes_of(line, piece, as_decimal);
        if (piece.empty() or its == latest) {
            continue;
        }
        found.bytes.insert(found.bytes.end(), its.begin(), its.end());
        found.is_decimal = as_decimal;
        latest = its;
    }
    return found;
}

} // namespace

byte_run run_in(word_row const& line, line_refusal& refusal)
{
    auto runs = runs_of(line);
    if (byte_run const frames = frames_of_line(line, runs); not frames.bytes.empty()) {
        return frames;
    }
    std::transform(runs.begin(), runs.end(), runs.begin(),
                   [&](word_range const& each) { return without_numbers(line, each); });
    auto const longest = std::max_element(runs.begin(), runs.end(), [&](auto const& one, auto const& other) {
        return size_of(line, one) < size_of(line, other);
    });
    bool const has_text = std::any_of(line.begin(), line.end(), [](line_word const& each) {
        return not each.is_byte() and not each.is_wrong_number();
    });
    if (longest == runs.end()) {
        refusal = has_text or line.empty() ? line_refusal{} : refusal_of(line.front());
        return {};
    }
    std::size_t const size = size_of(line, *longest);
    if (size == 1 and has_text and not is_byte_alone(line, *longest)) {
        return {}; // a text with numbers
    }
    if (auto const wrong = wrong_beside(line, runs, *longest)) {
        refusal = refusal_of(line[*wrong]);
        return {};
    }
    for (auto const& other : runs) {
        if (&other != &*longest and size_of(line, other) > 1) {
            std::size_t const between = other.first < longest->first ? longest->first - 1 : longest->last;
            refusal = {line[between].column, line[between].text,
                       "stands between bytes, and the CRC of neither is right"};
            return {};
        }
    }
    byte_run chosen;
    chosen.is_decimal = not longest->is_hex;
    chosen.bytes = bytes_of(line, *longest, chosen.is_decimal);
    chosen.is_single = size == 1;
    if (longest->is_hex and longest->is_decimal and size > 1) {
        chosen.or_decimal = bytes_of(line, *longest, true);
        chosen.or_decimal = chosen.or_decimal == chosen.bytes ? byte_row{} : chosen.or_decimal;
    }
    return chosen;
}

} // namespace tool
