// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "messages/published_record.hpp"

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

std::string file_in(std::string const& folder) { return folder + "/published.json"; }

/// What all gateways of a folder have noted; `failure`: why it is not known.
nlohmann::json all_in(std::string const& folder, std::string& failure)
{
    file_text const found = text_of_file(file_in(folder));
    if (not found.failure.empty()) {
        failure = found.is_missing ? std::string{} : file_in(folder) + ": " + found.failure;
        return nlohmann::json::object();
    }
    nlohmann::json all = nlohmann::json::parse(found.text, nullptr, false);
    if (not all.is_object()) {
        failure = file_in(folder) + ": is no list of topics, and is begun anew";
        return nlohmann::json::object();
    }
    return all;
}

} // namespace

published_record::published_record(std::string folder, std::string owner)
    : folder_{std::move(folder)}, owner_{std::move(owner)}
{
    std::error_code ignored; // where it cannot be made, what follows tells
    std::filesystem::create_directories(folder_, ignored);
    nlohmann::json const all = all_in(folder_, failure_);
    auto const own = all.find(owner_);
    if (own == all.end() or not own->is_array()) {
        return;
    }
    for (nlohmann::json const& each : *own) {
        if (each.is_string()) {
            topics_.insert(each.get<std::string>());
        }
    }
}

void published_record::keep(std::set<std::string> topics)
{
    if (topics == topics_ and failure_.empty()) {
        return;
    }
    topics_ = std::move(topics);
    held_folder const held{folder_};
    if (not held.is_held()) {
        failure_ = folder_ + ": " + std::strerror(errno);
        return;
    }
    std::string ignored;
    nlohmann::json all = all_in(folder_, ignored);
    all[owner_] = topics_;
    if (topics_.empty()) {
        all.erase(owner_);
    }
    std::string const why =
        write_whole_file(file_in(folder_), all.dump(1, ' ', true, nlohmann::json::error_handler_t::replace) + '\n');
    failure_ = why.empty() ? std::string{} : file_in(folder_) + ": " + why;
}

} // namespace tool::gateway
