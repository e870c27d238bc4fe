// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The interval between two writes of a register that its device stores: beyond the end of a gateway, whatever its clock does.
#include "../../tools/gateway/stored_writes.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

#include "files/regular_file.hpp"
#include "gateway/scratch_folder.hpp"
#include "support/catch.hpp"

namespace {

using gateway_test::scratch_folder;
using tool::gateway::stored_writes;
using namespace std::chrono_literals;

constexpr std::uint64_t noon = 1'796'040'000'000'000; ///< microseconds since 1970
constexpr std::uint64_t second = 1'000'000;
constexpr std::uint64_t hour = 3'600 * second;

stored_writes::clock::time_point at(std::chrono::milliseconds since_boot)
{
    return stored_writes::clock::time_point{since_boot};
}

bool is_refused(std::string const& why) { return why.find("60 s lie between two") != why.npos; }

} // namespace

TEST_CASE("a register is written once a minute, also behind a restart of the program or of the machine")
{
    scratch_folder const folder;
    std::string const state = folder.path("state");
    {
        stored_writes before{state, "/etc/one.toml", noon, at(100s)};
        CHECK(before.claim({"a", "b"}, noon, at(100s)).empty());
        CHECK(is_refused(before.claim({"b"}, noon + 59 * second, at(159s))));
        CHECK(before.claim({"c"}, noon + second, at(101s)).empty());
    }
    for (auto const boot : {120s, 1s}) { // the clock that nobody sets begins anew with the machine
        stored_writes behind{state, "/etc/one.toml", noon + 20 * second, at(boot)};
        CHECK(is_refused(behind.claim({"a"}, noon + 20 * second, at(boot))));
        CHECK(is_refused(behind.claim({"d", "b"}, noon + 59 * second, at(boot + 39s))));
    }
    stored_writes behind{state, "/etc/one.toml", noon + 20 * second, at(1s)};
    CHECK(behind.claim({"d"}, noon + 20 * second, at(1s)).empty()); // what was refused was not noted
    CHECK(behind.claim({"a"}, noon + 60 * second, at(41s)).empty());
    CHECK(is_refused(behind.claim({"c"}, noon + 60 * second, at(41s))));
    CHECK(behind.claim({"c"}, noon + 61 * second, at(42s)).empty());
}

TEST_CASE("a step of the clock never makes a register wait longer than the interval, nor, while the program runs, less")
{
    scratch_folder const folder;
    std::string const state = folder.path("state");
    stored_writes running{state, "/etc/one.toml", noon, at(100s)};
    REQUIRE(running.claim({"a"}, noon, at(100s)).empty());
    CHECK(is_refused(running.claim({"a"}, noon + hour, at(101s))));
    CHECK(is_refused(running.claim({"a"}, noon - hour, at(159s))));
    CHECK(running.claim({"a"}, noon - hour, at(160s)).empty());

    REQUIRE(running.claim({"b"}, noon + hour, at(200s)).empty());
    stored_writes behind{state, "/etc/one.toml", noon, at(210s)}; // set back before it began again
    CHECK(is_refused(behind.claim({"b"}, noon, at(269s))));
    CHECK(behind.claim({"b"}, noon, at(270s)).empty());
    stored_writes later{state, "/etc/one.toml", noon + second, at(271s)}; // and noted by the calendar as it is now
    CHECK(is_refused(later.claim({"b"}, noon + 59 * second, at(329s))));
    CHECK(later.claim({"b"}, noon + 60 * second, at(330s)).empty());
}

TEST_CASE("a step of the clock before a restart counts for nothing while the machine goes on")
{
    for (std::uint64_t const stepped : {noon + hour, noon - hour}) {
        scratch_folder const folder;
        std::string const state = folder.path("state");
        REQUIRE(stored_writes{state, "/etc/one.toml", noon, at(100s), "boot 1"}.claim({"a"}, noon, at(100s)).empty());
        stored_writes behind{state, "/etc/one.toml", stepped, at(110s), "boot 1"};
        CHECK(is_refused(behind.claim({"a"}, stepped, at(159s))));
        REQUIRE(behind.claim({"b"}, stepped, at(120s)).empty()); // which notes the first one anew
        stored_writes third{state, "/etc/one.toml", noon, at(130s), "boot 1"};
        CHECK(is_refused(third.claim({"a"}, noon, at(159s))));
        CHECK(is_refused(third.claim({"b"}, noon, at(179s))));
        CHECK(third.claim({"a"}, noon, at(160s)).empty());

        // Behind another start of the machine there is the calendar alone.
        stored_writes rebooted{state, "/etc/one.toml", noon + 59 * second, at(1s), "boot 2"};
        CHECK(is_refused(rebooted.claim({"a"}, noon + 59 * second, at(1s))));
        CHECK(rebooted.claim({"a"}, noon + 61 * second, at(61s)).empty());
    }
}

TEST_CASE("this start of the machine has a name")
{
    CHECK(tool::gateway::this_boot().size() == 36);
    CHECK(tool::gateway::this_boot() == tool::gateway::this_boot());
}

TEST_CASE("a record of writes that is damaged is told and kept, and every register waits once")
{
    for (std::string const damaged :
         {"{", "[]", R"({"/etc/one.toml": []})", R"({"/etc/one.toml": {"a": "noon"}})",
          R"({"/etc/one.toml": {"a": 1796040000}})", R"({"/etc/one.toml": {"clock": {"boot": "x"}}})"}) {
        CAPTURE(damaged);
        scratch_folder const folder;
        std::string const file = folder.write("written.json", damaged);
        stored_writes behind{folder.path("."), "/etc/one.toml", noon, at(1s)};
        std::string const told = behind.take_trouble();
        CAPTURE(told);
        CHECK(told.find("written.json: ") != told.npos);
        CHECK(std::filesystem::exists(file + ".damaged"));
        CHECK(behind.take_trouble().empty());
        CHECK(is_refused(behind.claim({"b"}, noon + 59 * second, at(60s))));
        CHECK(behind.claim({"b"}, noon + 60 * second, at(61s)).empty());
    }
}

TEST_CASE("a write that cannot be noted is none, and what others noted stays")
{
    scratch_folder const folder;
    folder.write("file", "x");
    stored_writes nowhere{folder.path("file/state"), "/etc/one.toml", noon, at(1s)};
    std::string const why = nowhere.claim({"a"}, noon, at(70s));
    CAPTURE(why);
    CHECK(why.find("cannot be noted: " + folder.path("file/state")) != why.npos);
    CHECK(nowhere.claim({"a"}, noon, at(71s)) == why); // it was not written, either

    stored_writes one{folder.path("."), "/etc/one.toml", noon, at(1s)};
    stored_writes other{folder.path("."), "/etc/other.toml", noon, at(1s)};
    REQUIRE(one.claim({"a"}, noon, at(1s)).empty());
    REQUIRE(other.claim({"a"}, noon, at(1s)).empty());
    for (char const* const each : {"/etc/one.toml", "/etc/other.toml"}) {
        CHECK(is_refused(stored_writes{folder.path("."), each, noon, at(1s)}.claim({"a"}, noon, at(1s))));
    }
}

TEST_CASE("writes of long ago are forgotten")
{
    scratch_folder const folder;
    stored_writes one{folder.path("."), "/etc/one.toml", noon, at(0s)};
    for (unsigned i = 0; i < 200; ++i) {
        REQUIRE(one.claim({std::to_string(i)}, noon + i * 30 * second, at(i * 30s)).empty());
    }
    CHECK(tool::text_of_file(folder.path("written.json")).text.size() < 200);
}
