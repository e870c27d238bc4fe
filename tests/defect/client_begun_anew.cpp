// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Conversations that are given up for a new one in each pass, unfinished, leave the others on the line their turns.
#include "client_line.hpp"

#include "support/catch.hpp"

#include <optional>

#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::test;

namespace {

/// Of a unit that says nothing; then it, or where it is one of several all units, is held for a late response.
constexpr std::uint64_t lost_time = 100'000 + 20'000;
constexpr client_options once{.response_timeout = milliseconds(100), .late_response = milliseconds(20), .retries = 0};
constexpr std::uint64_t length = 20'000'000;

/// How a conversation that has not ended is begun anew.
enum class way { another_in_its_place, forgotten };

/// Who is on the line: places of those that last (`s`) and of those that are begun anew in each pass (`r`), in the
/// order in which they come by.
struct company {
    char const* order;
    way how;
    bool answers; ///< whether the unit of those that are begun anew says anything
};

/// One place: its unit is the number of the place, from 1.
struct place {
    bool is_restless;
    std::optional<series> conversation{};

    void fill(unsigned unit)
    {
        conversation.emplace([=](unsigned) { return read_of(unit, 3201); });
        conversation->most = is_restless ? 1 : 0xFFFF'FFFF;
    }
    void begin_anew(unsigned unit, way how)
    {
        if (how == way::another_in_its_place) {
            fill(unit);
        } else {
            conversation->forget();
            conversation->number = 0;
        }
    }
};

void converse(client& link, std::size_t, series& conversation, instant now) { link.converse(conversation, now); }
void converse(bus<4>& link, std::size_t index, series& conversation, instant now)
{
    link.converse(index, conversation, now);
}

/// The fewest answers that one of those that last gets.
template <typename Link> unsigned fewest_answers(company const& of)
{
    scripted_line<Link> line{Link{office_line, once}, office_line};
    std::vector<place> places;
    for (char const* each = of.order; *each != 0; ++each) {
        places.push_back({*each == 'r'});
        places.back().fill(static_cast<unsigned>(places.size()));
    }
    line.heard = [&](frame_bytes const& frame) {
        if (of.answers or not places.at(at(frame, 0) - 1U).is_restless) {
            line.say(5'000, response_to(frame));
        }
    };
    line.run(length, [&](instant now) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (places[i].is_restless) {
                places[i].begin_anew(static_cast<unsigned>(i + 1), of.how);
            }
            converse(line.link, i, *places[i].conversation, now);
        }
    });
    unsigned fewest = 0xFFFF'FFFF;
    for (place const& each : places) {
        fewest = each.is_restless ? fewest : std::min(fewest, each.conversation->answered);
    }
    return fewest;
}

/// What each of those that last gets at least where nobody is asked twice before everybody was asked once: a
/// request, its response and the silences are no 25 ms.
unsigned fair_share(company const& of)
{
    std::uint64_t round = 0;
    for (char const* each = of.order; *each != 0; ++each) {
        round += 25'000 + (*each == 'r' and not of.answers ? lost_time : 0);
    }
    return static_cast<unsigned>(length / round);
}

template <typename Link> void leaves_turns()
{
    for (char const* const order : {"sr", "rs", "ssr", "srs", "rss", "srr", "rsr", "rrs", "rrss"}) {
        for (way const how : {way::another_in_its_place, way::forgotten}) {
            for (bool const answers : {true, false}) {
                company const of{order, how, answers};
                INFO(order << (how == way::forgotten ? ", forgotten" : ", another each pass")
                           << (answers ? ", answered" : ", not answered"));
                CHECK(fewest_answers<Link>(of) >= fair_share(of));
            }
        }
    }
}

} // namespace

TEST_CASE("defect: A1 a client's conversations that are begun anew in each pass leave the others "
          "their turns")
{
    leaves_turns<client>();
}

TEST_CASE("defect: A1 a bus's conversations that are begun anew in each pass leave the others "
          "their turns")
{
    leaves_turns<bus<4>>();
}
