// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "files/whole_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <random>

#include "../support/platform.hpp"
#include "files/regular_file.hpp"

namespace tool {

namespace {

/// What Windows says of a file, as the C library says it.
std::string words_of(DWORD why)
{
    return why == ERROR_FILE_EXISTS or why == ERROR_ALREADY_EXISTS      ? "is there already"
           : why == ERROR_ACCESS_DENIED                                 ? "Permission denied"
           : why == ERROR_SHARING_VIOLATION                             ? "another program has it open"
           : why == ERROR_PATH_NOT_FOUND or why == ERROR_FILE_NOT_FOUND ? "No such file or directory"
           : why == ERROR_DISK_FULL or why == ERROR_HANDLE_DISK_FULL    ? "No space left on device"
                                                                        : "Windows error " + std::to_string(why);
}

/// A file of a name of its own, which is gone unless it was given its place.
class file_beside {
public:
    explicit file_beside(std::string const& path)
        : name_{std::filesystem::path{path + "." + std::to_string(std::random_device{}())}.wstring()},
          handle_{::CreateFileW(name_.c_str(), GENERIC_WRITE, 0, nullptr, CREATE_NEW, FILE_ATTRIBUTE_NORMAL, nullptr)}
    {}
    file_beside(file_beside const&) = delete;
    file_beside& operator=(file_beside const&) = delete;
    ~file_beside()
    {
        close();
        if (not is_placed_) {
            ::DeleteFileW(name_.c_str());
        }
    }

    bool write(std::string_view text)
    {
        while (handle_ != INVALID_HANDLE_VALUE and not text.empty()) {
            DWORD count = 0;
            if (::WriteFile(handle_, text.data(), static_cast<DWORD>(text.size()), &count, nullptr) == 0) {
                return false;
            }
            text.remove_prefix(count);
        }
        return handle_ != INVALID_HANDLE_VALUE and ::FlushFileBuffers(handle_) != 0;
    }

    /// How: whether it replaces one of that name.
    bool take_place_at(std::string const& path, DWORD how)
    {
        close();
        is_placed_ =
            ::MoveFileExW(name_.c_str(), std::filesystem::path{path}.c_str(), how | MOVEFILE_WRITE_THROUGH) != 0;
        return is_placed_;
    }

private:
    void close()
    {
        if (handle_ != INVALID_HANDLE_VALUE) {
            ::CloseHandle(handle_);
        }
        handle_ = INVALID_HANDLE_VALUE;
    }

    std::wstring name_;
    HANDLE handle_;
    bool is_placed_{false};
};

std::string write_beside(std::string const& path, std::string_view text, DWORD how)
{
    file_beside file{path};
    return file.write(text) and file.take_place_at(path, how) ? std::string{} : words_of(::GetLastError());
}

} // namespace

std::string write_whole_file(std::string const& path, std::string_view text)
{
    std::string const why = why_no_regular_file(path);
    return why.empty() ? write_beside(path, text, MOVEFILE_REPLACE_EXISTING) : why;
}

std::string write_new_file(std::string const& path, std::string_view text) { return write_beside(path, text, 0); }

} // namespace tool
