// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "mqtt/mqtt_gateway.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <system_error>
#include <tuple>
#include <utility>

#include <poll.h>

#include "line/time_text.hpp"
#include "messages/discovery.hpp"
#include "messages/setting_message.hpp"

namespace tool::gateway {

namespace {

constexpr std::chrono::milliseconds longest_wait{250}; ///< a heartbeat is looked at so often
constexpr std::chrono::milliseconds busy_wait{20};
constexpr std::chrono::seconds longest_farewell{2};

wake_up const* woken = nullptr;
std::sig_atomic_t volatile shall_end = 0;
std::sig_atomic_t volatile shall_reload = 0;

extern "C" void note_gateway_signal(int number)
{
    (number == SIGHUP ? shall_reload : shall_end) = 1;
    woken->ring();
}

void take_gateway_signals(wake_up const& news)
{
    woken = &news;
    for (int const each : {SIGTERM, SIGINT, SIGHUP}) {
        struct sigaction taken {};
        taken.sa_handler = note_gateway_signal;
        taken.sa_flags = SA_RESTART;
        ::sigaction(each, &taken, nullptr);
    }
}

/// A gateway is known by its file, wherever it was started.
std::string owner_of(std::string const& file)
{
    std::error_code failure;
    std::filesystem::path const path = std::filesystem::weakly_canonical(file, failure);
    return failure ? file : path.string();
}

bool is_same_broker(gateway_plan const& one, gateway_plan const& other)
{
    auto const all = [](gateway_plan const& plan) {
        broker_choices const& broker = plan.broker;
        return std::tie(plan.site, plan.gateway, broker.host, broker.port, broker.user, broker.password_file,
                        broker.ca_file, broker.cert_file, broker.key_file, broker.discovery, broker.is_old);
    };
    return all(one) == all(other);
}

} // namespace

gateway_plan checked_plan(std::string const& file)
{
    gateway_plan plan = gateway_file_at(file);
    static_cast<void>(password_of(plan.broker));
    if (std::string const why = why_no_discovery(plan); not why.empty()) {
        refuse_word(file + ": " + why);
    }
    return plan;
}

mqtt_gateway::mqtt_gateway(gateway_choices const& chosen, gateway_plan plan)
    : chosen_{chosen}, log_{chosen.has_json}, plan_{std::move(plan)}, stored_{plan_.state_folder, owner_of(chosen.file),
                                                                              unix_now(), clock::now(), this_boot()},
      lines_{chosen.may_write, stored_, [this] { news_->ring(); }}, record_{plan_.state_folder, owner_of(chosen.file)},
      publisher_{chosen.may_write, record_.topics()}, pauses_{plan_.site + '/' + plan_.gateway}
{
    std::string password = password_of(plan_.broker);
    take_plan({std::move(plan_), std::move(password)});
}

void mqtt_gateway::take_plan(plan_with_password next)
{
    plan_ = std::move(next.plan);
    password_ = std::move(next.password);
    for (std::string const& each : plan_.notes) {
        tell("note", each);
    }
    std::vector<std::shared_ptr<line_plan const>> known = std::exchange(line_plans_, {});
    known.insert(known.end(), plan_.lines.begin(), plan_.lines.end());
    lines_.apply(plan_, [this](running_line& gone) { look_at(gone); });
    for (std::shared_ptr<running_line> const& each : lines_.all()) {
        line_plans_.push_back(*std::ranges::find(known, &each->plan(), &std::shared_ptr<line_plan const>::get));
    }
    publisher_.set_plan(plan_, feeds(), clock::now());
    keep_record();
}

std::vector<line_feed> mqtt_gateway::feeds() const
{
    std::vector<line_feed> found;
    for (std::size_t i = 0; i < line_plans_.size(); ++i) {
        running_line const* const line = lines_.all()[i].get();
        found.push_back({line_plans_[i], [line] { return line->state(); },
                         [line](std::size_t which) { return line->device(which); }});
    }
    return found;
}

void mqtt_gateway::run()
{
    take_gateway_signals(*news_);
    bool is_ending = false;
    // Lines that end may take some seconds for the request that is under way; the connection and the others go on meanwhile.
    while (not is_ending or lines_.are_ending()) {
        if (shall_end != 0 and not std::exchange(is_ending, true)) {
            tell("end", "ends");
            lines_.end();
        }
        if (shall_reload != 0) {
            shall_reload = 0;
            reload();
        }
        if (next_ and not is_ending and not lines_.are_ending()) {
            take_next();
        }
        look_at_lines();
        if (not connection_ and not is_ending and clock::now() >= next_try_) {
            connect();
        }
        publish_all();
        wait(longest_wait);
        if (connection_) {
            look_at_connection();
        }
    }
    lines_.finish();
    look_at_lines();
    finish_connection();
    keep_record();
}

void mqtt_gateway::reload()
{
    try {
        gateway_plan plan = checked_plan(chosen_.file);
        std::string password = password_of(plan.broker);
        lines_.end_all_but(plan);
        next_ = {std::move(plan), std::move(password)};
    } catch (ended const& why) {
        tell("reload_refused", std::string{why.what()} + "; what was read before goes on");
    }
}

void mqtt_gateway::take_next()
{
    plan_with_password next = *std::exchange(next_, std::nullopt);
    if (not is_same_broker(next.plan, plan_) or next.password != password_) {
        finish_connection();
        is_old_broker_ = false; // nobody knows it
        next_try_ = clock::now();
    }
    if (next.plan.state_folder != plan_.state_folder) {
        tell("note", "another state_folder is used from the next start on");
    }
    take_plan(std::move(next));
    tell("reload", chosen_.file + ": read again");
}

void mqtt_gateway::connect()
{
    topics const& names = publisher_.names();
    connection_choices chosen{.broker = plan_.broker,
                              .password = password_,
                              .client = "rtuwire-" + plan_.site + '-' + plan_.gateway,
                              .status = names.status(),
                              .subscribed = {names.all_settings()},
                              .is_old = is_old_broker_ or plan_.broker.is_old};
    if (not plan_.broker.discovery.empty()) {
        chosen.subscribed.push_back(birth_topic(plan_));
    }
    connection_ = std::make_unique<connection>(chosen, [news = news_] { news->ring(); });
}

void mqtt_gateway::look_at_lines()
{
    std::ranges::for_each(lines_.all(), [this](std::shared_ptr<running_line> const& each) { look_at(*each); });
    tell_damage();
}

void mqtt_gateway::look_at(running_line& line)
{
    line_plan const& plan = line.plan();
    for (line_event& each : line.take_events()) {
        log_.tell(
            {std::string{name_of(each.what)}, std::move(each.text), plan.name, std::move(each.device), each.time});
    }
    for (setting_answer const& each : line.take_answers()) {
        device_plan const& device = plan.devices[each.device];
        publisher_.put_answer({plan.name, device.name, device.values[each.value].name},
                              answer_text(each.id, each.result, each.why, each.time));
    }
}

void mqtt_gateway::wait(std::chrono::milliseconds longest)
{
    auto const now = clock::now();
    if (connection_ and connection_->is_open() and not connection_->is_idle()) {
        longest = std::min(longest, busy_wait); // nothing tells when that changes
    }
    if (not connection_ and next_try_ > now) {
        longest = std::min(longest, std::chrono::ceil<std::chrono::milliseconds>(next_try_ - now));
    }
    bool const has_socket = connection_ and connection_->descriptor() >= 0;
    std::array<pollfd, 2> watched{pollfd{news_->descriptor(), POLLIN, 0}, pollfd{-1, POLLIN, 0}};
    if (has_socket) {
        watched[1].fd = connection_->descriptor();
        watched[1].events = static_cast<short>(POLLIN | (connection_->waits_for_writing() ? POLLOUT : 0));
    }
    if (::poll(watched.data(), watched.size(), static_cast<int>(longest.count())) > 0 and watched[0].revents != 0) {
        news_->hear();
    }
    if (connection_) {
        connection_->work(has_socket ? watched[1].revents : short{0});
    }
}

void mqtt_gateway::look_at_connection()
{
    if (connection_->is_open() and not is_connected_) {
        is_connected_ = true;
        connected_at_ = clock::now();
        told_.clear();
        tell("broker_connected", broker_name() + ": connected");
        publisher_.connected();
    }
    for (arrived_message const& each : connection_->take_messages()) {
        take(each);
    }
    for (std::string const& each : connection_->take_arrived()) {
        publisher_.arrived(each);
        if (not publisher_.has_to_take_back()) {
            keep_record();
        }
    }
    for (std::string const& each : connection_->take_refused()) {
        tell("note", broker_name() + ": it refuses " + each +
                         "; its list for this user may drop values and answers as well, without a word");
    }
    if (connection_->has_ended()) {
        lose_connection();
    } else if (connection_->is_name_late()) {
        tell_away("its name is not found in time");
    }
}

void mqtt_gateway::publish_all()
{
    while (connection_ and connection_->may_publish()) {
        auto const message = publisher_.next(clock::now(), connection_->is_idle());
        if (not message) {
            break;
        }
        connection_->publish(*message);
    }
    if (connection_ and connection_->is_subscribed() and publisher_.is_complete()) {
        if (not connection_->is_complete() and connection_->is_subscription_refused()) {
            tell("note", broker_name() + ": it refuses the topics of settings, or of discovery, to this user");
        }
        connection_->set_complete();
    }
}

void mqtt_gateway::lose_connection()
{
    auto const now = clock::now();
    if (is_connected_) {
        pauses_.connection_lasted(now - connected_at_);
    }
    std::string const why = connection_->why_ended();
    is_old_broker_ = is_old_broker_ or connection_->is_too_new();
    connection_.reset();
    publisher_.disconnected();
    next_try_ = now + pauses_.next();
    tell_away(why);
    is_connected_ = false;
}

void mqtt_gateway::tell_away(std::string const& why)
{
    if (is_connected_ or why != told_) {
        tell(is_connected_ ? "broker_lost" : "broker_away",
             broker_name() + (is_connected_ ? ": lost: " : ": not connected: ") + why +
                 "; it is tried again, and only the newest values wait");
        told_ = why;
    }
}

void mqtt_gateway::take(arrived_message const& message)
{
    if (message.topic == birth_topic(plan_)) {
        if (message.text == "online" and message.is_connected) { // else it is told anyway
            tell("discovery", message.topic + ": online; it is told of all devices again");
            publisher_.discover_again();
        }
        return;
    }
    auto const topic = publisher_.names().setting_in(message.topic);
    if (topic and not message.text.empty()) { // empty: the broker was told to forget one that it kept
        take_setting(*topic, message);
    }
}

void mqtt_gateway::take_setting(setting_topic const& topic, arrived_message const& message)
{
    setting_message const asked =
        read_setting_message(message.text, {unix_now(), message.is_retained, message.is_connected});
    if (asked.refused) {
        answer(topic, asked.id, *asked.refused, asked.why);
        return;
    }
    if (not chosen_.may_write) {
        answer(topic, asked.id, setting_result::refused, "this gateway only reads: it runs without --write");
        return;
    }
    for (std::shared_ptr<running_line> const& line : lines_.all()) {
        if (line->plan().name != topic.line) {
            continue;
        }
        std::vector<device_plan> const& devices = line->plan().devices;
        auto const device = std::ranges::find(devices, topic.device, &device_plan::name);
        if (device == devices.end()) {
            break;
        }
        auto const value = std::ranges::find(device->values, topic.name, &device_value::name);
        if (value == device->values.end() or not value->setting) {
            break;
        }
        line->submit({static_cast<std::size_t>(device - devices.begin()),
                      static_cast<std::size_t>(value - device->values.begin()), asked.value, asked.expires, asked.id});
        return;
    }
    answer(topic, asked.id, setting_result::refused, "it is not among the settings of the gateway's file");
}

void mqtt_gateway::answer(setting_topic const& topic, std::string const& id, setting_result result,
                          std::string const& why)
{
    log_.tell({"setting",
               topic.line + ": " + topic.device + ": " + topic.name + ": " + std::string{name_of(result)} + ": " + why,
               topic.line, topic.device});
    publisher_.put_answer(topic, answer_text(id, result, why, unix_now()));
}

void mqtt_gateway::finish_connection()
{
    auto const last = clock::now() + longest_farewell;
    auto const is_open = [this, last] { return connection_ and connection_->is_open() and clock::now() < last; };
    if (is_open()) {
        publisher_.end();
        while (is_open() and not publisher_.is_complete()) {
            publish_all();
            wait(busy_wait);
        }
    }
    if (is_open()) {
        connection_->close();
        while (is_open()) {
            wait(busy_wait);
        }
    }
    connection_.reset();
    publisher_.disconnected();
    is_connected_ = false;
}

void mqtt_gateway::tell_damage()
{
    for (std::string const& each : {record_.take_damage(), stored_.take_trouble()}) {
        if (not each.empty()) {
            tell("note", each);
        }
    }
}

void mqtt_gateway::keep_record()
{
    record_.keep(publisher_.kept());
    tell_damage();
    if (record_.failure() != told_record_) {
        told_record_ = record_.failure();
        if (not told_record_.empty()) {
            tell("note",
                 told_record_ +
                     "; what the broker keeps of a device that leaves the file while the gateway is down stays there");
        }
    }
}

void mqtt_gateway::tell(std::string name, std::string text) const { log_.tell({std::move(name), std::move(text)}); }

std::string mqtt_gateway::broker_name() const
{
    return "broker " + plan_.broker.host + ':' + std::to_string(plan_.broker.port);
}

} // namespace tool::gateway
