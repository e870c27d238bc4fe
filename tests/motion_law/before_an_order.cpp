// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What has to be known of a drive before its first order: each drive that would not stop by itself, that somebody
// else commands or that starts by itself is refused, with the register that says so; and nothing is written.
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <array>
#include <cstdint>
#include <string>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision.hpp>
#include <rtuwire/ask/single_request.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using state = cia402::state;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};
constexpr std::uint16_t sll = 7010, tto = 6005, chcf = 8401, fr1 = 8413, cd1 = 8423, flo = 8431, atr = 7122,
                        dotd = 8652, cmi_28 = 402, atr_28 = 150, tcc_28 = 6, inputs_28 = 478, eta = 3201;

/// A client, a commissioned drive, and a count of what is written to it.
template <typename Device> struct checked_drive : test::simulated_bus<drive_client<4>, Device> {
    static constexpr station<Device> drive{unit_id{3}};
    unsigned writes{0};
    std::uint16_t missing{0}; ///< the register that the drive does not have
    std::uint16_t asked{0};

    checked_drive() : test::simulated_bus<drive_client<4>, Device>{drive_client<4>{test::bus_timing, patient}}
    {
        this->add(unit_id{3});
        this->idle(milliseconds(20));
        this->disturb([this](std::vector<std::byte>& frame, bool is_request) {
            asked = is_request ? u16_at(byte_view{frame}, 2) : asked;
            writes += is_request and frame[1] != std::byte{3} ? 1U : 0U;
            if (not is_request and missing != 0 and asked == missing) {
                frame = {frame[0], frame[1] | std::byte{0x80}, std::byte{2}};
                std::uint16_t const crc = crc16(frame);
                frame.push_back(to_byte(crc));
                frame.push_back(to_byte(crc >> 8U));
            }
        });
    }
    detail::simulated_drive<Device>& far() { return this->unit(0).drive(); }
    void set(std::uint16_t address, std::uint16_t word)
    {
        register_block const value{word};
        REQUIRE(far().check_write(address, value) == errc::none);
        static_cast<void>(far().write(address, value));
        this->idle(milliseconds(20));
    }
    /// Runs as a controller does that checks nothing; it is silent afterwards.
    void run_anyway(std::uint16_t tenths)
    {
        single_request contact{drive.unit(), read_holding_registers{Device::layout.eta, 1}};
        REQUIRE(this->run(contact));
        set(Device::frequency_reference.address, tenths);
        for (std::uint16_t const word : std::array<std::uint16_t, 3>{0x0006, 0x0007, 0x000F}) {
            set(Device::layout.cmd, word);
        }
        REQUIRE(far().state_machine().state() == state::operation_enabled);
    }
    check_supervision look(supervision_options const& options = {})
    {
        check_supervision conversation{drive, options};
        REQUIRE(this->run(conversation));
        CHECK(writes == 0);
        return conversation;
    }
};

/// Whether a drive is refused by `how`, because of the word of one register; and is not where that risk is accepted.
template <typename Device>
void refuses(checked_drive<Device>& it, outcome_kind how, std::uint16_t address, std::uint16_t word,
             supervision_risks const& risk)
{
    INFO(std::string(Device::name.begin(), Device::name.end()) << " " << address << " = " << word);
    check_supervision const conversation = it.look();
    CHECK_FALSE(conversation.ready());
    CHECK(conversation.reason().kind == how);
    CHECK(conversation.report().address == address);
    CHECK(conversation.report().word == word);
    CHECK(conversation.report().accepted == supervision_risks{});
    check_supervision const taken = it.look({.risks = risk});
    CHECK(taken.ready() == (risk != supervision_risks{}));
    CHECK(taken.report().accepted == risk);
    CHECK(taken.report().address == address);
}

/// Set so, refused so.
template <typename Device>
void refuses_when(std::uint16_t address, std::uint16_t word, outcome_kind how, supervision_risks const& risk)
{
    checked_drive<Device> it;
    it.set(address, word);
    refuses(it, how, address, word, risk);
}

