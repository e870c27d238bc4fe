// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One connection to a broker, from its beginning to its end, by libmosquitto in the thread of whoever calls: what one leaves
// unsent is gone with it, and never comes by the next.
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "gateway_file.hpp"
#include "messages/publisher.hpp"

struct mosquitto;
struct mosquitto_message;
struct mqtt5__property;

namespace tool::gateway {

struct arrived_message {
    std::string topic;
    std::string text;
    bool is_retained;
    bool is_connected; ///< the connection was complete when it came
};

/// What a connection is made with.
struct connection_choices {
    broker_choices broker;
    std::string password;
    std::string client; ///< the name of the client
    std::string status; ///< the topic of the last will, "offline"
    std::vector<std::string> subscribed;
    bool is_old{false}; ///< by MQTT 3.1.1: the broker knows no 5
};

class connection {
public:
    static constexpr int keep_alive = 5; ///< seconds
    /// After a response, until the broker is asked again whether it takes anything; by more than its keep-alive, which comes
    /// too late to keep values from a broker that hangs.
    static constexpr std::chrono::seconds probe_pause{2};
    /// It is given nothing while it owes its response for longer.
    static constexpr std::chrono::seconds longest_trust{1};
    static constexpr std::chrono::seconds longest_silence{5};
    /// From its beginning until the broker says that it is one.
    static constexpr std::chrono::seconds longest_beginning{10};

    /// Begins; where that fails it has ended. The library looks the host's name up itself, as long as a name server takes: that is
    /// done in a thread, which is left behind where this goes before; `on_news` is called from there once it is over, and may
    /// neither block nor throw.
    connection(connection_choices const& chosen, std::function<void()> on_news);
    connection(connection const&) = delete;
    connection& operator=(connection const&) = delete;
    ~connection();

    [[nodiscard]] bool has_ended() const { return has_ended_; }
    /// Why, for people.
    [[nodiscard]] std::string const& why_ended() const { return why_; }
    /// Whether the broker has accepted it.
    [[nodiscard]] bool is_open() const { return is_accepted_ and not has_ended_; }
    /// Whether the host's name is looked up for longer than a beginning should take; it goes on.
    [[nodiscard]] bool is_name_late() const;
    /// Whether all that was subscribed is.
    [[nodiscard]] bool is_subscribed() const { return is_open() and subscribing_ == 0; }
    /// Whether the broker has refused a part of that: who it is may not.
    [[nodiscard]] bool is_subscription_refused() const { return is_subscription_refused_; }
    /// Whether the broker knows only the protocol before.
    [[nodiscard]] bool is_too_new() const { return is_too_new_; }
    /// Whether a message leaves at once: none waits before it, and the broker responds.
    [[nodiscard]] bool may_publish() const;
    /// Whether little of what was published is on its way, so that a value reaches a slow broker while it is new.
    [[nodiscard]] bool is_idle() const;

    /// What to wait for; -1: nothing.
    [[nodiscard]] int descriptor() const;
    [[nodiscard]] bool waits_for_writing() const;
    /// Does what there is to do, after `revents` of poll.
    void work(short revents);

    void publish(outgoing_message const& message);
    [[nodiscard]] std::deque<arrived_message> take_messages();
    /// All that it begins with was published: what comes from now on, came behind that.
    void set_complete() { is_complete_ = true; }
    [[nodiscard]] bool is_complete() const { return is_complete_; }
    /// The topics of messages that had to arrive and did.
    [[nodiscard]] std::vector<std::string> take_arrived();
    /// Those that the broker has refused, with its reason. Only one of MQTT 5 says so.
    [[nodiscard]] std::vector<std::string> take_refused();

    /// Tells the broker that it ends as it should: it publishes no will.
    void close();

private:
    static void on_connect(mosquitto* of, void* self, int code);
    static void on_disconnect(mosquitto* of, void* self, int code);
    static void on_subscribe(mosquitto* of, void* self, int id, int count, int const* granted);
    static void on_message(mosquitto* of, void* self, mosquitto_message const* message);
    static void on_publish(mosquitto* of, void* self, int id, int reason, mqtt5__property const* more);
    static void on_unsubscribe(mosquitto* of, void* self, int id);
    static void on_log(mosquitto* of, void* self, int level, char const* text);

    class beginning;

    bool prepare(connection_choices const& chosen);
    void listen_to_library();
    /// Whether the library has a socket, or has failed to get one; then this has ended.
    bool has_begun();
    void subscribe();
    /// Has the broker respond, by taking back what was never subscribed.
    void probe();
    /// Ends where a call of the library failed.
    void check(int code, std::string const& what = {});
    void end(std::string why);
    /// Whether the socket is connected; ends where that failed.
    bool is_reached();

    std::shared_ptr<mosquitto> client_;      ///< of the thread that begins, too; it alone uses it until then
    std::shared_ptr<beginning> beginning_{}; ///< null once that is over
    std::vector<std::string> subscribed_;
    std::string probed_; ///< a topic that nobody has
    std::chrono::steady_clock::time_point began_;
    std::chrono::steady_clock::time_point probe_at_{};
    bool is_probed_{false}; ///< since `probe_at_`; else the next one is then
    bool has_tls_;
    bool is_old_;
    bool is_reached_{false};
    bool is_too_new_{false};
    bool is_accepted_{false};
    bool is_complete_{false};
    bool is_closing_{false};
    bool has_ended_{false};
    bool is_subscription_refused_{false};
    std::size_t subscribing_{0}; ///< so many were not confirmed
    std::string why_{};
    std::string library_error_{}; ///< what the library said last
    std::deque<arrived_message> messages_{};
    std::map<int, std::string> in_flight_{}; ///< of messages that have to arrive
    std::vector<std::string> arrived_{};
    std::vector<std::string> refused_{};
};

/// Whether a thread is left behind that begins a connection: what it uses has to stay until the program is gone, which no
/// `exit` waits for.
[[nodiscard]] bool is_a_connection_left();

/// The library's own start, and its end where nothing is left that uses it.
class mqtt_library {
public:
    mqtt_library();
    mqtt_library(mqtt_library const&) = delete;
    mqtt_library& operator=(mqtt_library const&) = delete;
    ~mqtt_library();
};

} // namespace tool::gateway
