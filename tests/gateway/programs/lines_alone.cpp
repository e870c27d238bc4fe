// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The lines of a gateway without a broker, for as long as it is told: what they did, as one JSON object.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <thread>

#include "running_line.hpp"

int main(int argc, char** argv)
try {
    using namespace tool::gateway;
    if (argc != 3) {
        std::fprintf(stderr, "lines_alone GATEWAY.TOML SECONDS\n");
        return 2;
    }
    stored_writes stored{std::filesystem::temp_directory_path(), argv[1], 0, {}}; // nothing is written
    running_lines lines{false, stored, [] {}};
    lines.apply(gateway_file_at(argv[1]));
    std::this_thread::sleep_for(std::chrono::duration<double>{std::atof(argv[2])});
    unsigned long available = 0, devices = 0, rounds = 0;
    line_state all;
    for (auto const& line : lines.all()) {
        line_state const state = line->state();
        all.requests += state.requests;
        all.silences += state.silences;
        all.errors += state.errors;
        all.overruns += state.overruns;
        for (std::size_t i = 0; i < line->plan().devices.size(); ++i) {
            device_slot::content const now = line->device(i);
            ++devices;
            available += now->is_available ? 1U : 0U;
            rounds += now->seq;
        }
    }
    std::printf("{\"devices\": %lu, \"available\": %lu, \"rounds\": %lu, \"requests\": %llu, \"silences\": %llu, "
                "\"errors\": %llu, \"overruns\": %llu}\n",
                devices, available, rounds, static_cast<unsigned long long>(all.requests),
                static_cast<unsigned long long>(all.silences), static_cast<unsigned long long>(all.errors),
                static_cast<unsigned long long>(all.overruns));
    return 0;
} catch (std::exception const& why) {
    std::fprintf(stderr, "lines_alone: %s\n", why.what());
    return 2;
}
