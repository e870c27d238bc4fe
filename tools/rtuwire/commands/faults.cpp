// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The last fault and those before, with what the drive keeps of its state at each; and the warnings that stand now.
#include <algorithm>
#include <string>
#include <vector>

#include <rtuwire/drives.hpp>

#include "catalog/value_text.hpp"
#include "commands/commands.hpp"
#include "line/line_words.hpp"
#include "line/reading.hpp"
#include "line/who_is_it.hpp"

namespace tool {

namespace {

/// What a drive keeps of the moment of a fault: the mnemonic before the fault's number.
struct kept_value {
    std::string_view name;
    std::string_view prefix;
    bool is_for_people{true}; ///< words of many bits make a table too wide
};

constexpr std::string_view fault_prefix = "DP";
constexpr kept_value kept_values[]{
    {"state", "EP"},           {"extended state", "IP", false},
    {"command", "CMP", false}, {"product", "HS"},
    {"frequency", "RFP"},      {"current", "LCP"},
    {"mains", "ULP"},          {"torque", "OTP"},
    {"motor thermal", "THP"},  {"drive thermal", "TDP"},
    {"running time", "RTP"},
};
constexpr unsigned most_faults = 9;

/// Words of bits that tell of warnings, and what a bit of them is called that is one.
constexpr std::string_view warning_words[]{"CIC", "LRS1", "LRS2", "LRS5", "LRS6", "LRS7"};
constexpr std::string_view warning_marks[]{"alarm",   "threshold",    "warning", "overheat",
                                           "lost",    "undervoltage", "slack",   "external fault",
                                           "changed", "inconsistent", "removed"};

register_entry const* kept(drive_catalog const& drive, std::string_view prefix, unsigned back)
{
    return drive.by_code(std::string{prefix} + std::to_string(back));
}

bool has_any(drive_catalog const& drive, std::string_view prefix)
{
    for (unsigned back = 0; back < most_faults; ++back) {
        if (kept(drive, prefix, back) != nullptr) {
            return true;
        }
    }
    return false;
}

class fault_history {
public:
    explicit fault_history(choices const& chosen)
        : chosen_{chosen}, unit_{unit_in(chosen.line)}, line_{chosen.line},
          drive_{catalog_of(line_, unit_.unit, unit_.drive)}, reader_{registers(), &drive_}
    {}

    exit_status run()
    {
        reader_.read(line_, unit_.unit);
        output results{chosen_.form, false};
        results.put(now());
        for (unsigned back = 0; back < most_faults; ++back) {
            if (register_entry const* const fault = kept(drive_, fault_prefix, back)) {
                results.put(past(*fault, back));
            }
        }
        results.finish();
        return status_of(reader_.at(drive_.layout.lft).error());
    }

private:
    std::vector<chosen_register> registers() const
    {
        std::vector<chosen_register> all{{{drive_.layout.lft}, drive_.at(drive_.layout.lft)},
                                         {{drive_.layout.eta}, drive_.at(drive_.layout.eta)}};
        auto const add = [&all](register_entry const* entry) {
            if (entry != nullptr) {
                all.push_back({{entry->address}, entry});
            }
        };
        for (std::string_view const each : warning_words) {
            add(drive_.by_code(each));
        }
        for (unsigned back = 0; back < most_faults; ++back) {
            add(kept(drive_, fault_prefix, back));
            for (kept_value const& each : kept_values) {
                add(kept(drive_, each.prefix, back));
            }
        }
        return all;
    }

    record begun(std::string const& when, std::uint16_t address)
    {
        reading const fault = reading_of({{address}, drive_.at(address)}, reader_, &drive_);
        record row{{"unit", std::int64_t{unit_.unit.byte()}}, {"when", when}, {"register", fault.label}};
        if (chosen_.form != output_form::table) {
            row.add("raw", fault.raw);
        }
        return row.add("fault", fault.text);
    }

    /// The fault that stands or was the last, the state of now, and what it warns of.
    record now()
    {
        auto const status = reader_.at(drive_.layout.eta);
        std::string state;
        if (status) {
            rtuwire::cia402::state const decoded = rtuwire::cia402::decode(*status);
            state = std::string{std::string_view{name_of(decoded)}};
        } else {
            state = reader_.why_not(drive_.layout.eta);
        }
        bool const is_in_fault = status and rtuwire::cia402::is_in_fault(rtuwire::cia402::decode(*status));
        record row = begun(is_in_fault ? "now, in fault" : "last", drive_.layout.lft);
        add_columns(row, [&](kept_value const& each) { return each.name == "state" ? state : std::string{}; });
        return row.add("warnings", warnings());
    }

    record past(register_entry const& fault, unsigned back)
    {
        record row = begun(back == 0 ? "most recent" : std::to_string(back) + " before", fault.address);
        // What stands beside no fault is the state of no moment.
        auto const code = reader_.at(fault.address);
        bool const is_fault = code and *code != 0;
        add_columns(row, [&](kept_value const& each) {
            return is_fault ? kept_text(kept(drive_, each.prefix, back)) : std::string{};
        });
        return row.add("warnings", std::string{});
    }

    /// Empty where the drive does not keep it.
    std::string kept_text(register_entry const* entry) const
    {
        bool const is_missing =
            entry == nullptr or reader_.at(entry->address).error() == rtuwire::errc::illegal_data_address;
        return is_missing ? std::string{} : reading_of({{entry->address}, entry}, reader_, &drive_).text;
    }

    /// One for each value that this drive keeps of some fault.
    template <typename Text> void add_columns(record& row, Text text_of_column) const
    {
        for (kept_value const& each : kept_values) {
            bool const is_shown = each.is_for_people or chosen_.form != output_form::table;
            if (each.name == "state" or (is_shown and has_any(drive_, each.prefix))) {
                row.add(std::string{each.name}, text_of_column(each));
            }
        }
    }

    std::string warnings() const
    {
        std::string text;
        for (std::string_view const code : warning_words) {
            if (register_entry const* const entry = drive_.by_code(code)) {
                add_warnings(text, *entry);
            }
        }
        return text;
    }

    void add_warnings(std::string& text, register_entry const& entry) const
    {
        auto const word = reader_.at(entry.address);
        for (rtuwire::choice const& bit : entry.choices) {
            std::string_view const meaning = bit.meaning;
            bool const is_set = word and (unsigned{*word} >> bit.word & 1U) != 0;
            if (is_set and std::ranges::any_of(warning_marks, [&](auto mark) { return holds_word(meaning, mark); })) {
                text += (text.empty() ? "" : "; ") + std::string{meaning};
            }
        }
    }

    choices const& chosen_;
    named_unit unit_;
    open_line line_;
    drive_catalog const& drive_;
    register_reader reader_;
};

} // namespace

exit_status run_faults(choices const& chosen) { return fault_history{chosen}.run(); }

} // namespace tool
