// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which topics the broker keeps for this gateway, on the disk: so that a device that has left the file is taken back also by
// the next process. They are noted before they are published.
#pragma once

#include <set>
#include <string>

#include "state_file.hpp"

namespace tool::gateway {

class published_record {
public:
    /// `owner`: the gateway's file, as several gateways may share a folder.
    published_record(std::string folder, std::string owner);

    [[nodiscard]] std::set<std::string> const& topics() const { return topics_; }
    /// Why it is not on the disk; empty while it is.
    [[nodiscard]] std::string const& failure() const { return failure_; }
    /// As of `state_file`.
    [[nodiscard]] std::string take_damage() { return file_.take_damage(); }

    /// Notes these, and no others.
    void keep(std::set<std::string> topics);

private:
    state_file file_;
    std::set<std::string> topics_{};
    std::string failure_{};
};

} // namespace tool::gateway
