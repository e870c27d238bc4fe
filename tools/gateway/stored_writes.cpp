// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "stored_writes.hpp"

#include <algorithm>
#include <fstream>
#include <optional>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "messages/utc_time.hpp"

namespace tool::gateway {

namespace {

using nlohmann::json;
using std::chrono::microseconds;

constexpr std::string_view clock_key =
    "clock"; ///< no register has that name: theirs begin with a port, and have spaces

/// The start of the machine, and when it began by the calendar of the record.
struct record_clock {
    std::string boot;
    std::uint64_t began;
};

bool is_time(json const& said) { return said.is_string() and time_in(said.get_ref<std::string const&>()); }

std::optional<record_clock> clock_in(json const& said)
{
    bool const is_right = said.is_object() and said.size() == 2 and said.contains("boot") and
                          said["boot"].is_string() and said.contains("began") and said["began"].is_number_unsigned();
    return is_right ? std::optional{record_clock{said["boot"].get<std::string>(), said["began"].get<std::uint64_t>()}}
                    : std::nullopt;
}

bool is_record(json const& own)
{
    return own.is_object() and std::ranges::all_of(own.items(), [](auto const& each) {
               return each.key() == clock_key ? clock_in(each.value()).has_value() : is_time(each.value());
           });
}

std::uint64_t microseconds_of(stored_writes::clock::time_point at)
{
    return static_cast<std::uint64_t>(std::chrono::duration_cast<microseconds>(at.time_since_epoch()).count());
}

} // namespace

std::string this_boot()
{
    std::string id;
    std::getline(std::ifstream{"/proc/sys/kernel/random/boot_id"}, id);
    return id;
}

stored_writes::stored_writes(std::string folder, std::string owner, std::uint64_t unix_time, clock::time_point now,
                             std::string boot)
    : file_{std::move(folder), "written.json", std::move(owner)}, boot_{std::move(boot)}
{
    json const own = file_.read(is_record);
    std::string const damage = file_.take_damage();
    bool const is_known = damage.empty() and file_.failure().empty();
    trouble_ = damage.empty() ? file_.failure() : damage;
    unknown_until_ = is_known ? now : now + least_interval;
    auto const noted = own.contains(clock_key) ? clock_in(own[clock_key]) : std::nullopt;
    if (noted and noted->boot == boot_) { // as the calendar was then
        unix_time = noted->began + microseconds_of(now);
    }
    for (auto const& [which, said] : own.items()) {
        if (which == clock_key) {
            continue;
        }
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
    if (not boot_.empty()) {
        own[clock_key] = {{"boot", boot_}, {"began", unix_time - microseconds_of(now)}};
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
