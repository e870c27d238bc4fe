// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The topics of one gateway, rtuwire/SITE/GATEWAY/...: which are made, and what one that came says.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tool::gateway {

/// What is wrong with a word as a part of topics; empty where nothing is.
[[nodiscard]] std::string why_no_topic_part(std::string_view word);

/// Which register a message on `set/NAME` is for.
struct setting_topic {
    std::string line;
    std::string device;
    std::string name;

    friend bool operator==(setting_topic const&, setting_topic const&) = default;
};

class topics {
public:
    topics(std::string const& site, std::string const& gateway) : root_{"rtuwire/" + site + '/' + gateway} {}

    /// "rtuwire/SITE/GATEWAY".
    [[nodiscard]] std::string const& root() const { return root_; }
    /// "online" or "offline", also by the last will.
    [[nodiscard]] std::string status() const { return root_ + "/status"; }
    /// The heartbeat of a line.
    [[nodiscard]] std::string status(std::string const& line) const { return root_ + '/' + line + "/status"; }
    [[nodiscard]] std::string availability(std::string const& line) const
    {
        return root_ + '/' + line + "/availability";
    }
    [[nodiscard]] std::string availability(std::string const& line, std::string const& device) const
    {
        return of(line, device) + "availability";
    }
    [[nodiscard]] std::string state(std::string const& line, std::string const& device) const
    {
        return of(line, device) + "state";
    }
    [[nodiscard]] std::string setting(setting_topic const& of_what) const
    {
        return of(of_what.line, of_what.device) + "set/" + of_what.name;
    }
    [[nodiscard]] std::string answer(setting_topic const& of_what) const
    {
        return of(of_what.line, of_what.device) + "answer/" + of_what.name;
    }

    /// All that is subscribed for settings.
    [[nodiscard]] std::string all_settings() const { return root_ + "/+/+/set/+"; }
    /// What a topic of these is for; nothing where it is another.
    [[nodiscard]] std::optional<setting_topic> setting_in(std::string_view topic) const;

private:
    [[nodiscard]] std::string of(std::string const& line, std::string const& device) const
    {
        return root_ + '/' + line + '/' + device + '/';
    }

    std::string root_;
};

} // namespace tool::gateway
