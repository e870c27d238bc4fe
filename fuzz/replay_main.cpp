// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Feeds every file of the corpus directories on the command line to the fuzz target it is linked
// with, so that what fuzzing once found stays tested by compilers without libFuzzer.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size);

int main(int argc, char** argv)
{
    std::size_t replayed = 0;
    for (int i = 1; i < argc; ++i) {
        std::error_code unreadable;
        for (auto const& entry : std::filesystem::directory_iterator{argv[i], unreadable}) {
            if (not entry.is_regular_file()) continue;
            std::ifstream file{entry.path(), std::ios::binary};
            std::vector<char> const text{std::istreambuf_iterator<char>{file}, {}};
            std::vector<std::uint8_t> const input{text.begin(), text.end()};
            // The last name printed is the one that crashed.
            std::printf("%s\n", entry.path().filename().string().c_str());
            std::fflush(stdout);
            LLVMFuzzerTestOneInput(input.data(), input.size());
            ++replayed;
        }
    }
    std::printf("%zu inputs replayed\n", replayed);
    return replayed == 0 ? 1 : 0;
}
