// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "help/tool_texts.hpp"

#include <string_view>
#include <utility>

namespace tool {

namespace {

constexpr std::pair<std::string_view, std::string_view> examples[] = {
    {"scan", "rtuwire -p /dev/ttyUSB0 scan --find --resume cabinet.scan"},
    {"identify", "rtuwire -p /dev/ttyUSB0 -u 7 identify"},
    {"map", "rtuwire -p /dev/ttyUSB0 -u 61 map input:0-1999 --resume meter.map"},
    {"read", "rtuwire -p /dev/ttyUSB0 -u 7 read RFR 'DP*' @monitor 3202"},
    {"watch", "rtuwire -p /dev/ttyUSB0 -u 7 --csv watch RFR LCR --every 200ms --for 8h > night.csv"},
    {"monitor", "rtuwire -p /dev/ttyUSB0 --name fan=7 --name meter=61:meter.toml monitor --plot RFR"},
    {"list", "rtuwire list --drive atv320 --search ramp"},
    {"explain", "rtuwire explain ACC --drive atv320"},
    {"faults", "rtuwire -p /dev/ttyUSB0 -u 7 faults"},
    {"write", "rtuwire -p /dev/ttyUSB0 -u 7 --write write ACC=1.3s"},
    {"ask", "rtuwire -p /dev/ttyUSB0 -u 7 ask 03 0C820001"},
    {"backup", "rtuwire -p /dev/ttyUSB0 -u 7 backup -o fan.json"},
    {"compare", "rtuwire -p /dev/ttyUSB0 -u 7 compare fan.json"},
    {"restore", "rtuwire -p /dev/ttyUSB0 -u 7 --write restore fan.json --dry-run"},
    {"start", "rtuwire -p /dev/ttyUSB0 -u 7 --allow-run start --frequency 40Hz --for 10s"},
    {"stop", "rtuwire -p /dev/ttyUSB0 -u 7 stop"},
    {"reset", "rtuwire -p /dev/ttyUSB0 -u 7 --write reset"},
    {"sniff", "rtuwire -p /dev/ttyUSB0 sniff --for 10s"},
    {"capture", "rtuwire -p /dev/ttyUSB0 capture -o line.pcapng --for 5min"},
    {"replay", "rtuwire replay line.pcapng"},
    {"timing", "rtuwire timing line.pcapng"},
    {"check", "rtuwire -p /dev/ttyUSB0 -u 61 check --junit check.xml"},
    {"chaos", "rtuwire chaos --from pty --to /dev/ttyUSB0 --faults late=1%,lost@250 --dry"},
    {"serve", "rtuwire -p /dev/ttyUSB0 serve --units 1-4,7 --metrics 127.0.0.1:9502"},
    {"gateway", "rtuwire gateway gateway.toml --check"},
    {"decode", "rtuwire decode 07 03 0C 82 00 01 27 14"},
    {"simulate", "rtuwire simulate atv320:7 atv12:3"},
    {"ports", "rtuwire ports"},
    {"device", "rtuwire device import config-sdm120.json -o sdm120.toml; rtuwire device check sdm120.toml"},
    {"completion", "rtuwire completion bash > ~/.local/share/bash-completion/completions/rtuwire"},
    {"man", "rtuwire man > ~/.local/share/man/man1/rtuwire.1"},
};

} // namespace

std::string example_of(std::string const& command)
{
    for (auto const& [name, example] : examples) {
        if (name == command) {
            return std::string{example};
        }
    }
    return {};
}

std::string first_steps_text()
{
    return "A device of which nothing is known; each step ends with the next one:\n"
           "  1. rtuwire ports                                  which port is the adapter?\n"
           "  2. rtuwire -p /dev/ttyUSB0 scan                   at which bit rate, format and address does who "
           "answer?\n"
           "     rtuwire -p /dev/ttyUSB0 sniff --find           the first two where a client talks to it; sends "
           "nothing\n"
           "  3. rtuwire -p /dev/ttyUSB0 -b 9600 -f 8N2 -u 61 map    which addresses has it?\n"
           "  4. ... read input:1000:f32 input:1000:f32:cdab    what is there? One value in several forms\n"
           "  5. rtuwire device --help                          a register file gives it a name, a type and a unit\n"
           "  6. ... --device meter.toml watch '*'              its values by their names\n\n";
}

std::string places_text()
{
    return "[space:]where[:type][:order][:scale]     input:40:f32:cdab  40-43:u32:0.1V  coil:3\n"
           "  space  holding (as without one), input, coil, discrete, or h i c d; list:40001 is holding:0,\n"
           "         list:30001 input:0, list:10001 discrete:0, list:1 coil:0\n"
           "  where  40, 0x28, 40-43; bits 40.3, 40.4-7 (one number)\n"
           "  type   u16 i16 u32 i32 u64 i64 f32 f64 bcd16 bcd32 text20 bits hex\n"
           "  order  abcd (as without one), cdab (low word first), badc, dcba; of 64 bits eight letters, too\n"
           "  scale  0.1, 0.1V, 0.01m3/h, 0.1degC-50: times, unit, what is added then\n";
}

std::string register_file_text()
{
    return "A register file is TOML: for each register a table\n"
           "  [[register]]\n"
           "  name = \"voltage_l1\"   letters, digits and _\n"
           "  space = \"input\"       holding (as without it), input, coil, discrete; list: the address is of a list\n"
           "  address = 1000\n"
           "  bits = \"4-7\"          one number of some bits, or \"3\"\n"
           "  type = \"f32\"          order = \"cdab\", scale = 0.1, unit = \"V\", offset = -50: as those of a place\n"
           "  access = \"write\"      else it is only read;  min = 0  max = 400: what is written, in the unit\n"
           "  choices = { off = 0, heat = 1 }   all that it may be, by name;  invalid = 0x7FFF: it has no value\n"
           "  setting = true        it is backed up and restored;  stored = true: a write wears the unit's memory\n"
           "  moves = true          it moves something: never written without --allow-run\n"
           "  group = \"slow\"        @slow means all of it\n"
           "  simulated = 230.1     with what simulate begins\n"
           "and for the whole device\n"
           "  [groups]              slow = \"5min\": how often watch reads a group\n"
           "  [device]              max_registers = 16: of one request;  pause = 50: ms before each;\n"
           "                        vendor, product: what it says of itself\n";
}

} // namespace tool
