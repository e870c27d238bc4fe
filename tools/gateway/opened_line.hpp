// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line of the gateway on its port, in real time.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "asked_line.hpp"
#include "line/open_line.hpp"
#include "line/register_reader.hpp"
#include "line_clients.hpp"
#include "motion/value_sender.hpp"
#include "words/value_words.hpp"

namespace tool::gateway {

class opened_line final : public asked_line, private port_attendant {
public:
    /// While a response is waited for the loop shows so often that it runs.
    static constexpr std::chrono::milliseconds beat_period{500};

    /// `tell` takes what there is to know of clients.
    opened_line(line_plan const& plan, std::function<void(std::string const&)> tell);

    /// By another file; the connections of its clients end.
    void serve(std::optional<serve_choices> const& by);

    clock::time_point now() const override { return clock::now(); }
    std::uint64_t unix_time() const override;
    void wait(clock::time_point until) override;
    void serve_one() override;
    bool is_left_alone(std::size_t device) const override;
    void keep_turn(std::size_t device) override;
    void open() override;
    void close() override;
    device_finding identify(std::size_t device, bool is_known_silent) override;
    part_reading read(std::size_t part) override;
    std::optional<setting_outcome> write(waiting_setting const& setting, bool goes_on,
                                         setting_look const& last_look) override;
    std::optional<client_counts> clients() const override
    {
        return clients_ ? std::optional{clients_->counts()} : std::nullopt;
    }
    exchange_counts const& counts() const override { return counts_; }

private:
    struct read_part {
        device_part what;
        register_reader reader;
        bool has_responded{false}; ///< in an earlier turn of its reading

        void begin_anew()
        {
            reader.begin_anew();
            has_responded = false;
        }
    };

    /// In turns.
    device_finding look_at(std::size_t device, bool is_known_silent);
    void wait(int descriptor, rtuwire::instant until) override;
    bool is_over() const override { return false; }
    bool may_send() const override { return sent_ == nullptr or not sent_->is_expired(now(), unix_time()); }
    bool wait_for_bytes(int descriptor, std::chrono::microseconds time);
    void note_asked(device_plan const& device);
    /// While what a device owes may come, clients ask it nothing of which that could be taken for the answer.
    void hold_clients(device_plan const& device);
    void note_outcome(device_plan const& device, bool has_responded);
    /// Whether what answers there is what the file says.
    device_finding who_answers(std::size_t device);
    /// The same in a turn: it runs from its begin each time.
    setting_outcome set(waiting_setting const& setting, setting_look const& last_look);
    /// Where the port failed: what became of the setting is nobody else's reason.
    setting_outcome lost(std::string why, bool was_sent);
    /// In one turn, whatever comes.
    setting_outcome send(waiting_setting const& setting, value_list const& values, write_rules const& rules,
                         held_words const& before, setting_look const& last_look);
    slot_value value_of(device_plan const& device, device_value const& value, register_reader const& from) const;

    line_plan const& plan_;
    std::function<void(std::string const&)> tell_;
    std::vector<read_part> parts_{};
    std::vector<bool> has_said_;            ///< of each device with a `vendor`: it has said once that it is that
    std::vector<earlier_turns> looks_;      ///< at each device, that are not through
    std::vector<earlier_turns> settings_;   ///< of each device, the same
    waiting_setting const* sent_{nullptr};  ///< no frame of it leaves once it has expired
    std::optional<line_clients> clients_{}; ///< outlive the line
    std::optional<open_line> line_{};
    exchange_counts counts_{};
};

} // namespace tool::gateway
