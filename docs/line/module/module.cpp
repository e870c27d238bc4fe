// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The module's interface to the page: functions of numbers, and texts in JSON. A text or bytes that the page gives are put into
// `line_input()` first; what it gets is valid until the next call. Times are milliseconds by the page's clock.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "../../playground/module/explained.hpp"
#include "asked_line.hpp"
#include "jobs.hpp"
#include "points.hpp"
#include "simulated_units.hpp"

#if defined(__wasm__)
#define LINE_EXPORT(name) extern "C" __attribute__((export_name(#name)))
#else
#define LINE_EXPORT(name) extern "C"
#endif

namespace {

using line_page::microseconds;

constexpr std::size_t input_size = 65'536;
char input[input_size];

constexpr rtuwire::character_format formats[]{rtuwire::character_format::even_8_1, rtuwire::character_format::none_8_1,
                                              rtuwire::character_format::odd_8_1,  rtuwire::character_format::none_8_2,
                                              rtuwire::character_format::even_8_2, rtuwire::character_format::odd_8_2};

struct everything {
    line_page::identities units = line_page::identities(256);
    std::vector<std::unique_ptr<tool::register_names>> names{};
    std::string file{};
    std::string output{};
    std::optional<line_page::asked_line> line{};
    std::optional<line_page::simulated_units> simulated{};
    rtuwire::byte_view bytes{};
};

everything& all()
{
    static everything it;
    return it;
}

char const* give(std::string text)
{
    all().output = std::move(text);
    return all().output.c_str();
}

std::string_view typed(std::uint32_t length) { return {input, length < input_size ? length : input_size}; }
rtuwire::byte_view given(std::uint32_t length) { return std::as_bytes(std::span{input}.first(typed(length).size())); }
microseconds at(double milliseconds) { return milliseconds > 0 ? static_cast<microseconds>(milliseconds * 1000) : 0; }
std::uint8_t address(std::uint32_t unit) { return static_cast<std::uint8_t>(unit < 248 ? unit : 0); }

line_page::line_setting setting(std::uint32_t baud, std::uint32_t format)
{
    return {baud, formats[format < std::size(formats) ? format : 0]};
}

tool::drive_catalog const* catalog_of(std::uint32_t unit) { return all().units[address(unit)].drive; }

/// A name that a drive's register has is for its frames, too.
void note_names(std::uint32_t unit)
{
    if (auto const* const drive = catalog_of(unit); drive != nullptr and all().line) {
        all().names.push_back(std::make_unique<tool::names_by_drive>(*drive));
        all().line->explain_by(address(unit), all().names.back().get());
    }
}

std::uint32_t put_out(rtuwire::byte_view bytes)
{
    all().bytes = bytes;
    return static_cast<std::uint32_t>(bytes.size());
}

} // namespace

LINE_EXPORT(line_input) char* line_input() { return input; }
LINE_EXPORT(line_input_size) std::uint32_t line_input_size() { return input_size; }
/// The bytes of the last call that has some.
LINE_EXPORT(line_output) std::byte const* line_output() { return all().bytes.data(); }

/// A port was opened: everything is forgotten, and it listens. `unix_time` in milliseconds.
LINE_EXPORT(line_open) void line_open(std::uint32_t baud, std::uint32_t format, double now, double unix_time)
{
    all().line.reset();
    all().units = line_page::identities(256);
    all().names.clear();
    all().line.emplace(setting(baud, format), at(now), at(unix_time));
}
/// The same port at another setting: only frames are kept, and whether somebody was heard.
LINE_EXPORT(line_set) void line_set(std::uint32_t baud, std::uint32_t format, double now)
{
    if (all().line) {
        all().line->set(setting(baud, format), at(now));
        all().units = line_page::identities(256);
    }
}
LINE_EXPORT(line_receive) void line_receive(std::uint32_t length, double now)
{
    if (all().line) {
        all().line->receive(given(length), at(now));
    }
}
LINE_EXPORT(line_receive_error) void line_receive_error(double now)
{
    if (all().line) {
        all().line->receive_error(at(now));
    }
}
/// One pass: how many bytes of `line_output` are to be sent now.
LINE_EXPORT(line_pass) std::uint32_t line_pass(double now)
{
    return all().line ? put_out(all().line->pass(at(now))) : 0;
}
LINE_EXPORT(line_sent) void line_sent(double now)
{
    if (all().line) {
        all().line->sent(at(now));
    }
}
/// Milliseconds until the next pass.
LINE_EXPORT(line_time_left) double line_time_left()
{
    constexpr double idle = 250;
    return all().line ? static_cast<double>(all().line->time_left()) / 1000 : idle;
}
LINE_EXPORT(line_events) char const* line_events() { return give(all().line ? all().line->take_events() : "[]"); }

