// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "chaos/line_fault.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "exit_status.hpp"
#include "words/suggestion.hpp"
#include "words/time_words.hpp"

namespace tool {

namespace {

using rtuwire::sim::frame_fate;
using rtuwire::sim::line_faults;
using rtuwire::sim::random_source;

constexpr std::uint32_t always = 1'000'000;
constexpr std::uint32_t cut_length = 10; // frames

struct fault_row {
    std::string_view name;
    bool is_of_requests;                       ///< it may meet requests as well
    std::uint32_t usual_ms;                    ///< its time where none is typed
    bool has_time;                             ///< a time may be typed
    std::string_view what;                     ///< of the frame; the time stands in the place of #
    std::uint32_t line_faults::*rate{nullptr}; ///< as the simulated line has it
    bool frame_fate::*fate{nullptr};
};

constexpr fault_row rows[]{
    {"delay", true, 50, true, "comes later, by up to #", &line_faults::delayed, &frame_fate::is_delayed},
    {"late", false, 150, true, "comes behind the client's time-out, by up to #"},
    {"doubled", false, 0, false, "comes twice", &line_faults::repeated, &frame_fate::is_repeated},
    {"foreign", false, 0, false, "comes behind an answer of another unit", &line_faults::foreign,
     &frame_fate::has_foreign},
    {"lost", true, 0, false, "is lost", &line_faults::lost, &frame_fate::is_lost},
    {"damaged", true, 0, false, "has other bits, a byte less or a byte more"},
    {"noise", false, 0, false, "has up to 4 bytes of noise before or behind it", &line_faults::glitches,
     &frame_fate::has_glitch},
    {"echo", true, 0, false, "is given back to the client before its answer"},
    {"lumps", true, 16, true, "comes as a USB adapter hands it on, whose timer ends every #"},
    {"split", true, 40, true, "comes in up to 5 pieces, as over TCP, with pauses of up to #"},
    {"cut", true, 0, false, "is lost, and so are those behind it in its direction: 10, or as many as are said"},
    {"babble", false, 0, true, "is lost in bytes without sense, for #"},
};

constexpr std::string_view of_requests = "request-";

fault_row const& row_of(fault_kind kind) { return rows[static_cast<std::size_t>(kind)]; }

/// What it does, with its time.
std::string what_with(fault_kind kind, std::string const& time)
{
    std::string text{row_of(kind).what};
    if (std::size_t const at = text.find('#'); at != text.npos) {
        text.replace(at, 1, time);
    }
    return text;
}

std::string all_names()
{
    std::string text;
    for (fault_row const& each : rows) {
        text += (text.empty() ? "" : ", ") + std::string{each.name};
    }
    return text;
}

[[noreturn]] void refuse(std::string_view typed, std::string const& why)
{
    refuse_word("--faults: '" + std::string{typed} + "': " + why);
}

std::optional<std::uint32_t> count_in(std::string_view text)
{
    std::uint32_t value = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    bool const is_number = error == std::errc{} and end == text.data() + text.size() and value > 0;
    return is_number and value <= 1'000'000'000 ? std::optional{value} : std::nullopt;
}

std::optional<std::uint32_t> rate_in(std::string_view text)
{
    if (text.size() < 2 or text.back() != '%' or text.find_first_not_of("0123456789.%") != text.npos) {
        return std::nullopt;
    }
    std::string const number{text.substr(0, text.size() - 1)};
    char* end = nullptr;
    double const percent = std::strtod(number.c_str(), &end);
    double const rate = std::round(percent * 10'000);
    bool const is_one = end == number.c_str() + number.size() and rate >= 1 and rate <= always;
    return is_one ? std::optional{static_cast<std::uint32_t>(rate)} : std::nullopt;
}

/// The part of a word that begins with a sign, up to the next of them; it is taken away.
std::optional<std::string_view> taken(std::string_view& rest, char sign)
{
    if (rest.empty() or rest.front() != sign) {
        return std::nullopt;
    }
    std::size_t const end = std::min(rest.find_first_of("=@:", 1), rest.size());
    std::string_view const part = rest.substr(1, end - 1);
    rest.remove_prefix(end);
    return part;
}

fault_kind kind_in(std::string_view typed, std::string_view name, frame_way way)
{
    std::vector<std::string_view> known;
    for (std::size_t i = 0; i < std::size(rows); ++i) {
        known.push_back(rows[i].name);
        if (rows[i].name == name) {
            if (name == "echo" and way == frame_way::request) {
                refuse(typed, "an echo is of a request as it is; say echo");
            }
            if (way == frame_way::request and not rows[i].is_of_requests) {
                refuse(typed, "not of requests: the server gets what the client sent, once, and nothing else, because "
                              "what is made up or repeated may command a motor");
            }
            return static_cast<fault_kind>(i);
        }
    }
    refuse(typed, "'" + std::string{name} + "' is no fault (" + all_names() + ")" + suggestion(name, known));
}

line_fault fault_in(std::string_view typed)
{
    std::size_t const end = std::min(typed.find_first_of("=@:"), typed.size());
    std::string_view name = typed.substr(0, end);
    std::string_view rest = typed.substr(end);
    line_fault fault{.typed = std::string{typed}};
    if (name.starts_with(of_requests)) {
        fault.way = frame_way::request;
        name.remove_prefix(of_requests.size());
    }
    fault.kind = kind_in(typed, name, fault.way);
    fault_row const& row = row_of(fault.kind);
    fault.way = fault.kind == fault_kind::echo ? frame_way::request : fault.way;
    fault.count = fault.kind == fault_kind::cut ? cut_length : 1;
    fault.time = rtuwire::milliseconds(row.usual_ms);
    if (auto const rate = taken(rest, '=')) {
        fault.in_a_million = rate_in(*rate).value_or(0);
        if (fault.in_a_million == 0) {
            refuse(typed, "'" + std::string{*rate} + "' is no rate such as 1% or 0.05%: 0.0001% to 100%");
        }
    }
    if (auto const moment = taken(rest, '@')) {
        std::size_t const times = moment->find('x');
        auto const first = count_in(moment->substr(0, times));
        auto const count = times == moment->npos ? std::optional{fault.count} : count_in(moment->substr(times + 1));
        if (not first or not count) {
            refuse(typed, "'" + std::string{*moment} + "' is no frame such as 250, or 250x5 for five from it on");
        }
        fault.first = *first;
        fault.count = *count;
    }
    if (auto const time = taken(rest, ':')) {
        auto const seconds = time_limit_typed(*time);
        if (not row.has_time) {
            refuse(typed, std::string{name} + " takes no time");
        }
        if (not seconds or *seconds < 0.001 or *seconds > 60) {
            refuse(typed, "'" + std::string{*time} + "' is no length of time such as 30ms: 1ms to 60s");
        }
        fault.time = rtuwire::microseconds(static_cast<std::uint32_t>(*seconds * 1e6));
    }
    if (not rest.empty()) {
        refuse(typed, "'" + std::string{rest} +
                          "' is too much; it is like late=1%, lost@250, lost@250x5 or "
                          "delay=5%:30ms");
    }
    if (fault.in_a_million == 0 and fault.first == 0) {
        refuse(typed, "how often, or when? say " + std::string{typed.substr(0, end)} + "=1%, or " +
                          std::string{typed.substr(0, end)} + "@250 for the frame with this number");
    }
    return fault;
}

/// Neighbours are not alike: each of them turns all bits about.
random_source source_of(line_fault const& fault, std::uint32_t seed, std::uint32_t number, std::uint32_t purpose)
{
    std::uint32_t mixed = 0x9E37'79B9U;
    for (std::uint32_t const each :
         {seed, static_cast<std::uint32_t>(fault.kind), static_cast<std::uint32_t>(fault.way), purpose, number}) {
        mixed = (mixed ^ each) * 0x85EB'CA6BU;
        mixed = (mixed ^ (mixed >> 13U)) * 0xC2B2'AE35U;
        mixed ^= mixed >> 16U;
    }
    return random_source{mixed};
}

/// Both meet the same frames, of which the second does nothing.
bool says_again(line_fault const& one, line_fault const& other)
{
    auto const begins_in = [](line_fault const& it, line_fault const& span) {
        return it.first >= span.first and it.first - span.first < span.count;
    };
    bool const is_moment = one.first != 0 and other.first != 0;
    return one.kind == other.kind and one.way == other.way and
           ((one.in_a_million > 0 and other.in_a_million > 0) or
            (is_moment and (begins_in(one, other) or begins_in(other, one))));
}

bool happens(line_fault const& fault, std::uint32_t rate, random_source random)
{
    fault_row const& row = row_of(fault.kind);
    if (row.rate == nullptr) {
        return random.happens(rate);
    }
    line_faults one;
    one.*row.rate = rate;
    return fate_of(one, random).*row.fate;
}

} // namespace

std::string name_of(fault_kind kind, frame_way way)
{
    bool const is_request = way == frame_way::request and kind != fault_kind::echo;
    return std::string{is_request ? of_requests : ""} + std::string{row_of(kind).name};
}

std::vector<line_fault> faults_in(std::string_view words)
{
    std::vector<line_fault> all;
    for (std::string_view const each : parts_of(words)) {
        line_fault const fault = fault_in(each);
        for (line_fault const& before : all) {
            if (says_again(before, fault)) {
                refuse(each, "'" + before.typed + "' says that already; a fault has one rate, and moments of its own");
            }
        }
        all.push_back(fault);
    }
    return all;
}

std::string words_of(line_fault const& fault, rtuwire::duration time_out)
{
    std::string const time = std::to_string(fault.time_at(time_out).microseconds / 1'000) + " ms";
    return (fault.way == frame_way::request ? "a request " : "an answer ") + what_with(fault.kind, time);
}

bool meets(line_fault const& fault, std::uint32_t seed, std::uint32_t number)
{
    if (fault.first != 0 and number >= fault.first and number - fault.first < fault.count) {
        return true;
    }
    // A cut lasts: one that began before goes on.
    std::uint32_t const lasts = fault.kind == fault_kind::cut ? cut_length : 1;
    for (std::uint32_t back = 0; fault.in_a_million > 0 and back < lasts and back < number; ++back) {
        if (happens(fault, fault.in_a_million, source_of(fault, seed, number - back, 0))) {
            return true;
        }
    }
    return false;
}

random_source draws_of(line_fault const& fault, std::uint32_t seed, std::uint32_t number)
{
    return source_of(fault, seed, number, 1);
}

std::string faults_text()
{
    std::string text;
    for (std::size_t i = 0; i < std::size(rows); ++i) {
        fault_row const& row = rows[i];
        std::string const time = row.usual_ms == 0 ? "longer than the time-out" : std::to_string(row.usual_ms) + " ms";
        text += "  " + std::string{row.name} + std::string(9 - row.name.size(), ' ') +
                what_with(static_cast<fault_kind>(i), time) + '\n';
    }
    return text;
}

} // namespace tool
