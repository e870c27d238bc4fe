// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "sunspec/model_list.hpp"

namespace tool {

namespace {

constexpr std::uint16_t mark_high = 0x5375; // "Su"
constexpr std::uint16_t mark_low = 0x6E53;  // "nS"
constexpr std::uint16_t end_of_models = 0xFFFF;
constexpr std::size_t most_models = 200;

/// Two registers, the first in the upper half.
rtuwire::result<std::uint32_t> pair_at(open_line& line, unit_address unit, std::uint16_t address)
{
    auto const read = line.ask(unit, rtuwire::read_holding_registers{.start = address, .count = 2});
    if (not read) {
        return read.error();
    }
    return static_cast<std::uint32_t>(std::uint32_t{read->registers[0]} << 16U | read->registers[1]);
}

} // namespace

sunspec_models sunspec_models_of(open_line& line, unit_address unit)
{
    sunspec_models found;
    for (std::uint16_t const address : {std::uint16_t{40'000}, std::uint16_t{0}, std::uint16_t{50'000}}) {
        auto const mark = pair_at(line, unit, address);
        if (mark and *mark == (std::uint32_t{mark_high} << 16U | mark_low)) {
            found.mark = address;
            break;
        }
        if (not mark and not rtuwire::is_exception(mark.error())) {
            found.failure = line.words_of_failure(mark.error());
            found.outcome = status_of(mark.error());
            return found;
        }
    }
    for (unsigned at = found.mark ? *found.mark + 2U : 0x1'0000U; at < 0xFFFFU;) {
        auto const head = pair_at(line, unit, static_cast<std::uint16_t>(at));
        if (not head) {
            found.failure =
                "no model can be read at " + std::to_string(at) + ": " + line.words_of_failure(head.error());
            found.outcome = status_of(head.error());
            break;
        }
        auto const id = static_cast<std::uint16_t>(*head >> 16U);
        auto const length = static_cast<std::uint16_t>(*head & 0xFFFFU);
        if (id == end_of_models or found.models.size() == most_models) {
            break;
        }
        if (at + 2U + length > 0x1'0000U) {
            found.failure = "model " + std::to_string(id) + " at " + std::to_string(at) + " says a length beyond 65535";
            found.outcome = exit_status::differs;
            break;
        }
        found.models.push_back({id, static_cast<std::uint16_t>(at), length});
        at += 2U + length;
    }
    return found;
}

std::string text_of(sunspec_models const& found)
{
    if (not found.mark) {
        return {};
    }
    std::string text = "SunSpec at " + std::to_string(*found.mark) + ':';
    for (sunspec_model const& each : found.models) {
        text += (text.back() == ':' ? " model " : ", ") + std::to_string(each.id) + " at " +
                std::to_string(each.address) + " (" + std::to_string(each.length) + ')';
    }
    return text + (found.failure.empty() ? "" : "; " + found.failure);
}

} // namespace tool