constexpr supervision_risks unsupervised{.accept_unsupervised = true};
constexpr supervision_risks running_on{.accept_running_on = true};
constexpr supervision_risks other_channel{.accept_other_channel = true};
constexpr supervision_risks automatic_restart{.accept_automatic_restart = true};
constexpr supervision_risks closed_input{.accept_closed_run_input = true};
constexpr supervision_risks unknown{.accept_unknown_registers = true};
constexpr supervision_risks none{};

} // namespace

TEST_CASE("motion law: S19 a commissioned drive is ready, and its time-out is known")
{
    test::all_drives::for_each([]<typename Device>() {
        checked_drive<Device> it;
        check_supervision const conversation = it.look();
        CHECK(conversation.ready());
        bool const is_28 = Device::layout.direct_control != 0;
        CHECK(conversation.report().period.timeout == milliseconds(is_28 ? 7'000 : 10'000));
        CHECK(conversation.report().words == word_meaning::cia402);
        CHECK(conversation.report().accepted == none);
        CHECK(conversation.report().address == 0);
        CHECK(conversation.report().word == 0);
        CHECK_FALSE(conversation.report().has_local_input);
    });
}

TEST_CASE("motion law: S19 a drive that does not watch its link is refused")
{
    test::later_drives::for_each([]<typename Device>() {
        refuses_when<Device>(sll, 0, outcome_kind::unsupervised, unsupervised);
        checked_drive<Device> it;
        it.set(sll, 0);
        CHECK(it.look({.risks = unsupervised}).report().period.timeout == duration{});
    });
    refuses_when<atv28::device>(cmi_28, 0x4000, outcome_kind::unsupervised, unsupervised);
}

TEST_CASE("motion law: S19 a drive that runs on without its link is refused")
{
    test::later_drives::for_each(
        []<typename Device>() { refuses_when<Device>(sll, 4, outcome_kind::runs_on_without_link, running_on); });
    refuses_when<atv320::device>(sll, 5, outcome_kind::runs_on_without_link, running_on);
    for (std::uint16_t const stops : std::array<std::uint16_t, 5>{1, 2, 6, 7, 8}) {
        checked_drive<atv320::device> it;
        it.set(sll, stops);
        CHECK(it.look().ready());
    }
}

TEST_CASE("motion law: S19 a drive whose control word is single bits is refused, whatever is accepted")
{
    refuses_when<atv320::device>(chcf, 3, outcome_kind::not_drive_profile, none);
    checked_drive<atv320::device> it;
    it.set(chcf, 3);
    supervision_risks const all{true, true, true, true, true, true, true};
    CHECK(it.look({.risks = all}).reason().kind == outcome_kind::not_drive_profile);
    CHECK(it.look({.risks = all}).report().words == word_meaning::unknown);
}

TEST_CASE("motion law: S19 a drive that another channel commands is refused")
{
    test::later_drives::for_each([]<typename Device>() {
        // Together, the reference's channel commands as well, and the status says "local".
        checked_drive<Device> together;
        together.set(fr1, 1);
        CHECK(together.look().reason().kind == outcome_kind::other_channel);
        CHECK(together.look().report().address == fr1);
        CHECK(together.look({.risks = other_channel}).ready());
        // Apart, either may be elsewhere.
        checked_drive<Device> command;
        command.set(chcf, 2);
        CHECK(command.look().ready());
        command.set(cd1, 1);
        CHECK(command.look().reason().kind == outcome_kind::other_channel);
        CHECK(command.look().report().address == cd1);
        checked_drive<Device> reference;
        reference.set(chcf, 2);
        reference.set(fr1, 1);
        refuses(reference, outcome_kind::other_channel, fr1, 1, other_channel);
        // Together, CD1 counts for nothing.
        checked_drive<Device> without;
        without.set(cd1, 1);
        CHECK(without.look().ready());
    });
}

