// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "messages/setting_message.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "messages/utc_time.hpp"
#include "output/plain_text.hpp"
#include "words/suggestion.hpp"

namespace tool::gateway {

namespace {

using nlohmann::json;

constexpr std::size_t longest_id = 64;
constexpr std::array<std::string_view, 3> keys{"value", "expires", "id"};

/// A number with the digits that mean it, and no exponent, which no word for a value has.
std::string typed(double number)
{
    std::array<char, 400> text{};
    auto const end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed).ptr;
    return {text.data(), end};
}

/// What is wrong with the keys of a message; empty where nothing is.
std::string why_wrong_keys(std::vector<std::string> const& found)
{
    for (std::string const& each : found) {
        if (std::ranges::count(keys, each) == 0) {
            return "it has the key \"" + plain_text(each) + "\"" + suggestion(each, keys);
        }
        if (std::ranges::count(found, each) > 1) {
            return "it has \"" + each + "\" twice";
        }
    }
    return {};
}

class message_reader {
public:
    explicit message_reader(message_arrival const& arrival) : arrival_{arrival} { read_.id = "null"; }

    setting_message run(std::string_view payload)
    {
        if (payload.size() > longest_setting_message) {
            return refuse("it is longer than " + std::to_string(longest_setting_message) + " bytes");
        }
        std::vector<std::string> found;
        json const all = json::parse(
            payload,
            [&found](int depth, json::parse_event_t event, json& parsed) {
                if (depth == 1 and event == json::parse_event_t::key) {
                    found.push_back(parsed.get<std::string>());
                }
                return true;
            },
            false);
        if (not all.is_object()) {
            return refuse("it is no JSON object: {\"value\": 21.5, \"expires\": \"2026-11-30T01:02:08Z\", \"id\": "
                          "\"a1\"}");
        }
        if (std::string why = read_id(all); not why.empty()) {
            return refuse(std::move(why));
        }
        if (arrival_.is_retained) {
            return refuse("it is retained: nobody knows how old it is; send it without the retain flag");
        }
        if (not arrival_.is_connected) {
            return refuse("it came before the connection was complete");
        }
        if (std::string why = why_wrong_keys(found); not why.empty()) {
            return refuse(std::move(why));
        }
        if (std::string why = read_value(all); not why.empty()) {
            return refuse(std::move(why));
        }
        return read_expiry(all);
    }

private:
    setting_message refuse(std::string why, setting_result how = setting_result::refused)
    {
        read_.refused = how;
        read_.why = std::move(why);
        return std::move(read_);
    }

    std::string read_id(json const& all)
    {
        auto const id = all.find("id");
        if (id == all.end() or id->is_null()) {
            return {};
        }
        std::string const text = id->dump(-1, ' ', true, json::error_handler_t::replace);
        if (not(id->is_string() or id->is_number()) or text.size() > longest_id + 2) {
            return "its id is a text of at most " + std::to_string(longest_id) + " characters, or a number";
        }
        read_.id = text;
        return {};
    }

    std::string read_value(json const& all)
    {
        auto const value = all.find("value");
        if (value == all.end()) {
            return "it has no \"value\"";
        }
        if (value->is_string()) {
            read_.value = value->get<std::string>();
        } else if (value->is_boolean()) {
            read_.value = value->get<bool>() ? "on" : "off";
        } else if (value->is_number()) {
            read_.value = value->is_number_float() ? typed(value->get<double>()) : value->dump();
        } else {
            return "its value is a number, a text, true or false";
        }
        return {};
    }

    setting_message read_expiry(json const& all)
    {
        auto const expires = all.find("expires");
        auto const time =
            expires != all.end() and expires->is_string() ? time_in(expires->get<std::string>()) : std::nullopt;
        if (not time) {
            return refuse(std::string{"it "} + (expires == all.end() ? "has no \"expires\"" : "expires at no time") +
                          ": the time after which it is not to be written, such as \"2026-11-30T01:02:08Z\"");
        }
        read_.expires = *time;
        if (*time <= arrival_.time) {
            return refuse("it expired at " + utc_text(*time) + ", and it is " + utc_text(arrival_.time),
                          setting_result::expired);
        }
        if (*time - arrival_.time > longest_expiry) {
            return refuse("it expires at " + utc_text(*time) + ", more than 60 s ahead of this clock, " +
                          utc_text(arrival_.time));
        }
        return std::move(read_);
    }

    message_arrival arrival_;
    setting_message read_{};
};

} // namespace

setting_message read_setting_message(std::string_view payload, message_arrival const& arrival)
{
    return message_reader{arrival}.run(payload);
}

std::string answer_text(std::string const& id, setting_result result, std::string_view why, std::uint64_t time)
{
    nlohmann::ordered_json answer;
    answer["id"] = nlohmann::ordered_json::parse(id, nullptr, false);
    answer["result"] = name_of(result);
    answer["why"] = why;
    answer["time"] = utc_text(time);
    return plain_json(answer.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

} // namespace tool::gateway
