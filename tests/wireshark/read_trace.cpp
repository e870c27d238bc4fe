// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Prints the frames of a capture file, as the tool's reader has them: read_trace FILE. A line each: microseconds, direction, role, verdict, bytes.
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <rtuwire/core/hex.hpp>
#include <rtuwire/trace.hpp>

#include "capture/capture_reader.hpp"

using namespace rtuwire;
using namespace tool;

namespace {

std::string string_of(auto const& text) { return {text.begin(), text.end()}; }

void print(captured_frame const& captured)
{
    std::array<char, 800> place{};
    std::string const bytes = string_of(to_hex(captured.frame.bytes, place));
    std::printf("%llu %s %s %s %s\n", static_cast<unsigned long long>(captured.unix_microseconds),
                captured.frame.is_own ? "out" : "in", string_of(name(captured.frame.role)).c_str(),
                string_of(name(captured.frame.verdict)).c_str(), bytes.c_str());
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 2) {
        return 2;
    }
    std::ifstream file{argv[1], std::ios::binary};
    capture_reader reader;
    for (std::array<char, 1000> piece{}; file.read(piece.data(), piece.size()) or file.gcount() > 0;) {
        reader.receive(std::as_bytes(std::span{piece}.first(static_cast<std::size_t>(file.gcount()))));
        while (auto const captured = reader.next()) {
            print(*captured);
        }
    }
    reader.finish();
    auto const [why, offset] = reader.error();
    if (why != capture_errc::none) {
        std::printf("%s at %llu\n", string_of(name(why)).c_str(), static_cast<unsigned long long>(offset));
    }
    return why == capture_errc::none ? 0 : 1;
}
