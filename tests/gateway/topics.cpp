// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Topics: those that a gateway makes, and what one that came is for.
#include "messages/topics.hpp"

#include <string_view>

#include "support/catch.hpp"

namespace {

using namespace tool::gateway;

topics const hall{"hall3", "g1"};

} // namespace

TEST_CASE("topics of a gateway are below its site and its name")
{
    CHECK(hall.status() == "rtuwire/hall3/g1/status");
    CHECK(hall.status("line1") == "rtuwire/hall3/g1/line1/status");
    CHECK(hall.availability("line1") == "rtuwire/hall3/g1/line1/availability");
    CHECK(hall.availability("line1", "meter1") == "rtuwire/hall3/g1/line1/meter1/availability");
    CHECK(hall.state("line1", "meter1") == "rtuwire/hall3/g1/line1/meter1/state");
    CHECK(hall.answer({"line1", "meter1", "set_point"}) == "rtuwire/hall3/g1/line1/meter1/answer/set_point");
    CHECK(hall.all_settings() == "rtuwire/hall3/g1/+/+/set/+");
}

TEST_CASE("a topic of a setting says which register it is for, and no other topic does")
{
    setting_topic const wanted{"line1", "meter1", "set_point"};
    CHECK(hall.setting(wanted) == "rtuwire/hall3/g1/line1/meter1/set/set_point");
    CHECK(hall.setting_in(hall.setting(wanted)) == wanted);
    for (std::string_view const other :
         {"", "rtuwire/hall3/g1", "rtuwire/hall3/g1/", "rtuwire/hall3/g1/line1/meter1/answer/set_point",
          "rtuwire/hall3/g1/line1/meter1/set", "rtuwire/hall3/g1/line1/meter1/set/", "rtuwire/hall3/g1/line1//set/x",
          "rtuwire/hall3/g1/line1/meter1/set/x/y", "rtuwire/hall3/g12/line1/meter1/set/x",
          "rtuwire/hall3/g1/line1/meter1/set/+", "rtuwire/hall3/g1/line1/meter1/set/#",
          "rtuwire/hall3/g1/line1/meter 1/set/x", "rtuwire/hall4/g1/line1/meter1/set/x"}) {
        INFO(other);
        CHECK_FALSE(hall.setting_in(other));
    }
}

TEST_CASE("a part of a topic is a word that no broker takes for more")
{
    for (std::string_view const right : {"hall3", "g-1", "a_b", "7", "ABC"}) {
        CHECK(why_no_topic_part(right).empty());
    }
    for (std::string_view const wrong : {"", "a/b", "+", "#", "a b", "$SYS", "h\xC3\xA4ll", "a.b", "a\nb"}) {
        CHECK_FALSE(why_no_topic_part(wrong).empty());
    }
}
