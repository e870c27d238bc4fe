// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "words/register_words.hpp"

#include <algorithm>

namespace tool {

namespace {

constexpr std::string_view monitor[]{"ETA", "HMIS", "LFT", "RFR", "RFRD", "SPD", "LCR", "ULN", "THD", "THR"};
constexpr std::string_view status[]{"ETA", "ETI", "ETI2", "HMIS"};
constexpr std::string_view speed[]{"LFR", "LFRD", "FRH", "FRHD", "RFR", "RFRD", "SPD"};
constexpr std::string_view current[]{"LCR", "INV", "NCR", "ITH"};
constexpr std::string_view power[]{"ULN", "UOP", "LCR", "OTR", "OPR"};
constexpr std::string_view thermal[]{"THD", "THR"};
constexpr std::string_view fault[]{"LFT", "ERRD", "DF1", "DF2", "CIC", "DP0", "DP1",
                                   "DP2", "DP3",  "DP4", "DP5", "DP6", "DP7", "DP8"};
constexpr std::string_view inputs[]{"IL1I", "IL1R", "IOLR", "AI1R", "AI2R"};
constexpr std::string_view hours[]{"RTH", "RTHI", "PTH", "TIM"};
constexpr std::string_view ramps[]{"INR", "ACC", "DEC", "AC2", "DE2"};
constexpr std::string_view limits[]{"LSP", "HSP", "TFR"};
constexpr std::string_view motor[]{"UNS", "FRS", "NCR", "NSP", "COS", "NPR", "ITH"};
constexpr std::string_view line[]{"ADD", "TBR", "BDR", "TFO", "TTO", "SLL"};
constexpr std::string_view channels[]{"CHCF", "CD1", "CD2", "FR1", "FR2", "FLO", "TCC"};
constexpr std::string_view identity[]{"NCV", "VCAL", "INV", "VDP", "CPU"};

constexpr register_group all[]{
    {"monitor", "what it is doing", monitor},
    {"status", "its state, in words of bits", status},
    {"speed", "references and what became of them", speed},
    {"current", "motor current, and what is rated", current},
    {"power", "voltages, current, torque and power", power},
    {"thermal", "how warm drive and motor are", thermal},
    {"fault", "the last fault and those before", fault},
    {"inputs", "its inputs", inputs},
    {"hours", "how long it ran", hours},
    {"ramps", "ramp times and their step", ramps},
    {"limits", "lowest and highest frequency", limits},
    {"motor", "the motor's nameplate", motor},
    {"line", "its address, the line and the time-out", line},
    {"channels", "who may command it", channels},
    {"identity", "what it is", identity},
};

} // namespace

std::span<register_group const> register_groups() noexcept { return all; }

std::vector<std::string_view> menu_groups_of(drive_catalog const& drive)
{
    std::vector<std::string_view> groups;
    for (register_entry const& each : drive.registers) {
        if (std::ranges::find(groups, each.group) == groups.end()) {
            groups.push_back(each.group);
        }
    }
    std::ranges::sort(groups);
    return groups;
}

std::vector<std::string_view> all_groups_of(drive_catalog const& drive)
{
    std::vector<std::string_view> names = menu_groups_of(drive);
    for (register_group const& each : register_groups()) {
        bool const has_any =
            std::ranges::any_of(each.codes, [&](std::string_view code) { return drive.by_code(code) != nullptr; });
        if (has_any) {
            names.push_back(each.name);
        }
    }
    return names;
}

} // namespace tool
