// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "files/regular_file.hpp"

#include <array>
#include <cerrno>
#include <cstring>

#include <sys/stat.h>

namespace tool {

namespace {

constexpr std::size_t largest_file = 64U << 20U;

using open_file = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

std::string kind_of(mode_t mode)
{
    return S_ISDIR(mode)    ? "is a directory"
           : S_ISFIFO(mode) ? "is a pipe"
           : S_ISSOCK(mode) ? "is a socket"
                            : "is a device";
}

} // namespace

std::string why_no_regular_file(std::string const& path)
{
    struct stat found {};
    if (path.empty() or ::stat(path.c_str(), &found) != 0) {
        return path.empty() or errno == ENOENT ? std::string{} : std::strerror(errno);
    }
    return S_ISREG(found.st_mode) ? std::string{} : kind_of(found.st_mode) + ", no regular file";
}

file_text text_of_file(std::string const& path)
{
    if (std::string const why = why_no_regular_file(path); not why.empty()) {
        return {{}, why};
    }
    open_file const file{std::fopen(path.c_str(), "rbe"), &std::fclose};
    if (not file) {
        return {{}, std::strerror(errno), errno == ENOENT};
    }
    file_text found;
    std::array<char, 65'536> piece;
    for (std::size_t size = 0; (size = std::fread(piece.data(), 1, piece.size(), file.get())) > 0;) {
        found.text.append(piece.data(), size);
        if (found.text.size() > largest_file) {
            return {{}, "is larger than 64 MiB"};
        }
    }
    return std::ferror(file.get()) != 0 ? file_text{{}, std::strerror(errno)} : found;
}

appended_file::appended_file(std::string const& path) : failure_{why_no_regular_file(path)}
{
    if (failure_.empty()) {
        file_.reset(std::fopen(path.c_str(), "abe"));
        failure_ = file_ ? "" : std::strerror(errno);
    }
}

void appended_file::write(std::string const& text)
{
    if (file_ and
        (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() or std::fflush(file_.get()) != 0)) {
        failure_ = std::strerror(errno);
    }
}

} // namespace tool
