// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive's registers as a table, or with --csv for another program: list_registers --drive atv320 [--csv]
#include <csignal>
#include <cstdio>
#include <string>

#include "support/command_line.hpp"
#include "support/standard_descriptors.hpp"

using namespace rtuwire;
using namespace examples;

namespace {

std::string shown(bound const& limit)
{
    if (limit.is_open()) {
        return "";
    }
    if (limit.is_number()) {
        return std::to_string(limit.raw());
    }
    std::string share;
    if (limit.numerator() != limit.denominator()) {
        char factor[16];
        std::snprintf(factor, sizeof factor, "%g*", double(limit.numerator()) / limit.denominator());
        share = factor;
    }
    std::string const factor = std::string{limit.factor()};
    return share + std::string{limit.code()} + (factor.empty() ? "" : "*" + factor);
}

char const* shown(rtuwire::access mode)
{
    switch (mode) {
    case rtuwire::access::read_only: return "r";
    case rtuwire::access::read_write: return "rw";
    case rtuwire::access::configuration: return "conf";
    }
    return "";
}

/// Type, unit and scale, the unit with the prefix in which the manuals count.
struct measure {
    std::string type;
    std::string unit;
    double scale;
};

template <typename T> measure measure_of()
{
    if constexpr (bit_field<T>) {
        return {"bits", "", 0};
    } else if constexpr (register_enumeration<T>) {
        return {"enum", "", 0};
    } else {
        std::string unit = T::dimension::symbol;
        double scale = double(T::scale::num) / double(T::scale::den);
        if (unit == "Hz" and scale > 10) {
            unit = "kHz";
            scale /= 1000;
        } else if (unit == "A" and scale < 0.005) {
            unit = "mA";
            scale *= 1000;
        }
        return {std::is_signed_v<typename T::rep> ? "i16" : "u16", unit, scale};
    }
}

struct row {
    std::string fields[10];
};

template <auto const& R> row row_of()
{
    measure const how = measure_of<value_of<R>>();
    char scale[16] = "";
    if (how.scale > 0) {
        std::snprintf(scale, sizeof scale, "%g", how.scale);
    }
    std::string const factory = R.factory ? std::to_string(*R.factory) : "";
    std::string name = std::string{R.name};
    if (R.source == provenance::inferred) {
        name += " [inferred]";
    }
    if (R.source == provenance::doubtful) {
        name += " [doubtful]";
    }
    if (R.gap.last >= R.gap.first) {
        name += " [never " + std::to_string(R.gap.first) + ".." + std::to_string(R.gap.last) + "]";
    }
    if (R.steps_set_by.size() > 0) {
        name += " [steps set by " + std::string{R.steps_set_by} + "]";
    }
    return {{std::string{R.code}, std::to_string(R.address), shown(R.mode), how.type, how.unit, scale, shown(R.min),
             shown(R.max), factory, name}};
}

/// A field of a line of comma-separated values, quoted as RFC 4180 says.
std::string quoted(std::string const& field)
{
    if (field.find_first_of(",\"\r\n") == std::string::npos) {
        return field;
    }
    std::string text = "\"";
    for (char const each : field) {
        text += each == '"' ? "\"\"" : std::string{each};
    }
    return text + "\"";
}

void print(row const& line, bool as_csv)
{
    constexpr int widths[] = {-6, 6, -5, -5, -4, 6, 8, 8, 8, -1};
    for (int i = 0; i < 10; ++i) {
        if (as_csv) {
            std::printf("%s%s", i > 0 ? "," : "", quoted(line.fields[i]).c_str());
        } else {
            std::printf("%s%*s", i > 0 ? "  " : "", widths[i], line.fields[i].c_str());
        }
    }
    std::puts("");
}

template <typename Device> void list(bool as_csv)
{
    print({{"code", "address", "access", "type", "unit", "scale", "min", "max", "default", "name"}}, as_csv);
    Device::registers::for_each([&]<auto const & R>() { print(row_of<R>(), as_csv); });
}

struct options {
    std::string drive{"atv320"};
    bool as_csv{false};
};

options parse(arguments words)
{
    options chosen;
    while (words.next()) {
        if (words.flag() == "--csv") {
            chosen.as_csv = true;
        } else if (words.flag() == "--drive") {
            chosen.drive = words.value();
        } else {
            words.refuse();
        }
    }
    return chosen;
}

/// Whether all that was printed has left; says why where it has not.
bool is_all_printed()
{
    bool const is_good = std::fflush(stdout) == 0 and std::ferror(stdout) == 0;
    if (not is_good) {
        std::perror("list_registers: standard output");
    }
    return is_good;
}

} // namespace

int main(int argc, char** argv)
{
    keep_standard_descriptors();
    std::signal(SIGPIPE, SIG_IGN); // a reader that went away is told as any other failure
    std::string const usage = std::string{"[--drive "} + drive_names() + "] [--csv]";
    return with_usage("list_registers", usage, argc, argv, [&] {
        options const chosen = parse({argc, argv});
        with_drive(chosen.drive, [&chosen](auto device) { list<typename decltype(device)::type>(chosen.as_csv); });
        return is_all_printed() ? 0 : 1;
    });
}
