// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A hundred thousand random lives of a drive and its controller: faults, local control, a cut cable and
// the STOP key at any moment. A run is named by its number.
#include <rtuwire/altivar/cyclic.hpp>

#include <optional>

#include "support/catch.hpp"
#include "support/party_line.hpp"
#include "support/random.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/change_reference.hpp>
#include <rtuwire/altivar/reset_fault.hpp>
#include <rtuwire/altivar/start.hpp>
#include <rtuwire/altivar/stop.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using state = cia402::state;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(40), .retries = 1};
/// One transaction with all that may go wrong: two attempts, quarantine, the line's silence.
constexpr duration longest_transaction = milliseconds(500);

/// A drive to which things happen, and what is known of them.
template <typename Device> struct life : test::party_line<drive_client<4>, Device> {
    test::random random;
    bool is_disturbed{false}; ///< something took it out of its state, and no answer told so yet
    std::size_t told_by{0};   ///< the number of the first request whose answer tells
    bool was_cut{false};
    bool was_local{false};
    bool was_tripped{false};
    bool was_stopped{false};
    bool is_local{false};

    explicit life(std::uint32_t seed)
        : test::party_line<drive_client<4>, Device>{drive_client<4>{test::party_timing, patient},
                                           instant{seed * 2'654'435'761U}},
          random{seed * 40'503U + 1U}
    {
        this->add(unit_id{3});
        this->idle(milliseconds(5));
        for (unsigned warm = 0; warm < 50; ++warm) {
            random.next();
        }
    }

    sim::drive<Device>& far() { return this->drive(0); }

    /// One of the things that happen to drives.
    void happen()
    {
        state const before = far().chart().state();
        bool const was_key = (far().word("ETA") & stop_key_bit) != 0;
        switch (random.below(8)) {
        case 0:
            far().inject_fault(9);
            was_tripped = true;
            break;
        case 1: far().clear_cause(); break;
        case 2:
        case 3:
            is_local = random.below(3) == 0;
            far().set_local(is_local);
            was_local = was_local or is_local;
            break;
        case 4:
            this->cut(0, true);
            was_cut = true;
            break;
        case 5:
        case 6: this->cut(0, false); break;
        default:
            far().press_stop();
            was_stopped = true;
            break;
        }
        // Falling back between two looks is not to be seen, but that the motor no longer runs is, and
        // a key or a mode that the status word shows.
        bool const shows_key = (far().word("ETA") & stop_key_bit) != 0 and not was_key;
        state const after = far().chart().state();
        bool const no_longer_runs = before == state::operation_enabled and after != before;
        if (is_local or shows_key or no_longer_runs or cia402::is_in_fault(after)) {
            is_disturbed = true;
            told_by = this->unit(0).requests() + 1;
        }
    }

    /// Whether the last question commanded the motor to run.
    bool question_enables()
    {
        auto const frame = this->question();
        auto const is_enabling = [&](std::size_t at) {
            return frame.size() >= at + 4 and (u16_at(frame, at) & 0x8FU) == 0x0F;
        };
        switch (to_u8(frame[1])) {
        case 6: return u16_at(frame, 2) == Device::profile.cmd and is_enabling(4);
        case 16: return is_enabling(7);
        case 23: return is_enabling(11);
        default: return false;
        }
    }
};

/// Cycles through a random life; whether it ever enabled without an order.
template <typename Device> bool cycles_well(std::uint32_t seed)
{
    life<Device> it{seed};
    cyclic<Device> loop{station<Device>{unit_id{3}}, {.period = milliseconds(150)}};
    bool is_allowed = false;
    bool is_good = true;
    auto const order = [&] {
        if constexpr (cycle_words<Device>::has_scanner) {
            return loop.run(900_rpm);
        } else {
            return loop.run(30_Hz);
        }
    };
    for (unsigned moment = 0; moment < 12; ++moment) {
        switch (it.random.below(6)) {
        case 0:
        case 1:
        case 2: is_allowed = order() or is_allowed; break;
        case 3: loop.reset_fault(); break;
        case 4:
            loop.stop();
            is_allowed = false;
            break;
        default: it.happen(); break;
        }
        instant const end = it.now() + milliseconds(50 + it.random.below(400));
        while (not reached(it.now(), end)) {
            std::size_t const questions = it.questions();
            std::size_t const answers = it.answers(0);
            bool const was_lost = loop.link_lost();
            it.step([&](instant now) { it.link().converse(loop, now); }, end - it.now());
            if (it.questions() != questions and it.question_enables() and not is_allowed) {
                is_good = false;
            }
            bool const is_heard = it.answers(0) != answers;
            if ((is_heard and it.is_disturbed and it.unit(0).requests() >= it.told_by) or
                (loop.link_lost() and not was_lost)) {
                is_allowed = false;
                it.is_disturbed = it.is_local;
            }
        }
    }
    return is_good;
}

/// Whether a conversation's reason is one that its life explains.
template <typename Device> bool is_explained(reason const& told, life<Device>& it)
{
    switch (told.how) {
    case ending::pending:
    case ending::executed_unconfirmed:
    case ending::unsupported:
    case ending::misconfigured:
    case ending::refused_while_running:
    case ending::halted:
    case ending::overwritten:
    case ending::overruled:
    case ending::contradictory:
    case ending::unchecked:
    case ending::unsupervised:
    case ending::runs_on_without_link:
    case ending::other_channel:
    case ending::not_drive_profile:
    case ending::restarts_by_itself:
    case ending::unknown_register:
    case ending::timeout_too_short:
    case ending::run_input_closed:
    case ending::not_taken:
    case ending::started_by_terminals:
    case ending::reference_limited: return false;
    case ending::succeeded: return true;
    case ending::refused: return it.was_local;
    case ending::silent: return it.was_cut and told.error != errc::none;
    case ending::unconfirmed:
    case ending::stuck: return it.was_local or it.was_tripped or it.was_stopped or it.was_cut;
    case ending::in_fault: return (it.was_tripped or it.was_cut) and told.fault != 0;
    case ending::local_control: return it.was_local;
    }
    return false;
}

/// Runs a conversation while things happen; whether it ends in time and for a reason.
template <typename Device, typename Talk>
bool ends_well(life<Device>& it, Talk talk, duration limit, unsigned mishaps)
{
    instant const start = it.now();
    instant next_mishap = start + milliseconds(it.random.below(300));
    duration const most = limit + longest_transaction + longest_transaction;
    while (not talk.settled()) {
        if (not(it.now() - start < most)) {
            return false;
        }
        it.step([&](instant now) { it.link().converse(talk, now); }, milliseconds(20));
        if (mishaps > 0 and reached(it.now(), next_mishap)) {
            --mishaps;
            it.happen();
            next_mishap = it.now() + milliseconds(it.random.below(400));
        }
    }
    return is_explained(talk.reason(), it);
}

template <typename Device> bool talks_well(std::uint32_t seed)
{
    life<Device> it{seed};
    station<Device> const drive{unit_id{3}};
    constexpr duration limit = milliseconds(1'500);
    bool is_good = true;
    bool const is_quiet = it.random.below(4) == 0;
    for (unsigned turn = 0; turn < 3 and is_good; ++turn) {
        unsigned const mishaps = is_quiet ? 0 : it.random.below(3);
        switch (it.random.below(4)) {
        case 0:
        case 1:
            is_good = ends_well(it, start{drive, 30_Hz, heading::forward, limit},
                                limit + start_script::grace, mishaps);
            break;
        case 2:
            is_good =
                ends_well(it, altivar::stop{drive, stop_by::freewheel, limit}, limit, mishaps);
            break;
        default: is_good = ends_well(it, reset_fault{drive, limit}, limit, mishaps); break;
        }
    }
    return is_good;
}

/// The first bad run of many, if there is one.
template <typename Good> std::optional<std::uint32_t> first_bad(std::uint32_t runs, Good is_good)
{
    for (std::uint32_t seed = 1; seed <= runs; ++seed) {
        if (not is_good(seed)) {
            return seed;
        }
    }
    return std::nullopt;
}

} // namespace

TEST_CASE("in 50000 random lives no cycle enables a drive without a new order")
{
    CHECK(first_bad(20'000, cycles_well<atv320::device>) == std::nullopt);
    CHECK(first_bad(15'000, cycles_well<atv12::device>) == std::nullopt);
    CHECK(first_bad(15'000, cycles_well<atv28::device>) == std::nullopt);
}

TEST_CASE("in 50000 random lives every conversation ends in time and tells why")
{
    CHECK(first_bad(20'000, talks_well<atv320::device>) == std::nullopt);
    CHECK(first_bad(15'000, talks_well<atv12::device>) == std::nullopt);
    CHECK(first_bad(15'000, talks_well<atv28::device>) == std::nullopt);
}
