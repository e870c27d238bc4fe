// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "messages/state_message.hpp"

#include <cstddef>
#include <utility>
#include <variant>

#include <nlohmann/json.hpp>

#include "messages/utc_time.hpp"
#include "output/plain_text.hpp"

namespace tool::gateway {

namespace {

using ordered = nlohmann::ordered_json;

struct cell_to_json {
    ordered operator()(std::monostate) const { return nullptr; }
    template <typename Value> ordered operator()(Value const& value) const { return value; }
};

std::string text_of_json(ordered const& all)
{
    return plain_json(all.dump(-1, ' ', false, ordered::error_handler_t::replace));
}

ordered json_of(device_value const& plan, slot_value const& value, std::string const& time)
{
    ordered one;
    bool const is_valid = value.state == value_state::valid;
    one["value"] = is_valid ? std::visit(cell_to_json{}, value.value) : ordered(nullptr);
    if (is_valid and not plan.unit.empty()) {
        one["unit"] = plan.unit;
    }
    if (value.state == value_state::invalid) {
        one["invalid"] = true;
    }
    if (not is_valid) {
        one["why"] = value.why;
    }
    if (std::string own = utc_text(value.time); own != time and value.time != 0) {
        one["time"] = std::move(own);
    }
    return one;
}

} // namespace

std::string state_text(device_plan const& plan, slot_content const& content, std::uint64_t published)
{
    ordered values = ordered::object();
    std::string const time = utc_text(content.time);
    for (std::size_t i = 0; i < content.values.size() and i < plan.values.size(); ++i) {
        slot_value const& each = content.values[i];
        if (each.seq > published) {
            values[plan.values[i].name] = json_of(plan.values[i], each, time);
        }
    }
    if (values.empty()) {
        return {};
    }
    ordered all;
    all["time"] = time;
    all["seq"] = content.seq;
    all["values"] = std::move(values);
    return text_of_json(all);
}

std::string status_text(line_state const& state)
{
    ordered all;
    all["time"] = utc_text(state.time);
    all["seq"] = state.seq;
    all["requests"] = state.requests;
    all["silences"] = state.silences;
    all["refusals"] = state.refusals;
    all["errors"] = state.errors;
    all["opened"] = state.opened;
    all["overruns"] = state.overruns;
    if (state.clients) {
        all["client_requests"] = state.clients->requests;
        all["client_silences"] = state.clients->silences;
    }
    all["up"] = state.is_up;
    if (not state.is_up) {
        all["why"] = state.why;
    }
    return text_of_json(all);
}

} // namespace tool::gateway
