// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "files/regular_file.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <sys/stat.h>

#include "../support/platform.hpp"
#include "exit_status.hpp"

namespace tool {

namespace {

constexpr std::size_t largest_file = 64U << 20U;

using open_file = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

std::string kind_of(mode_t mode)
{
#ifdef S_ISSOCK
    if (S_ISSOCK(mode)) {
        return "is a socket";
    }
#endif
    return S_ISDIR(mode) ? "is a directory" : S_ISFIFO(mode) ? "is a pipe" : "is a device";
}

off_t size_of(int file)
{
    struct stat found {};
    return ::fstat(file, &found) == 0 ? found.st_size : 0;
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
    open_file const file{stream_to_read(path), &std::fclose};
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
    if (std::ferror(file.get()) != 0) {
        return {{}, errno == EAGAIN ? "has no end: it waits for more" : std::strerror(errno)};
    }
    return found;
}

std::string text_to_resume(std::string const& path)
{
    file_text kept = text_of_file(path);
    if (not kept.failure.empty() and not kept.is_missing) {
        refuse_word("--resume " + path + ": " + kept.failure);
    }
    return std::move(kept.text);
}

appended_file::appended_file(std::string const& path) : failure_{why_no_regular_file(path)}
{
    if (failure_.empty()) {
        file_.reset(open_stream(path, "a+b"));
        failure_ = file_ ? "" : std::strerror(errno);
    }
}

void appended_file::write(std::string const& text)
{
    if (not file_) {
        return;
    }
    int const file = ::fileno(file_.get());
    off_t const begin = size_of(file);
    std::size_t done = 0;
    while (done < text.size()) {
        std::ptrdiff_t const added = write_some(file, std::string_view{text}.substr(done));
        if (added < 0 and errno == EINTR) {
            continue;
        }
        if (added <= 0) {
            failure_ = std::strerror(errno);
            bool const is_alone = size_of(file) == begin + static_cast<off_t>(done);
            if (done > 0 and is_alone and ::ftruncate(file, begin) != 0) {
                failure_ += ", and a part of it stands there";
            }
            return;
        }
        done += static_cast<std::size_t>(added);
    }
}

void appended_file::reserve(std::size_t size)
{
    if (not file_) {
        return;
    }
    if (int const why = reserve_room(file_.get(), size_of(::fileno(file_.get())), size); why != 0) {
        failure_ = std::strerror(why);
    }
}

bool appended_file::ends_with_line() const
{
    if (not file_) {
        return true;
    }
    int const file = ::fileno(file_.get());
    char last = '\n';
    return size_of(file) == 0 or ::lseek(file, -1, SEEK_END) < 0 or ::read(file, &last, 1) != 1 or last == '\n';
}

} // namespace tool
