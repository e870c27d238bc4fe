// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "files/whole_file.hpp"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "files/regular_file.hpp"

namespace tool {

namespace {

/// A file of a name of its own, which is gone unless it was given its place.
class file_beside {
public:
    explicit file_beside(std::string const& path) : name_{path + ".XXXXXX"}, descriptor_{::mkstemp(name_.data())} {}
    file_beside(file_beside const&) = delete;
    file_beside& operator=(file_beside const&) = delete;
    ~file_beside()
    {
        if (descriptor_ >= 0) {
            ::close(descriptor_);
            ::unlink(name_.c_str());
        }
    }

    bool is_open() const { return descriptor_ >= 0; }

    bool write(std::string_view text)
    {
        while (not text.empty()) {
            ssize_t const written = ::write(descriptor_, text.data(), text.size());
            if (written < 0 and errno != EINTR) {
                return false;
            }
            text.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
        }
        return ::fsync(descriptor_) == 0;
    }

    /// With the rights of the file that it replaces, or those of a new one.
    bool take_place_of(std::string const& path)
    {
        struct stat before {};
        mode_t const mask = ::umask(0);
        ::umask(mask);
        mode_t const rights = ::stat(path.c_str(), &before) == 0 ? before.st_mode & 0777U : 0666U & ~mask;
        if (::fchmod(descriptor_, rights) != 0 or ::rename(name_.c_str(), path.c_str()) != 0) {
            return false;
        }
        ::close(descriptor_);
        descriptor_ = -1;
        return true;
    }

    /// Under a name that nothing has.
    bool take_place_at(std::string const& path)
    {
        mode_t const mask = ::umask(0);
        ::umask(mask);
        return ::fchmod(descriptor_, 0666U & ~mask) == 0 and ::link(name_.c_str(), path.c_str()) == 0;
    }

private:
    std::string name_;
    int descriptor_;
};

} // namespace

std::string write_whole_file(std::string const& path, std::string_view text)
{
    if (std::string const why = why_no_regular_file(path); not why.empty()) {
        return why;
    }
    file_beside file{path};
    bool const is_written = file.is_open() and file.write(text) and file.take_place_of(path);
    return is_written ? std::string{} : std::strerror(errno);
}

std::string write_new_file(std::string const& path, std::string_view text)
{
    file_beside file{path};
    bool const is_written = file.is_open() and file.write(text) and file.take_place_at(path);
    return is_written ? std::string{} : errno == EEXIST ? "is there already" : std::strerror(errno);
}

} // namespace tool
