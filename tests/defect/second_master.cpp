// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An order to run whose drive another master writes to, between any two of its requests.
#include "motion_law/plant.hpp"
#include "support/catch.hpp"
#include "support/drives.hpp"

#include <array>
#include <cstdint>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr std::int32_t asked = 30'000; ///< mHz

/// A drive and its client. Another master, on a line of its own, speaks right behind the n-th response from here.
template <typename Device> struct contested : test::plant<Device> {
    unsigned speaks_behind{0};
    unsigned responses{0};
    unsigned last_look{0};      ///< the response that held the drive's reference last
    unsigned enabled_behind{0}; ///< the same, before the first command to run from here
    bool has_adopted{false};    ///< a word that runs went to a motor that was seen to run by another master's

    /// What that master does.
    template <typename Speak> void listen(Speak speak)
    {
        responses = last_look = enabled_behind = 0;
        this->disturb([this, speak](test::frame_bytes& frame, bool is_request) {
            if (is_request) {
                return note_request(frame);
            }
            if (++responses == speaks_behind) {
                speak(*this);
            }
        });
    }
    /// What is written from this response on, its order cannot know: nothing where it never looks.
    unsigned knows_until() const { return last_look != 0 ? last_look : responses; }
    void write(std::uint16_t address, std::uint16_t word)
    {
        register_block<1> const one{word};
        REQUIRE(this->far().write(address, one) == errc::none);
    }
    bool has_power() { return cia402::has_power(this->far().state_machine().state()); }
    std::int32_t reference() { return static_cast<std::int16_t>(this->far().word("LFR")) * 100; }

private:
    void note_request(byte_view frame)
    {
        bool const runs = this->far().state_machine().state() == cia402::state::operation_enabled;
        std::uint16_t const first = u16_at(frame, 2), second = u16_at(frame, 4); // a word, or how many are read
        bool const is_read = frame[1] == std::byte{3};
        for (std::uint16_t each : {Device::frequency_reference.address, Device::speed_reference.address}) {
            last_look = is_read and each >= first and each < first + second ? responses + 1 : last_look;
        }
        ran_at_look = is_read and first == Device::layout.cmd ? runs : ran_at_look;
        bool const is_word = frame[1] == std::byte{6} and first == Device::layout.cmd;
        bool const is_to_run = is_word and (second & 0x000AU) == 0x000AU and enabled_behind == 0;
        enabled_behind = is_to_run ? last_look : enabled_behind;
        has_adopted = has_adopted or (is_to_run and ran_at_look);
    }

    bool ran_at_look{false}; ///< when its control word was read last
};