TEST_CASE("motion law: S19 a drive in local control is refused by its status")
{
    test::all_drives::for_each([]<typename Device>() {
        checked_drive<Device> it;
        it.far().set_local(true);
        it.idle(milliseconds(20));
        check_supervision const conversation = it.look();
        CHECK(conversation.reason().kind == outcome_kind::local_control);
        CHECK(conversation.report().address == Device::layout.eta);
        CHECK((conversation.report().word & 0x0200) == 0);
    });
    checked_drive<atv320::device> it;
    it.set(flo, 131);
    CHECK(it.look().ready());
    CHECK(it.look().report().has_local_input);
    it.far().set_input(3, true);
    it.idle(milliseconds(20));
    CHECK(it.look().reason().kind == outcome_kind::local_control);
}

TEST_CASE("motion law: S19 what is not known is refused, and the register named")
{
    test::later_drives::for_each([]<typename Device>() {
        for (std::uint16_t const address : {sll, tto, chcf, fr1}) {
            checked_drive<Device> it;
            it.missing = address;
            refuses(it, outcome_kind::unknown_register, address, 0, unknown);
            CHECK(it.look().reason().error == errc::illegal_data_address);
        }
        checked_drive<Device> it;
        it.missing = chcf;
        CHECK(it.look({.risks = unknown}).report().words == word_meaning::unknown);
        it.missing = sll; // a time-out is a time-out
        CHECK(it.look({.risks = unknown}).report().period.timeout == milliseconds(10'000));
        it.missing = flo; // tells nothing that the status does not
        CHECK(it.look().ready());
    });
    checked_drive<atv320::device> it;
    it.missing = atr;
    refuses(it, outcome_kind::unknown_register, atr, 0, unknown);
    it.missing = dotd; // what a stop means, not whether there is one
    CHECK(it.look().ready());
    CHECK(it.look().report().words == word_meaning::unknown);
    it.missing = 0;
    it.set(dotd, 0);
    CHECK(it.look().ready());
    CHECK(it.look().report().words == word_meaning::unknown);
}

TEST_CASE("motion law: S19 a line that fails is not a drive that is ready")
{
    checked_drive<atv320::device> it;
    it.cut(0, true);
    check_supervision const conversation = it.look({.risks = unknown});
    CHECK(conversation.reason().kind == outcome_kind::silent);
    CHECK(conversation.reason().error == errc::timed_out);
}

TEST_CASE("motion law: S19 what is refused runs on for minutes once its controller is gone")
{
    test::later_drives::for_each([]<typename Device>() {
        checked_drive<Device> ready;
        ready.run_anyway(400);
        ready.idle(milliseconds(120'000));
        CHECK(ready.far().state_machine().state() == state::fault);
        CHECK(ready.far().motor().frequency() == 0);
        checked_drive<Device> off;
        off.set(sll, 0);
        off.run_anyway(400);
        off.idle(milliseconds(120'000));
        CHECK(off.far().motor().frequency() == 40'000);
        checked_drive<Device> falls_back;
        falls_back.set(sll, 4);
        falls_back.run_anyway(400);
        falls_back.idle(milliseconds(120'000));
        CHECK(cia402::has_power(falls_back.far().state_machine().state()));
    });
    checked_drive<atv320::device> keeps;
    keeps.set(sll, 5);
    keeps.run_anyway(400);
    keeps.idle(milliseconds(120'000));
    CHECK(keeps.far().motor().frequency() == 40'000);
    checked_drive<atv28::device> old;
    old.set(cmi_28, 0x4000);
    old.run_anyway(400);
    old.idle(milliseconds(120'000));
    CHECK(old.far().motor().frequency() == 40'000);
}

TEST_CASE("motion law: S28 a drive that restarts by itself runs again by mere reads, and is "
          "refused before")
{
    checked_drive<atv320::device> it;
    it.set(atr, 1);
    refuses(it, outcome_kind::restarts_by_itself, atr, 1, automatic_restart);

    it.run_anyway(400);
    it.idle(milliseconds(15'000)); // past its time-out of 10 s
    REQUIRE(it.far().state_machine().state() == state::fault);
    it.writes = 0;
    for (unsigned i = 0; i < 30; ++i) {
        single_request look{it.drive.unit(), read_holding_registers{eta, 1}};
        REQUIRE(it.run(look));
        it.idle(milliseconds(100));
    }
    CHECK(it.writes == 0);
    CHECK(it.far().state_machine().state() == state::operation_enabled);
    CHECK(it.far().motor().frequency() != 0);
}

TEST_CASE("motion law: S28 an ATV28 is asked for its ATR, too")
{
    refuses_when<atv28::device>(atr_28, 1, outcome_kind::restarts_by_itself, automatic_restart);
    refuses_when<atv28::device>(atr_28, 2, outcome_kind::restarts_by_itself, automatic_restart);
}

TEST_CASE("motion law: S29 an ATV28 with a closed run input runs after its power came back, and is "
          "refused before")
{
    for (std::size_t const input : {1U, 2U}) {
        checked_drive<atv28::device> it;
        single_request takes_over{it.drive.unit(), write_single_register{400, 0}};
        REQUIRE(it.run(takes_over));
        it.writes = 0;
        it.far().set_input(input, true);
        it.idle(milliseconds(20));
        refuses(it, outcome_kind::run_input_closed, inputs_28, static_cast<std::uint16_t>(input), closed_input);
        CHECK(it.look({.run_inputs = 0}).ready());
        if (input == 1) {
            CHECK_FALSE(cia402::has_power(it.far().state_machine().state()));
            it.far().power_cycle(it.now());
            it.idle(milliseconds(100));
            CHECK(cia402::has_power(it.far().state_machine().state()));
        }
    }
    // In three-wire control LI1 is the stop input, closed as a rule.
    checked_drive<atv28::device> it;
    it.set(tcc_28, 1);
    single_request takes_over{it.drive.unit(), write_single_register{400, 0}};
    REQUIRE(it.run(takes_over));
    it.writes = 0;
    it.far().set_input(1, true);
    it.idle(milliseconds(20));
    CHECK(it.look().ready());
    // A later drive under Modbus does not care for it.
    checked_drive<atv320::device> later;
    later.far().set_input(1, true);
    later.idle(milliseconds(20));
    CHECK(later.look().ready());
}

TEST_CASE("motion law: S36 a time-out that the line cannot keep is refused with both figures")
{
    checked_drive<atv320::device> it;
    it.set(tto, 10);
    // Thirty slots with exchanges of 30 ms, and one dead unit whose time-out is a second.
    duration const gap = longest_gap_of(30, milliseconds(30), milliseconds(1'000));
    CHECK(gap == milliseconds(1'900));
    check_supervision const conversation = it.look({.longest_gap = gap});
    CHECK(conversation.reason().kind == outcome_kind::timeout_too_short);
    CHECK(conversation.report().period == period_rule{milliseconds(1'000), milliseconds(1'900)});
    CHECK(conversation.report().period.shortest_timeout() == milliseconds(5'700));
    CHECK(conversation.report().address == tto);
    CHECK(conversation.report().word == 10);
    CHECK(it.look({.risks = {.accept_short_timeout = true}, .longest_gap = gap}).ready());
    it.set(tto, 57);
    CHECK(it.look({.longest_gap = gap}).ready());
    it.set(tto, 56);
    CHECK_FALSE(it.look({.longest_gap = gap}).ready());
    // 7 s are 7 s.
    checked_drive<atv28::device> old;
    CHECK(old.look({.longest_gap = milliseconds(2'333)}).ready());
    CHECK(old.look({.longest_gap = milliseconds(2'334)}).reason().kind == outcome_kind::timeout_too_short);
    CHECK(old.look({.longest_gap = milliseconds(2'334)}).report().address == 0);
}
