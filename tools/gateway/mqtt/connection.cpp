// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "mqtt/connection.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include <mosquitto.h>
#include <mqtt_protocol.h>
#include <netdb.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include "../../support/platform.hpp"

namespace tool::gateway {

namespace {

constexpr std::size_t most_messages = 256; ///< that came and were not taken
constexpr int most_bytes = 65'536;         ///< on their way, before another message is given
constexpr int most_bytes_of_values = 8'192;
constexpr int first_reason = 128; ///< of those for which a broker of MQTT 5 refuses something

std::atomic<int> threads_left{0}; ///< that begin a connection

char const* path_or_null(std::string const& path) { return path.empty() ? nullptr : path.c_str(); }

std::string error_of(int code)
{
    std::string text = code == MOSQ_ERR_ERRNO ? std::strerror(errno)
                       : code >= first_reason ? mosquitto_reason_string(code)
                                              : mosquitto_strerror(code);
    return text.ends_with('.') ? text.substr(0, text.size() - 1) : text;
}

/// Bytes that the other end has not confirmed.
int bytes_on_their_way(int socket)
{
    int count = 0;
    return ::ioctl(socket, TIOCOUTQ, &count) == 0 ? count : 0;
}

std::string failure_of(int code, std::string const& library_error)
{
    bool const is_wrong_certificate = library_error.find("certificate verify failed") != std::string::npos;
    return error_of(code) + (library_error.empty() ? "" : " (" + library_error + ')') +
           (is_wrong_certificate ? ": it has to be of an authority in ca_file, of today, and for this host" : "");
}

} // namespace

bool is_a_connection_left() { return threads_left != 0; }

mqtt_library::mqtt_library() { mosquitto_lib_init(); }

mqtt_library::~mqtt_library()
{
    if (not is_a_connection_left()) {
        mosquitto_lib_cleanup();
    }
}

/// The library's call that connects, in a thread of its own, behind the name's lookup, which may take long.
class connection::beginning {
public:
    /// May throw `std::system_error`.
    static std::shared_ptr<beginning> start(std::shared_ptr<mosquitto> client, broker_choices const& broker,
                                            std::function<void()> on_news)
    {
        auto begun = std::make_shared<beginning>();
        without_signals const kept;
        ++threads_left; // first: it may end before this goes on
        try {
            std::thread{[begun, client = std::move(client), broker, on_news = std::move(on_news)]() mutable {
                begun->connect(client.get(), broker);
                on_news();
                client.reset(); // the last use of the library
                --threads_left;
            }}.detach();
        } catch (...) {
            --threads_left;
            throw;
        }
        return begun;
    }

    /// Nobody waits for it any more: another of the same name may be connected, whose place it would take.
    void abandon()
    {
        std::scoped_lock const held{guard_};
        is_wanted_ = false;
    }

    bool is_over() const { return is_over_; }
    /// Why it failed; empty where the connection is on its way. Once it is over.
    std::string const& failure() const { return failure_; }

private:
    void connect(mosquitto* client, broker_choices const& broker)
    {
        mosquitto_user_data_set(client, this);
        mosquitto_log_callback_set(client, [](mosquitto*, void* self, int level, char const* text) {
            if (level == MOSQ_LOG_ERR) {
                static_cast<beginning*>(self)->library_error_ = text;
            }
        });
        // With TLS the library has to know the name, and says nothing before the broker's certificate: that takes further calls.
        int const code = broker.ca_file.empty() ? connect_to_address(client, broker)
                                                : mosquitto_connect_async(client, broker.host.c_str(),
                                                                          static_cast<int>(broker.port), keep_alive);
        if (not is_begun(code)) {
            failure_ = failure_of(code, library_error_);
        }
        mosquitto_log_callback_set(client, nullptr);
        is_over_ = true;
    }

    static bool is_begun(int code) { return code == MOSQ_ERR_CONN_PENDING or code == MOSQ_ERR_SUCCESS; }

    /// The first of its addresses to which a connection begins; none where nobody waits for it any more.
    int connect_to_address(mosquitto* client, broker_choices const& broker)
    {
        addrinfo wanted{};
        wanted.ai_socktype = SOCK_STREAM;
        wanted.ai_flags = AI_ADDRCONFIG;
        addrinfo* first = nullptr;
        if (::getaddrinfo(broker.host.c_str(), nullptr, &wanted, &first) != 0) {
            return MOSQ_ERR_EAI;
        }
        std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> const all{first, &::freeaddrinfo};
        std::scoped_lock const held{guard_}; // what follows waits for nobody
        int code = MOSQ_ERR_EAI;
        for (addrinfo const* each = first; each != nullptr and is_wanted_ and not is_begun(code);
             each = each->ai_next) {
            std::array<char, NI_MAXHOST> address{};
            if (::getnameinfo(each->ai_addr, each->ai_addrlen, address.data(), address.size(), nullptr, 0,
                              NI_NUMERICHOST) == 0) {
                code = mosquitto_connect_async(client, address.data(), static_cast<int>(broker.port), keep_alive);
            }
        }
        return code;
    }