/// Another master's reference behind each response of an order in turn: -50 Hz.
template <typename Device, typename Make> void refer_otherwise(Make make)
{
    contested<Device> alone;
    alone.listen([](auto&) {});
    auto undisturbed = make();
    alone.watch(undisturbed, milliseconds(3'000));
    REQUIRE(undisturbed.running());
    unsigned withdrawn = 0;
    for (unsigned behind = 1; behind < alone.knows_until(); ++behind) {
        INFO("behind response " << behind << "; the last looks are " << alone.enabled_behind << " and "
                                << alone.last_look);
        contested<Device> it;
        it.speaks_behind = behind;
        it.listen([](auto& at) { at.write(Device::frequency_reference.address, 0xFE0C); });
        auto go = make();
        auto const seen = it.watch(go, milliseconds(6'000));
        CHECK(go.settled());
        // Where the words cross on the line the motor may begin to turn: one look later it is stopped.
        bool const do_cross = alone.enabled_behind != 0 and behind >= alone.enabled_behind;
        CHECK(seen.lowest >= (do_cross ? -3'000 : 0));
        CHECK(go.running() == (it.reference() == asked));
        CHECK(go.running() == it.has_power());
        withdrawn += go.running() ? 0U : 1U;
    }
    CHECK(withdrawn >= 2);
}

} // namespace

TEST_CASE("defect: no start enables at another master's reference, or is done at it")
{
    test::all_drives::for_each([]<typename Device>() {
        refer_otherwise<Device>([] { return start{contested<Device>::drive, 30_Hz}; });
    });
}

TEST_CASE("defect: no start in rpm enables at another master's reference, or is done at it")
{
    test::all_drives::for_each([]<typename Device>() {
        refer_otherwise<Device>([] { return start{contested<Device>::drive, 900_rpm}; });
    });
}

TEST_CASE("defect: no direct start runs at another master's reference, or is done at it")
{
    using drive = contested<atv28::device>;
    refer_otherwise<atv28::device>([] { return atv28::direct_start{drive::drive, 30_Hz}; });
    refer_otherwise<atv28::device>([] { return atv28::direct_start{drive::drive, 900_rpm}; });
}

TEST_CASE("defect: no start of a running motor is done at another master's reference")
{
    test::all_drives::for_each([]<typename Device>() {
        unsigned known = 0;
        for (unsigned behind = 0; behind == 0 or behind < known; ++behind) {
            INFO("behind response " << behind);
            contested<Device> it;
            start first{it.drive, 10_Hz};
            REQUIRE(it.run(first));
            REQUIRE(first.running());
            it.speaks_behind = behind; // 0: never
            it.listen([](auto& at) { at.write(Device::frequency_reference.address, 0xFE0C); });
            start go{it.drive, 30_Hz};
            it.watch(go, milliseconds(6'000));
            known = behind == 0 ? it.knows_until() : known;
            CHECK(go.running() == (it.reference() == asked));
            CHECK(go.running() == it.has_power());
        }
        CHECK(known > 12);
    });
}

TEST_CASE("defect: no start adopts a motor that another master enables between two of its words")
{
    test::all_drives::for_each([]<typename Device>() {
        unsigned told = 0;
        for (unsigned behind = 1; behind < 40; ++behind) {
            INFO("behind response " << behind);
            contested<Device> it;
            it.speaks_behind = behind;
            it.listen([](auto& at) {
                for (std::uint16_t const each : std::array<std::uint16_t, 3>{0x0006, 0x0007, 0x000F}) {
                    at.write(Device::layout.cmd, each);
                }
            });
            start go{it.drive, 30_Hz};
            it.watch(go, milliseconds(4'000));
            if (behind > 2 and it.responses <= behind) {
                break;
            }
            CHECK(go.settled());
            CHECK_FALSE(it.has_adopted);
            told += go.reason().kind == outcome_kind::overwritten ? 1U : 0U;
        }
        CHECK(told > 8); // its check, and its words but the first
    });
}

TEST_CASE("defect: no start goes on from a state that no word of its own explains")
{
    test::all_drives::for_each([]<typename Device>() {
        contested<Device> it;
        it.speaks_behind = 1; // the check is still to come
        it.listen([](auto& at) { at.write(Device::layout.cmd, 0x0006); });
        start go{it.drive, 30_Hz};
        CHECK(it.watch(go, milliseconds(4'000)).highest == 0);
        CHECK(go.reason().kind == outcome_kind::overwritten);
        CHECK(it.far().word("CMD") == 0x0006); // no word left
    });
}

TEST_CASE("defect: no change of a reference is done of a motor that another master has stopped")
{
    test::all_drives::for_each([]<typename Device>() {
        for (std::int16_t const to : {std::int16_t{250}, std::int16_t{800}}) { // reached, and limited to HSP
            unsigned responses = 0;
            for (unsigned behind = 0; behind == 0 or behind < responses; ++behind) {
                INFO("to " << to << ", behind response " << behind << " of " << responses);
                contested<Device> it;
                start first{it.drive, 20_Hz};
                REQUIRE(it.run(first));
                it.idle(milliseconds(3'000));
                it.speaks_behind = behind; // 0: never
                it.listen([](auto& at) { at.write(Device::layout.cmd, 0x0000); });
                change_reference change{it.drive, *setting<Device::frequency_reference>::checked(signed_decihertz{to}),
                                        milliseconds(30'000), beyond_limits::limit};
                REQUIRE(it.run(change));
                responses = behind == 0 ? it.responses : responses;
                bool const is_done = change.succeeded() or change.reason().kind == outcome_kind::reference_limited;
                CHECK(is_done == (behind == 0));
                CHECK(is_done == it.has_power());
            }
            CHECK(responses > 6);
        }
    });
}
