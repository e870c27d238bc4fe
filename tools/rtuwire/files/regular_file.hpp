// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Files that this program reads as a whole and adds to: regular ones. A device, a pipe or a directory of that name is
// refused with its reason, before it is opened: it may have no end, or keep the program waiting.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

namespace tool {

/// Why a path is none: "is a directory"; empty where it is one, or where nothing is there yet.
std::string why_no_regular_file(std::string const& path);

/// What a file holds, or why it could not be read.
struct file_text {
    std::string text{};
    std::string failure{}; ///< empty where it was read
    bool is_missing{false};
};

/// Reads a regular file of at most 64 MiB.
file_text text_of_file(std::string const& path);

/// What a file of --resume holds; empty where it is not there yet. Ends the command where it cannot be read.
std::string text_to_resume(std::string const& path);

/// A regular file to whose end is added; each addition is in the file when `write` returns, as a whole or not at all.
class appended_file {
public:
    appended_file() = default;
    explicit appended_file(std::string const& path);

    void write(std::string const& text);
    /// Keeps room for so many bytes behind its end, where its file system can: an addition fails now, not then.
    void reserve(std::size_t size);
    /// Whether it is empty or ends with a line's end.
    bool ends_with_line() const;
    /// Why it was not opened or not written, or has no room; empty where all went well.
    std::string const& failure() const { return failure_; }

private:
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{nullptr, &std::fclose};
    std::string failure_{};
};

} // namespace tool
