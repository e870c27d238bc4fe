// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The table of the check before a write: each stage and each answer.
#include <rtuwire/altivar/maintenance/guarded_write.hpp>

#include <vector>

#include "altivar/procedure/status_words.hpp"
#include "support/catch.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/device/atv320.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using kind = outcome_kind;

namespace {

constexpr std::uint16_t eta = 3201, rfr = 3202, cmd = 8501, tcc = 11101, inputs = 5202;

write_guard guard() { return write_guard{atv320::device::layout, {}}; }

bool is_read_of(action what, std::uint16_t address)
{
    return what_of(what) == action_kind::read and address_of(what) == address;
}

/// How the check ends after these answers; `pending` where it asks for more.
kind after(write_care care, std::vector<event> const& answers)
{
    write_guard one = guard();
    CHECK(is_read_of(one.begin(care), eta));
    for (event each : answers) {
        CHECK(one.reason().kind == kind::pending);
        static_cast<void>(one.step(each));
    }
    return one.reason().kind;
}

/// What a write may do to a motor that the terminals command, by the words of the roles.
constexpr bool care_is_taken()
{
    using role = parameter_role;
    for (role const each :
         {role::setting, role::step_size, role::frequency_limit, role::motion, role::link_timeout, role::link}) {
        if (care_for(each) != write_care::rest) {
            return false;
        }
    }
    return care_for(role::supervision) == write_care::open_inputs and
           care_for(role::restart) == write_care::open_inputs and care_for(role::channel) == write_care::open_inputs and
           care_for(role::macro) == write_care::all_inputs and care_for(role::run_input) == write_care::all_inputs;
}

} // namespace

PROOF("inputs are looked at before what may start a motor", care_is_taken)

TEST_CASE("the states that a drive may be written in")
{
    constexpr std::array expected{kind::aborted,
                                  kind::pending,
                                  kind::pending,
                                  kind::pending,
                                  kind::refused_while_running,
                                  kind::refused_while_running,
                                  kind::refused_while_running,
                                  kind::pending,
                                  kind::aborted,
                                  kind::silent,
                                  kind::refused,
                                  kind::aborted};
    for (std::size_t i = 0; i < looks.size(); ++i) {
        INFO(looks[i].name);
        CHECK(after(write_care::rest, {looks[i].what}) == expected[i]);
        CHECK(after(write_care::open_inputs, {looks[i].what}) == expected[i]);
    }
}

TEST_CASE("any command but 0000, and any speed but 0, forbids a write")
{
    for (std::uint32_t value = 1; value < 0x1'0000; ++value) {
        auto const each = static_cast<std::uint16_t>(value);
        write_guard one = guard();
        static_cast<void>(one.begin(write_care::rest));
        static_cast<void>(one.step(word(disabled_word)));
        write_guard other = one;
        static_cast<void>(one.step(word(each)));
        static_cast<void>(other.step(word(0)));
        static_cast<void>(other.step(word(each)));
        REQUIRE(one.reason().kind == kind::overwritten);
        REQUIRE(other.reason().kind == kind::refused_while_running);
    }
    CHECK(after(write_care::rest, {word(disabled_word), word(0), word(0)}) == kind::succeeded);
    CHECK(after(write_care::rest, {word(fault_word), word(0), word(0)}) == kind::succeeded);
}

TEST_CASE("a write that may start the motor needs a drive without fault, and open run inputs")
{
    write_guard one = guard();
    CHECK(is_read_of(one.begin(write_care::open_inputs), eta));
    CHECK(is_read_of(one.step(word(disabled_word)), cmd));
    CHECK(is_read_of(one.step(word(0)), rfr));
    CHECK(is_read_of(one.step(word(0)), eta));
    CHECK(is_read_of(one.step(word(disabled_word)), tcc));
    CHECK(is_read_of(one.step(word(0)), inputs));
    write_guard closed = one;
    static_cast<void>(one.step(word(0xFFFC)));
    CHECK(one.reason().kind == kind::succeeded);
    static_cast<void>(closed.step(word(2)));
    CHECK(closed.reason().kind == kind::run_input_closed);

    std::vector<event> const stands{word(disabled_word), word(0), word(0)};
    auto const then = [&](std::vector<event> const& more) {
        std::vector<event> all = stands;
        all.insert(all.end(), more.begin(), more.end());
        return after(write_care::open_inputs, all);
    };
    CHECK(then({word(fault_word), word(5)}) == kind::in_fault);
    CHECK(then({word(enabled_word)}) == kind::refused_while_running);
    CHECK(then({failed(errc::timed_out)}) == kind::silent);
    CHECK(then({word(disabled_word), word(0), failed(errc::illegal_data_address)}) == kind::unknown_register);
}

TEST_CASE("in three-wire control the inputs do not matter, but to a write that may end it")
{
    std::vector<event> const stands{word(disabled_word), word(0), word(0), word(disabled_word)};
    auto const then = [&](write_care care, std::vector<event> const& more) {
        std::vector<event> all = stands;
        all.insert(all.end(), more.begin(), more.end());
        return after(care, all);
    };
    CHECK(then(write_care::open_inputs, {word(1)}) == kind::succeeded); // TCC says three wires
    CHECK(then(write_care::all_inputs, {word(1)}) == kind::run_input_closed);
    CHECK(then(write_care::all_inputs, {word(0)}) == kind::succeeded);
    CHECK(then(write_care::all_inputs, {failed(errc::illegal_data_address)}) == kind::unknown_register);
}

TEST_CASE("a check may be begun again")
{
    write_guard one = guard();
    static_cast<void>(one.begin(write_care::open_inputs));
    static_cast<void>(one.step(word(enabled_word)));
    REQUIRE(one.reason().kind == kind::refused_while_running);
    CHECK(is_read_of(one.begin(write_care::rest), eta));
    CHECK(one.reason().kind == kind::pending);
    for (event each : {word(disabled_word), word(0), word(0)}) {
        static_cast<void>(one.step(each));
    }
    CHECK(one.reason().kind == kind::succeeded);
}