    std::mutex guard_{};
    bool is_wanted_{true};
    std::string failure_{};
    std::string library_error_{};
    std::atomic<bool> is_over_{false};
};

connection::connection(connection_choices const& chosen, std::function<void()> on_news)
    : client_{mosquitto_new(chosen.client.c_str(), true, this), &mosquitto_destroy},
      subscribed_{chosen.subscribed}, probed_{chosen.status + "/nobody"}, began_{std::chrono::steady_clock::now()},
      has_tls_{not chosen.broker.ca_file.empty()}, is_old_{chosen.is_old}
{
    if (client_ == nullptr) {
        end("no memory for a client");
        return;
    }
    try {
        if (prepare(chosen)) {
            beginning_ = beginning::start(client_, chosen.broker, std::move(on_news));
        }
    } catch (std::system_error const& why) {
        end(std::string{"no thread: "} + why.what());
    }
}

connection::~connection()
{
    // No call back into what ends; while it begins there is none.
    if (beginning_) {
        beginning_->abandon();
    } else if (client_) {
        mosquitto_disconnect_callback_set(client_.get(), nullptr);
        mosquitto_log_callback_set(client_.get(), nullptr);
    }
}

bool connection::prepare(connection_choices const& chosen)
{
    mosquitto* const client = client_.get();
    check(mosquitto_int_option(client, MOSQ_OPT_PROTOCOL_VERSION, is_old_ ? MQTT_PROTOCOL_V311 : MQTT_PROTOCOL_V5),
          "the protocol: ");
    constexpr std::string_view will = "offline";
    check(mosquitto_will_set(client, chosen.status.c_str(), static_cast<int>(will.size()), will.data(), 0, true),
          "the last will: ");
    broker_choices const& broker = chosen.broker;
    if (not broker.user.empty()) {
        check(mosquitto_username_pw_set(client, broker.user.c_str(), path_or_null(chosen.password)), "the user: ");
    }
    if (has_tls_) {
        check(mosquitto_tls_set(client, broker.ca_file.c_str(), nullptr, path_or_null(broker.cert_file),
                                path_or_null(broker.key_file), nullptr),
              "TLS: ");
    }
    check(mosquitto_int_option(client, MOSQ_OPT_TCP_NODELAY, 1), "the socket: ");
    return not has_ended_;
}

void connection::listen_to_library()
{
    mosquitto* const client = client_.get();
    mosquitto_user_data_set(client, this);
    mosquitto_connect_callback_set(client, &connection::on_connect);
    mosquitto_disconnect_callback_set(client, &connection::on_disconnect);
    mosquitto_subscribe_callback_set(client, &connection::on_subscribe);
    mosquitto_message_callback_set(client, &connection::on_message);
    mosquitto_publish_v5_callback_set(client, &connection::on_publish);
    mosquitto_unsubscribe_callback_set(client, &connection::on_unsubscribe);
    mosquitto_log_callback_set(client, &connection::on_log);
}

bool connection::has_begun()
{
    if (not beginning_) {
        return true;
    }
    if (not beginning_->is_over()) {
        return false;
    }
    std::string const failure = std::exchange(beginning_, nullptr)->failure();
    began_ = std::chrono::steady_clock::now();
    listen_to_library();
    if (not failure.empty()) {
        end(failure);
    }
    return not has_ended_;
}

bool connection::is_name_late() const
{
    return beginning_ and not has_ended_ and std::chrono::steady_clock::now() - began_ > longest_beginning;
}

bool connection::may_publish() const
{
    bool const responds = not is_probed_ or std::chrono::steady_clock::now() - probe_at_ < longest_trust;
    return is_open() and not is_closing_ and responds and not mosquitto_want_write(client_.get()) and
           bytes_on_their_way(descriptor()) < most_bytes;
}

bool connection::is_idle() const { return bytes_on_their_way(descriptor()) < most_bytes_of_values; }

int connection::descriptor() const { return client_ and not beginning_ ? mosquitto_socket(client_.get()) : -1; }

bool connection::waits_for_writing() const { return not is_reached_ or mosquitto_want_write(client_.get()); }

bool connection::is_reached()
{
    int failure = 0;
    socklen_t size = sizeof failure;
    if (::getsockopt(descriptor(), SOL_SOCKET, SO_ERROR, &failure, &size) != 0 or failure != 0) {
        end(std::strerror(failure != 0 ? failure : errno));
        return false;
    }
    is_reached_ = true;
    return true;
}

void connection::work(short revents)
{
    if (has_ended_ or not has_begun()) {
        return;
    }
    if (not is_reached_ and (revents & (POLLOUT | POLLERR | POLLHUP)) != 0) {
        if (not is_reached()) {
            return;
        }
        // The first step of TLS is due, for which the library waits to be called.
        revents = static_cast<short>(revents | (has_tls_ ? POLLIN : 0));
    }
    if ((revents & (POLLIN | POLLERR | POLLHUP)) != 0) {
        check(mosquitto_loop_read(client_.get(), 1));
    }
    if (not has_ended_ and (revents & POLLOUT) != 0) {
        check(mosquitto_loop_write(client_.get(), 1));
    }
    if (not has_ended_) {
        check(mosquitto_loop_misc(client_.get()));
    }
    if (not has_ended_ and not is_accepted_ and std::chrono::steady_clock::now() - began_ > longest_beginning) {
        end("it does not answer");
    }
    if (is_accepted_ and not has_ended_ and not is_closing_) {
        subscribe();
        probe();
    }
}

void connection::probe()
{
    auto const now = std::chrono::steady_clock::now();
    if (is_probed_ and now - probe_at_ >= longest_silence) {
        end("it has not responded for " + std::to_string(longest_silence.count()) + " s");
    } else if (not is_probed_ and now >= probe_at_) {
        is_probed_ = true;
        probe_at_ = now;
        check(mosquitto_unsubscribe(client_.get(), nullptr, probed_.c_str()));
    }
}

void connection::subscribe()
{
    for (std::string const& each : std::exchange(subscribed_, {})) {
        // A message that the broker is told to keep is known as such also when it comes at once: only MQTT 5 says so.
        int const options = is_old_ ? 0 : MQTT_SUB_OPT_RETAIN_AS_PUBLISHED;
        check(mosquitto_subscribe_v5(client_.get(), nullptr, each.c_str(), 0, options, nullptr), "subscribe: ");
    }
}

void connection::publish(outgoing_message const& message)
{
    int id = 0;
    int const code = mosquitto_publish(client_.get(), &id, message.topic.c_str(), static_cast<int>(message.text.size()),
                                       message.text.data(), message.must_arrive ? 1 : 0, message.is_retained);
    if (code == MOSQ_ERR_SUCCESS and message.must_arrive) {
        in_flight_.emplace(id, message.topic);
    }
    check(code, "publish: ");
}

std::deque<arrived_message> connection::take_messages() { return std::exchange(messages_, {}); }

std::vector<std::string> connection::take_arrived() { return std::exchange(arrived_, {}); }

std::vector<std::string> connection::take_refused() { return std::exchange(refused_, {}); }

void connection::close()
{
    is_closing_ = true;
    if (not has_ended_ and not beginning_) {
        check(mosquitto_disconnect(client_.get()), "disconnect: ");
    }
}

void connection::check(int code, std::string const& what)
{
    if (code != MOSQ_ERR_SUCCESS) {
        end(what + failure_of(code, library_error_));
    }
}

void connection::end(std::string why)
{
    if (not has_ended_) {
        has_ended_ = true;
        why_ = std::move(why);
    }
}

void connection::on_connect(mosquitto*, void* self, int code)
{
    auto& one = *static_cast<connection*>(self);
    if (code != 0) {
        one.is_too_new_ = not one.is_old_ and (code == 1 or code == MQTT_RC_UNSUPPORTED_PROTOCOL_VERSION);
        one.end(std::string{"refused: "} + (one.is_old_ ? mosquitto_connack_string(code) : error_of(code)));
        return;
    }
    one.is_accepted_ = true;
    one.subscribing_ = one.subscribed_.size();
}

void connection::on_disconnect(mosquitto*, void* self, int code)
{
    auto& one = *static_cast<connection*>(self);
    one.end(code == 0                    ? "closed"
            : code == MOSQ_ERR_KEEPALIVE ? "it has not responded for " + std::to_string(keep_alive) + " s"
                                         : error_of(code));
}

void connection::on_subscribe(mosquitto*, void* self, int, int count, int const* granted)
{
    auto& one = *static_cast<connection*>(self);
    one.subscribing_ -= one.subscribing_ > 0 ? 1 : 0;
    one.is_subscription_refused_ = one.is_subscription_refused_ or
                                   std::any_of(granted, granted + count, [](int each) { return each >= first_reason; });
}

void connection::on_message(mosquitto*, void* self, mosquitto_message const* message)
{
    auto& one = *static_cast<connection*>(self);
    if (one.messages_.size() < most_messages) {
        auto const* const bytes = static_cast<char const*>(message->payload);
        std::string text =
            message->payloadlen > 0 ? std::string{bytes, static_cast<std::size_t>(message->payloadlen)} : std::string{};
        one.messages_.push_back({message->topic, std::move(text), message->retain, one.is_complete_});
    }
}

void connection::on_publish(mosquitto*, void* self, int id, int reason, mqtt5__property const*)
{
    auto& one = *static_cast<connection*>(self);
    if (auto const found = one.in_flight_.find(id); found != one.in_flight_.end()) {
        if (reason < first_reason) {
            one.arrived_.push_back(std::move(found->second));
        } else {
            one.refused_.push_back(found->second + ": " + error_of(reason));
        }
        one.in_flight_.erase(found);
    }
}

void connection::on_unsubscribe(mosquitto*, void* self, int)
{
    auto& one = *static_cast<connection*>(self);
    one.is_probed_ = false;
    one.probe_at_ = std::chrono::steady_clock::now() + probe_pause;
}

void connection::on_log(mosquitto*, void* self, int level, char const* text)
{
    if (level == MOSQ_LOG_ERR) {
        static_cast<connection*>(self)->library_error_ = text;
    }
}

} // namespace tool::gateway
