// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "state_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "files/regular_file.hpp"
#include "files/whole_file.hpp"

namespace tool::gateway {

namespace {

using nlohmann::json;

/// Keeps other gateways of the same folder away, while it lives.
class held_folder {
public:
    explicit held_folder(std::string const& folder)
        : descriptor_{::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)}
    {
        is_held_ = descriptor_ >= 0 and ::flock(descriptor_, LOCK_EX) == 0;
    }
    held_folder(held_folder const&) = delete;
    held_folder& operator=(held_folder const&) = delete;
    ~held_folder()
    {
        if (descriptor_ >= 0) {
            ::close(descriptor_);
        }
    }

    bool is_held() const { return is_held_; }

private:
    int descriptor_;
    bool is_held_;
};

} // namespace

state_file::state_file(std::string folder, std::string_view name, std::string owner)
    : folder_{std::move(folder)}, path_{folder_ + '/' + std::string{name}}, owner_{std::move(owner)}
{
    std::error_code ignored; // where it cannot be made, what follows tells
    std::filesystem::create_directories(folder_, ignored);
}

json state_file::read(bool (*is_right)(json const& own))
{
    json all = read_all();
    auto const own = all.find(owner_);
    if (own == all.end()) {
        return nullptr;
    }
    if (not is_right(*own)) {
        put_aside(all.dump(1, ' ', true, json::error_handler_t::replace), "what it says of " + owner_ + " is damaged");
        return nullptr;
    }
    return std::move(*own);
}

json state_file::read_all()
{
    file_text const found = text_of_file(path_);
    bool const is_read = found.failure.empty() or found.is_missing;
    failure_ = is_read ? std::string{} : path_ + ": " + found.failure;
    if (not found.failure.empty()) {
        return json::object();
    }
    json all = json::parse(found.text, nullptr, false);
    if (not all.is_object()) {
        put_aside(found.text, "it is damaged");
        return json::object();
    }
    return all;
}

void state_file::put_aside(std::string const& text, std::string const& why)
{
    std::string const aside = path_ + ".damaged";
    std::string const failure = write_whole_file(aside, text);
    damage_ = path_ + ": " + why + ", and begun anew; what it held is " +
              (failure.empty() ? "kept in " + aside : "lost, as " + aside + " cannot be written: " + failure);
}

std::string state_file::write(json const& own)
{
    held_folder const held{folder_};
    if (not held.is_held()) {
        return folder_ + ": " + std::strerror(errno);
    }
    json all = read_all();
    if (not failure_.empty()) { // it may hold what others noted
        return failure_;
    }
    all[owner_] = own;
    if (own.is_null()) {
        all.erase(owner_);
    }
    std::string const why = write_whole_file(path_, all.dump(1, ' ', true, json::error_handler_t::replace) + '\n');
    return why.empty() ? std::string{} : path_ + ": " + why;
}

std::string state_file::take_damage() { return std::exchange(damage_, {}); }

} // namespace tool::gateway
