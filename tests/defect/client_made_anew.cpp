// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client that is made anew in the place of another one, while conversations of that one live on: what they hold is of
// the other's count, and no outcome reaches another conversation than the one that asked.
#include "client_line.hpp"

#include "support/catch.hpp"

#include <cstdint>
#include <optional>

#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::test;

namespace {

constexpr client_options once{.response_timeout = milliseconds(100), .retries = 0};

enum class way {
    emplaced,
    assigned,
    copy_emplaced, ///< of what was kept before
    copy_assigned,
};

/// A client, or a bus, in the hands of the test.
template <typename Link> struct remade {
    std::optional<Link> link{Link{office_line, once}};
    std::optional<Link> kept{};
    std::uint32_t time{0};

    remade() { settle(); }
    instant now() const { return instant{time}; }
    void settle()
    {
        link->advance(now());
        time += 1'000'000;
        link->advance(now());
    }
    void make_anew(way how)
    {
        if (how == way::emplaced) {
            link.emplace(office_line, once);
        } else if (how == way::assigned) {
            *link = Link{office_line, once};
        } else if (how == way::copy_emplaced) {
            link.emplace(*kept);
        } else {
            *link = *kept;
        }
        settle();
    }
    void visit(std::size_t slot, series& conversation)
    {
        if constexpr (requires { link->converse(slot, conversation, now()); }) {
            link->converse(slot, conversation, now());
        } else {
            link->converse(conversation, now());
        }
    }
    /// It comes by, and its request leaves.
    void ask(std::size_t slot, series& conversation)
    {
        visit(slot, conversation);
        std::size_t const size = link->poll_transmit().size();
        REQUIRE(size != 0);
        time += office_line.characters(size).microseconds;
        link->sent(now());
        link->advance(now());
    }
    void answer(frame_bytes const& asked)
    {
        time += 20'000;
        link->receive(response_to(asked), now());
        link->advance(now());
        time += 20'000;
        link->advance(now());
    }
};

/// A conversation whose request is under way, the n-th of its client, when that is made anew; then another one asks m
/// requests, and the first comes by before the outcome of the last of them is taken.
template <typename Link> void meets_another_after(way how)
{
    for (unsigned n = 1; n <= 4; ++n) {
        for (unsigned m = 1; m <= 4; ++m) {
            for (bool const is_answered : {false, true}) {
                INFO("the " << n << ". request of the old client, the " << m << ". of the new one");
                remade<Link> it;
                it.kept = it.link;
                series old{[](unsigned) { return read_of(1, 3201); }};
                for (unsigned i = 1; i < n; ++i) {
                    it.ask(0, old);
                    it.answer(old.frame);
                }
                it.ask(0, old);
                unsigned const of_old = old.answered;
                it.make_anew(how);
                series other{[](unsigned) { return read_of(1, 8602); }};
                for (unsigned i = 1; i < m; ++i) {
                    it.ask(1, other);
                    it.answer(other.frame);
                }
                it.ask(1, other);
                unsigned const of_other = other.answered;
                if (is_answered) {
                    it.answer(other.frame);
                }
                it.visit(0, old);
                if (not is_answered) {
                    it.answer(other.frame);
                    it.visit(0, old);
                }
                it.visit(1, other);
                CHECK(other.answered == of_other + 1);
                CHECK(old.answered == of_old);
            }
        }
    }
}

/// A request that was taken when the copy was made, and that left since.
template <typename Link> void sends_nothing_again(way how)
{
    remade<Link> it;
    series old{[](unsigned) { return read_of(1, 3201); }, 1};
    it.visit(0, old);
    it.kept = it.link;
    CHECK(it.kept->poll_transmit().empty());
    it.kept = it.link;
    REQUIRE_FALSE(it.link->poll_transmit().empty());
    it.link->sent(it.now());
    it.answer(old.frame);
    it.visit(0, old);
    REQUIRE(old.answered == 1);
    it.make_anew(how);
    CHECK(it.link->poll_transmit().empty());
    series next{[](unsigned) { return read_of(2, 8602); }, 1};
    for (unsigned pass = 0; pass < 9 and next.answered == 0; ++pass) {
        it.visit(1, next);
        byte_view const left = it.link->poll_transmit();
        if (not left.empty()) {
            CHECK(at({left.begin(), left.end()}, 0) == 2);
            it.link->sent(it.now());
            it.answer(next.frame);
        }
        it.settle();
    }
    CHECK(next.answered == 1);
    CHECK(old.answered == 1);
}

} // namespace

TEST_CASE("defect: A2 a client made anew in its place gives its outcomes to no conversation of the old one")
{
    meets_another_after<client>(way::emplaced);
    meets_another_after<client>(way::assigned);
    meets_another_after<drive_client<2>>(way::emplaced);
}

TEST_CASE("defect: A2 a bus made anew in its place gives its outcomes to no conversation of the old one")
{
    meets_another_after<bus<2>>(way::emplaced);
    meets_another_after<bus<2>>(way::assigned);
}

TEST_CASE("defect: A4 a client that became a copy of before gives its outcomes to no conversation of the old one")
{
    for (way const how : {way::copy_emplaced, way::copy_assigned}) {
        meets_another_after<client>(how);
        meets_another_after<drive_client<2>>(how);
        meets_another_after<bus<2>>(how);
    }
}

TEST_CASE("defect: A4 a copy does not send what its original was about to send")
{
    for (way const how : {way::copy_emplaced, way::copy_assigned}) {
        sends_nothing_again<client>(how);
        sends_nothing_again<drive_client<2>>(how);
        sends_nothing_again<bus<2>>(how);
    }
}
