// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a broker keeps is known to the next process.
#include "messages/published_record.hpp"

#include <filesystem>
#include <set>
#include <string>

#include "files/regular_file.hpp"
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

TEST_CASE("a record that is damaged is told, kept, and begun anew")
{
    for (std::string const damaged : {"{\"/etc/one.toml\": [\"a\"", "", "[]", "{\"/etc/one.toml\": [1]}"}) {
        CAPTURE(damaged);
        scratch_folder const folder;
        std::string const file = folder.write("published.json", damaged);
        published_record one{folder.path("."), "/etc/one.toml"};
        CHECK(one.topics().empty());
        one.keep({"b"});
        CHECK(one.failure().empty());
        std::string const told = one.take_damage();
        CAPTURE(told);
        CHECK(told.find("published.json: ") != told.npos);
        CHECK(told.find("kept in ") != told.npos);
        CHECK(one.take_damage().empty());
        std::string kept = tool::text_of_file(file + ".damaged").text;
        std::erase_if(kept, [](char each) { return each == ' ' or each == '\n'; });
        std::string wanted = damaged;
        std::erase(wanted, ' ');
        CHECK(kept == wanted);
        CHECK(published_record{folder.path("."), "/etc/one.toml"}.topics() == names{"b"});
    }
}

TEST_CASE("what another gateway noted stays where a file is damaged for one, or cannot be read")
{
    scratch_folder const folder;
    std::string const file = folder.write("published.json", R"({"/etc/one.toml": 7, "/etc/other.toml": ["c"]})");
    published_record one{folder.path("."), "/etc/one.toml"};
    CHECK_FALSE(one.take_damage().empty());
    one.keep({"a"});
    CHECK(published_record{folder.path("."), "/etc/other.toml"}.topics() == names{"c"});

    std::filesystem::remove(file);
    std::filesystem::create_directory(file);
    one.keep({"b"});
    CHECK(one.failure().find("is a directory") != std::string::npos);
    CHECK(one.take_damage().empty());
    CHECK(std::filesystem::is_directory(file));
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
