// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the gateway reads from a broker, the topic and the bytes of a setting: only what is new and about to expire is acted
// upon, each is answered by JSON on one line, and a topic names its register back.
#include <algorithm>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "input.hpp"
#include "messages/setting_message.hpp"
#include "messages/topics.hpp"
#include "messages/utc_time.hpp"

using namespace tool::gateway;
using fuzz::require;

namespace {

constexpr std::uint64_t now = 1'796'000'528'250'000; ///< microseconds since 1970, 2026-11-30T01:02:08.25Z

void topic_names_its_register(std::string const& part)
{
    topics const names{"site", "g1"};
    for (std::string const& topic : {part, names.root() + '/' + part}) {
        if (auto const found = names.setting_in(topic)) {
            require(names.setting(*found) == topic);
            for (std::string const& each : {found->line, found->device, found->name}) {
                require(not each.empty() and each.find_first_of("/+#") == std::string::npos);
            }
        }
    }
}

void time_comes_back(std::uint64_t time) { require(time_in(utc_text(time)) == time / 1'000 * 1'000); }

void message_is_new_or_refused(std::string_view payload, message_arrival const& arrival)
{
    setting_message const read = read_setting_message(payload, arrival);
    if (not read.refused) {
        require(not arrival.is_retained and arrival.is_connected and payload.size() <= longest_setting_message);
        require(read.expires > arrival.time and read.expires - arrival.time <= longest_expiry);
        time_comes_back(read.expires);
    } else {
        require(not read.why.empty());
    }
    std::string const answer =
        answer_text(read.id, read.refused.value_or(setting_result::done), read.why, arrival.time);
    require(std::ranges::all_of(answer, [](char c) { return static_cast<unsigned char>(c) >= ' ' and c != '\x7F'; }));
    auto const told = nlohmann::json::parse(answer, nullptr, false);
    require(told.is_object() and told.size() == 4 and told["why"].is_string());
    require(told["id"].is_null() or told["id"].is_string() or told["id"].is_number());
    require(told["id"] == nlohmann::json::parse(read.id, nullptr, false));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    std::uint8_t const flags = fuzz::input{data, size}.u8();
    std::string_view const text = std::string_view{reinterpret_cast<char const*>(data), size}.substr(size < 1 ? 0 : 1);
    std::size_t const end = std::min(text.find('\n'), text.size());
    topic_names_its_register(std::string{text.substr(0, end)});
    std::string_view const payload = text.substr(end < text.size() ? end + 1 : end);
    message_is_new_or_refused(payload, {now, (flags & 2U) != 0, (flags & 4U) == 0});
    return 0;
}
