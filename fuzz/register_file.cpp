// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Register files: any text is refused by its place in words for people, or gives registers that each are found by their names,
// with limits, choices and groups that are some.
#include <cmath>
#include <string>
#include <string_view>

#include "device/register_file.hpp"
#include "exit_status.hpp"
#include "input.hpp"

using namespace tool;
using fuzz::require;

namespace {

void are_right(named_places const& read)
{
    require(read.places.size() <= most_registers);
    for (named_place const& each : read.places) {
        require(why_no_name(each.where.name).empty() and read.by_name(each.where.name) == &each);
        require(not each.lowest or std::isfinite(*each.lowest));
        require(not each.highest or std::isfinite(*each.highest));
        require(not each.lowest or not each.highest or *each.lowest <= *each.highest);
        require(each.group.empty() or read.group_named(each.group) != nullptr);
        for (named_choice const& one : each.choices) {
            require(why_no_word(one.name).empty());
        }
    }
    for (named_group const& each : read.groups) {
        require(std::isfinite(each.period) and each.period > 0);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    try {
        are_right(read_register_file("meter.toml", {reinterpret_cast<char const*>(data), size}));
    } catch (ended const& why) {
        require(why.status == exit_status::usage and std::string_view{why.what()}.starts_with("meter.toml:"));
    }
    return 0;
}
