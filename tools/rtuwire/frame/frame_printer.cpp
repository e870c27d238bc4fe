// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/frame_printer.hpp"

#include "frame/damage.hpp"
#include "frame/hex_text.hpp"

namespace tool {

void frame_printer::put(decoded_frame const& frame, std::string const& whole, std::string const& value)
{
    ++number_;
    std::string const cause = frame.is_damaged ? cause_of_damage(frame.bytes) : std::string{};
    for (frame_reading const& reading : frame.readings) {
        is_first_ = true;
        if (not whole.empty()) {
            put(frame, reading, {0, frame.bytes.size(), whole, value});
        }
        for (frame_field const& each : reading.fields) {
            put(frame, reading, each);
        }
        if (not reading.flaw.empty()) {
            put(frame, reading, {0, 0, "flaw", reading.flaw});
        }
        if (not cause.empty()) {
            put(frame, reading, {0, 0, "cause", cause});
        }
    }
}

void frame_printer::put(decoded_frame const& frame, frame_reading const& reading, frame_field const& each)
{
    bool const is_flaw = each.length == 0;
    record row;
    row.add("frame", is_table_ and not is_first_ ? cell{std::string{}} : cell{number_});
    row.add("as", is_table_ and not is_first_ ? std::string{} : reading.as);
    row.add("at", is_flaw ? cell{} : cell{static_cast<std::int64_t>(frame.offset + each.offset)});
    row.add("bytes", hex_of(rtuwire::byte_view{frame.bytes}.subspan(each.offset, each.length)));
    row.add("field", each.name).add("value", each.value);
    if (not is_table_) { // no program takes a value out of a damaged frame
        bool const is_value = frame.is_good() and reading.flaw.empty() and not each.label.empty();
        row.add("register", is_value ? cell{each.label} : cell{})
            .add("holds", is_value ? each.holds : cell{})
            .add("measure", is_value and not each.measure.empty() ? cell{each.measure} : cell{});
    }
    results_.put(row);
    is_first_ = false;
}

} // namespace tool
