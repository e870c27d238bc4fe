// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a broker keeps is known to the next process.
#include "messages/published_record.hpp"

#include <set>
#include <string>

#include "gateway/scratch_folder.hpp"
#include "support/catch.hpp"

namespace {

using gateway_test::scratch_folder;
using tool::gateway::published_record;
using names = std::set<std::string>;

} // namespace

TEST_CASE("topics that were published are known after a restart, of each gateway its own")
{
    scratch_folder const folder;
    std::string const state = folder.path("state");
    {
        published_record one{state, "/etc/one.toml"};
        CHECK(one.topics().empty());
        CHECK(one.failure().empty());
        one.keep({"a", "b"});
        published_record other{state, "/etc/other.toml"};
        CHECK(other.topics().empty());
        other.keep({"c"});
    }
    published_record one{state, "/etc/one.toml"};
    CHECK(one.topics() == names{"a", "b"});
    one.keep({"b"});
    CHECK(published_record{state, "/etc/one.toml"}.topics() == names{"b"});
    CHECK(published_record{state, "/etc/other.toml"}.topics() == names{"c"});
    one.keep({});
    CHECK(published_record{state, "/etc/one.toml"}.topics().empty());
    CHECK(published_record{state, "/etc/other.toml"}.topics() == names{"c"});
}

TEST_CASE("a record that is damaged is told, and begun anew")
{
    scratch_folder const folder;
    folder.write("published.json", "{\"/etc/one.toml\": [\"a\"");
    published_record one{folder.path("."), "/etc/one.toml"};
    CHECK(one.topics().empty());
    CHECK_FALSE(one.failure().empty());
    one.keep({"b"});
    CHECK(one.failure().empty());
    CHECK(published_record{folder.path("."), "/etc/one.toml"}.topics() == names{"b"});
}

TEST_CASE("a folder that cannot be is told, and what is published is known all the same")
{
    scratch_folder const folder;
    folder.write("file", "x");
    published_record one{folder.path("file/state"), "/etc/one.toml"};
    one.keep({"a"});
    CHECK_FALSE(one.failure().empty());
    CHECK(one.topics() == names{"a"});
}
