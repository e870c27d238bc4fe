// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "messages/published_record.hpp"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

namespace tool::gateway {

namespace {

using nlohmann::json;

bool is_list_of_topics(json const& own) { return own.is_array() and std::ranges::all_of(own, &json::is_string); }

} // namespace

published_record::published_record(std::string folder, std::string owner)
    : file_{std::move(folder), "published.json", std::move(owner)}
{
    for (json const& each : file_.read(is_list_of_topics)) {
        topics_.insert(each.get<std::string>());
    }
    failure_ = file_.failure();
}

void published_record::keep(std::set<std::string> topics)
{
    if (topics == topics_ and failure_.empty()) {
        return;
    }
    topics_ = std::move(topics);
    failure_ = file_.write(topics_.empty() ? json{} : json(topics_));
}

} // namespace tool::gateway
