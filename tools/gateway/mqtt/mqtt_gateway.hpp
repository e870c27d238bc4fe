// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The gateway as it runs: lines in threads of their own, and this one, which alone knows the broker.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gateway_file.hpp"
#include "messages/published_record.hpp"
#include "messages/publisher.hpp"
#include "messages/reconnect_pauses.hpp"
#include "mqtt/connection.hpp"
#include "mqtt/gateway_log.hpp"
#include "mqtt/wake_up.hpp"
#include "running_line.hpp"
#include "stored_writes.hpp"

namespace tool::gateway {

struct gateway_choices {
    std::string file{"/etc/rtuwire/gateway.toml"};
    bool may_write{false};
    bool has_json{false};
};

/// The plan of the file, checked with all that it names. Ends the command at the first thing that is wrong.
gateway_plan checked_plan(std::string const& file);

class mqtt_gateway {
public:
    /// Begins its lines.
    mqtt_gateway(gateway_choices const& chosen, gateway_plan plan);

    /// Until a signal asks for the end.
    void run();

private:
    using clock = publisher::clock;

    /// The password is that of its file when the plan is read.
    struct plan_with_password {
        gateway_plan plan;
        std::string password;
    };

    /// Reads the file; what goes by that is to end.
    void reload();
    /// That has ended.
    void take_next();
    void take_plan(plan_with_password next);
    [[nodiscard]] std::vector<line_feed> feeds() const;
    void connect();
    void look_at_lines();
    void look_at(running_line& line);
    void look_at_connection();
    void take(arrived_message const& message);
    void take_setting(setting_topic const& topic, arrived_message const& message);
    void answer(setting_topic const& topic, std::string const& id, setting_result result, std::string const& why);
    void publish_all();
    /// Waits for the connection or for news.
    void wait(std::chrono::milliseconds longest);
    /// Says that everything is offline, and ends the connection.
    void finish_connection();
    void lose_connection();
    void tell_away(std::string const& why);
    void keep_record();
    void tell_damage();
    void tell(std::string name, std::string text) const;
    [[nodiscard]] std::string broker_name() const;

    gateway_choices chosen_;
    gateway_log log_;
    std::shared_ptr<wake_up> news_{std::make_shared<wake_up>()}; ///< a thread that is left behind rings it, too
    mqtt_library library_{};
    gateway_plan plan_;
    std::string password_{};
    std::optional<plan_with_password> next_{};                   ///< waits for lines that end
    std::vector<std::shared_ptr<line_plan const>> line_plans_{}; ///< of `lines_`, which may be older than the plan
    stored_writes stored_;
    running_lines lines_;
    published_record record_;
    publisher publisher_;
    reconnect_pauses pauses_;
    std::unique_ptr<connection> connection_{};
    clock::time_point next_try_{};
    clock::time_point connected_at_{};
    bool is_connected_{false};
    bool is_old_broker_{false}; ///< it is spoken to by MQTT 3.1.1
    std::string told_{};        ///< why the broker is away, as it was told
    std::string told_record_{}; ///< the same of the record
};

} // namespace tool::gateway
