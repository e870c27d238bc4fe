// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "stored_writes.hpp"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "messages/utc_time.hpp"

namespace tool::gateway {

namespace {

using nlohmann::json;
using std::chrono::microseconds;

bool is_time(json const& said) { return said.is_string() and time_in(said.get_ref<std::string const&>()); }

bool is_record(json const& own) { return own.is_object() and std::ranges::all_of(own, is_time); }

} // namespace

stored_writes::stored_writes(std::string folder, std::string owner, std::uint64_t unix_time, clock::time_point now)
    : file_{std::move(folder), "written.json", std::move(owner)}
{
    json const own = file_.read(is_record);
    std::string const damage = file_.take_damage();
    bool const is_known = damage.empty() and file_.failure().empty();
    trouble_ = damage.empty() ? file_.failure() : damage;
    unknown_until_ = is_known ? now : now + least_interval;
    for (auto const& [which, said] : own.items()) {
        std::uint64_t const time = *time_in(said.get_ref<std::string const&>());
        microseconds const age{unix_time > time ? unix_time - time : 0};
        written_.emplace(which, now - std::min<clock::duration>(age, least_interval));
    }
    forget_old(now);
}

void stored_writes::forget_old(clock::time_point now)
{
    std::erase_if(written_, [now](auto const& each) { return now - each.second >= least_interval; });
}

bool stored_writes::is_too_soon(std::string const& which, clock::time_point now) const
{
    auto const before = written_.find(which);
    return now < unknown_until_ or (before != written_.end() and now - before->second < least_interval);
}

std::string stored_writes::claim(std::vector<std::string> const& registers, std::uint64_t unix_time,
                                 clock::time_point now)
{
    std::scoped_lock const held{guard_};
    if (std::ranges::any_of(registers, [&](std::string const& each) { return is_too_soon(each, now); })) {
        return "its device stores it, and its memory bears a limited number of writes: 60 s lie between two";
    }
    forget_old(now);
    std::map<std::string, clock::time_point> const before = written_;
    json own = json::object();
    for (std::string const& each : registers) {
        written_[each] = now;
    }
    for (auto const& [which, at] : written_) {
        auto const age = std::chrono::duration_cast<microseconds>(now - at);
        own[which] = utc_text(unix_time - static_cast<std::uint64_t>(age.count()));
    }
    std::string const why = file_.write(own);
    if (not why.empty()) {
        written_ = before;
        return "its device stores it, and the time of the write cannot be noted: " + why;
    }
    return {};
}

std::string stored_writes::take_trouble()
{
    std::scoped_lock const held{guard_};
    std::string const damage = file_.take_damage();
    return damage.empty() ? std::exchange(trouble_, {}) : damage;
}

} // namespace tool::gateway