LINE_EXPORT(line_listen) void line_listen()
{
    if (all().line) {
        all().line->listen();
    }
}
LINE_EXPORT(line_stop) void line_stop()
{
    if (all().line) {
        all().line->stop("stopped");
    }
}
LINE_EXPORT(line_set_timeout) void line_set_timeout(std::uint32_t milliseconds)
{
    if (all().line) {
        all().line->set_timeout(rtuwire::milliseconds(milliseconds));
    }
}
LINE_EXPORT(line_scan) void line_scan(std::uint32_t first, std::uint32_t last)
{
    if (all().line and first >= 1 and first <= last and last <= 247) {
        all().line->run("scan", line_page::scan(*all().line, all().units, address(first), address(last)));
    }
}
LINE_EXPORT(line_identify) void line_identify(std::uint32_t unit)
{
    if (all().line) {
        all().line->run("identify", line_page::identify(*all().line, all().units, address(unit)));
    }
}
/// Somebody has read what polling a drive does, and wants it.
LINE_EXPORT(line_consent) void line_consent(std::uint32_t unit)
{
    if (all().line) {
        all().line->consent(address(unit));
    }
}
/// Reads the points in the input, once where the period is 0, so many registers a request at most. The line that
/// names nothing, else an empty text.
LINE_EXPORT(line_watch)
char const* line_watch(std::uint32_t unit, std::uint32_t length, std::uint32_t period, std::uint32_t most)
{
    constexpr std::uint32_t usual = 60; // as the register files of common meters have it
    auto const limit = static_cast<std::uint16_t>(most >= 1 and most <= rtuwire::max_read_quantity ? most : usual);
    auto read = line_page::points_in(typed(length), catalog_of(unit));
    if (read.flaw.empty() and all().line) {
        if (catalog_of(unit) == nullptr) {
            all().names.push_back(std::make_unique<line_page::point_names>(read.points));
            all().line->explain_by(address(unit), all().names.back().get());
        } else {
            note_names(unit);
        }
        all().line->run("watch", line_page::watch(*all().line, all().units, address(unit), std::move(read.points),
                                                  microseconds{period} * 1000, limit));
    }
    return give(std::move(read.flaw));
}
/// The time as text stands in the input.
LINE_EXPORT(line_back_up) void line_back_up(std::uint32_t unit, std::uint32_t length)
{
    if (all().line) {
        all().line->run("backup", line_page::back_up(*all().line, all().units, address(unit),
                                                     std::string{typed(length)}, all().file));
    }
}
LINE_EXPORT(line_file) char const* line_file() { return all().file.c_str(); }
LINE_EXPORT(line_capture) std::uint32_t line_capture() { return all().line ? put_out(all().line->capture()) : 0; }

LINE_EXPORT(line_frames) char const* line_frames(std::uint32_t from)
{
    return give(all().line ? all().line->frames().list(from) : "[]");
}
LINE_EXPORT(line_explain) char const* line_explain(std::uint32_t frame)
{
    return give(all().line ? all().line->explain(frame) : "{\"frames\":[]}");
}
/// Bytes that were typed, explained with the names of a drive by its number.
LINE_EXPORT(line_decode) char const* line_decode(std::uint32_t length, std::uint32_t drive)
{
    auto const drives = tool::all_catalogs();
    return give(playground::explain_typed(typed(length), *drives[drive < drives.size() ? drive : 0]));
}
/// The registers of the drive that a unit is: name, text, group.
LINE_EXPORT(line_registers) char const* line_registers(std::uint32_t unit)
{
    playground::json_text out;
    out.open_list();
    if (auto const* const drive = catalog_of(unit)) {
        for (tool::register_entry const& each : drive->registers) {
            out.open_object();
            out.put("name", each.code);
            out.put("text", each.name);
            out.put("unit", each.unit);
            out.put("driving", each.is_for_driving);
            out.close_object();
        }
    }
    out.close_list();
    return give(out.text());
}

// The other end, for who has none.
LINE_EXPORT(sim_open) void sim_open(std::uint32_t baud, std::uint32_t format, double now)
{
    all().simulated.emplace(setting(baud, format), at(now));
}
LINE_EXPORT(sim_receive) void sim_receive(std::uint32_t length, double now)
{
    if (all().simulated) {
        all().simulated->receive(given(length), at(now));
    }
}
LINE_EXPORT(sim_pass) std::uint32_t sim_pass(double now)
{
    return all().simulated ? put_out(all().simulated->pass(at(now))) : 0;
}
