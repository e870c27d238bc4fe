// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "serve/serve_counts.hpp"

#include <cstdio>
#include <string_view>

namespace tool {

namespace {

constexpr std::string_view prefix = "rtuwire_serve_";

/// One metric, and its samples.
class metric_text {
public:
    metric_text(std::string& text, std::string_view name, std::string_view type, std::string_view help)
        : text_{text}, name_{std::string{prefix} + std::string{name}}
    {
        text_ += "# HELP " + name_ + ' ' + std::string{help} + "\n# TYPE " + name_ + ' ' + std::string{type} + '\n';
    }

    /// `labels`: "unit=\"7\""; `part`: "_sum".
    void put(std::string const& value, std::string const& labels = {}, std::string_view part = {})
    {
        text_ += name_ + std::string{part} + (labels.empty() ? "" : '{' + labels + '}') + ' ' + value + '\n';
    }
    void put(std::uint64_t value, std::string const& labels = {}, std::string_view part = {})
    {
        put(std::to_string(value), labels, part);
    }

private:
    std::string& text_;
    std::string name_;
};

std::string label(std::string_view name, std::string const& value) { return std::string{name} + "=\"" + value + '"'; }

std::string label(std::string_view name, unsigned value) { return label(name, std::to_string(value)); }

std::string seconds_text(double seconds)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6f", seconds);
    return text;
}

} // namespace

std::string serve_counts::text() const
{
    std::string all;
    metric_text{all, "clients", "gauge", "Clients that are connected."}.put(clients);
    metric_text{all, "connections_total", "counter", "Connections that were taken."}.put(connections);
    metric_text{all, "queue", "gauge", "Requests that wait for the line."}.put(queue);
    metric_text{all, "port_up", "gauge", "1 while the port of the line is open."}.put(is_port_up ? 1U : 0U);
    metric_text{all, "port_losses_total", "counter", "How often the port of the line went away."}.put(port_losses);
    metric_text requests{all, "requests_total", "counter", "Requests that units were asked, by unit and function."};
    for (auto const& [of, count] : requests_) {
        requests.put(count, label("unit", of.first) + ',' + label("function", of.second));
    }
    metric_text exceptions{all, "exceptions_total", "counter", "Exceptions that were answered, by unit and code."};
    for (auto const& [of, count] : exceptions_) {
        exceptions.put(count, label("unit", of.first) + ',' + label("code", of.second));
    }
    metric_text refused{all, "refused_total", "counter", "Requests and connections that were refused here, and why."};
    for (auto const& [why, count] : refused_) {
        refused.put(count, label("why", why));
    }
    metric_text silences{all, "silences_total", "counter", "Requests to which a unit did not answer."};
    for (auto const& [unit, count] : silences_) {
        silences.put(count, label("unit", unit));
    }
    metric_text round_trips{all, "round_trip_seconds", "summary", "From a request on the line to its response."};
    for (auto const& [unit, times] : round_trips_) {
        round_trips.put(seconds_text(times.first), label("unit", unit), "_sum");
        round_trips.put(times.second, label("unit", unit), "_count");
    }
    return all;
}

} // namespace tool
