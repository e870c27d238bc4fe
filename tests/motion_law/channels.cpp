// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Who commands a drive is set only while it stands and no terminal asks it to run, and read back.
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/channel.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using state = cia402::state;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};
constexpr std::uint16_t cmd = 8501, chcf = 8401, fr1 = 8413, cd1 = 8423, flo = 8431, tcc = 11101;

/// A client, a commissioned drive whose analog input asks for 30 Hz, and all that is written to it.
template <typename Device> struct bench : test::simulated_bus<drive_client<4>, Device> {
    static constexpr station<Device> drive{unit_id{3}};
    using settings = channel_settings<Device>;
    using words = std::vector<std::pair<std::uint16_t, std::uint16_t>>;
    words writes;
    std::uint16_t replaced{0}; ///< the address whose writes never arrive as they were
    std::uint16_t missing{0};  ///< the register that the drive does not have
    std::uint16_t asked{0};

    bench() : test::simulated_bus<drive_client<4>, Device>{drive_client<4>{test::bus_timing, patient}}
    {
        this->add(unit_id{3});
        this->idle(milliseconds(20));
        far().set_analog_reference(30'000);
        this->disturb([this](std::vector<std::byte>& frame, bool is_request) {
            std::uint16_t const at = u16_at(byte_view{frame}, 2);
            asked = is_request ? at : asked;
            if (is_request and frame[1] == std::byte{6}) {
                writes.emplace_back(at, u16_at(byte_view{frame}, 4));
            }
            if (not is_request and missing == asked and missing != 0) {
                append_crc(frame = {frame[0], frame[1] | std::byte{0x80}, std::byte{2}});
            }
        });
    }
    static void append_crc(std::vector<std::byte>& frame)
    {
        std::uint16_t const crc = crc16(frame);
        frame.push_back(to_byte(crc));
        frame.push_back(to_byte(crc >> 8U));
    }
    detail::simulated_drive<Device>& far() { return this->unit(0).drive(); }
    bool has_power() { return cia402::has_power(far().state_machine().state()); }
    void set(std::uint16_t address, std::uint16_t word)
    {
        register_block const value{word};
        REQUIRE(far().check_write(address, value) == errc::none);
        static_cast<void>(far().write(address, value));
        this->idle(milliseconds(20));
    }
    void close(std::size_t input)
    {
        far().set_input(input, true);
        this->idle(milliseconds(20));
    }
    set_channel told(settings const& wanted, terminal_options const& options = {})
    {
        writes.clear();
        set_channel conversation{drive, wanted, options};
        REQUIRE(this->run(conversation));
        this->idle(milliseconds(500));
        return conversation;
    }
};
using bench_320 = bench<atv320::device>;
using settings_320 = channel_settings<atv320::device>;

constexpr auto apart_by_terminals =
    settings_320{}.with<atv320::chcf>(atv320::channel_mode::sep).with<atv320::cd1>(atv320::command_channel::ter);
constexpr auto local_by_input_3 = settings_320{}.with<atv320::flo>(count16{131});

} // namespace

TEST_CASE("channels are set to Modbus, in an order that has no third channel between, and read back")
{
    test::later_drives::for_each([]<typename Device>() {
        bench<Device> it;
        it.set(chcf, 2);
        it.set(cd1, 1);
        it.set(fr1, 1);
        it.set(flo, 131);
        bool const has_inputs = Device::layout.safeguards.inputs != 0;
        set_channel const conversation =
            it.told(channel_settings<Device>::by_modbus(), {.accept_unseen_inputs = not has_inputs});
        CHECK(conversation.succeeded());
        CHECK(conversation.written() == 4);
        using words = typename bench<Device>::words;
        CHECK(it.writes == words{{cmd, 0}, {fr1, 164}, {cd1, 10}, {chcf, 1}, {flo, 0}});
        start go{it.drive, 20_Hz};
        REQUIRE(it.run(go));
        CHECK(go.succeeded());
        // Again: all is right, nothing is written, also not to a drive that runs.
        CHECK(it.told(channel_settings<Device>::by_modbus()).succeeded());
        CHECK(it.writes.empty());
        CHECK(it.has_power());
    });
}

TEST_CASE("motion law: S29 a channel is not given to terminals that ask to run")
{
    {
        // What a bare write does.
        bench_320 it;
        it.close(1);
        it.set(cd1, 1);
        REQUIRE_FALSE(it.has_power());
        it.set(chcf, 2);
        it.idle(milliseconds(1'000));
        REQUIRE(it.has_power());
        CHECK(it.far().motor().frequency() != 0);
    }
    for (std::size_t const input : {1U, 2U}) {
        bench_320 it;
        it.close(input);
        set_channel const conversation = it.told(apart_by_terminals);
        CHECK(conversation.reason().kind == outcome_kind::run_input_closed);
        CHECK(conversation.address() == 5202);
        CHECK(conversation.word() == input);
        CHECK(it.writes.empty());
        CHECK_FALSE(it.has_power());
    }
    bench_320 it;
    it.close(3);
    CHECK(it.told(apart_by_terminals).succeeded());
    CHECK(it.far().word("CHCF") == 2);
    CHECK_FALSE(it.has_power());
}

TEST_CASE("motion law: S29 an input that forces local control is not assigned under a closed run input")
{
    {
        bench_320 it;
        it.close(1);
        it.close(3);
        it.set(flo, 131);
        REQUIRE(it.has_power());
    }
    bench_320 it;
    it.close(1);
    it.close(3);
    set_channel const conversation = it.told(local_by_input_3);
    CHECK(conversation.reason().kind == outcome_kind::run_input_closed);
    CHECK(conversation.word() == 5);
    CHECK(it.writes.empty());
    CHECK(it.far().word("FLO") == 0);
    CHECK_FALSE(it.has_power());
}

TEST_CASE("motion law: S29 where the inputs cannot be seen the risk has to be taken, and a motor "
          "that starts is told of")
{
    bench<atv310::device> it;
    it.close(1);
    auto const terminals = channel_settings<atv310::device>{}
                               .with<atv310::chcf>(compact::channel_mode::sep)
                               .with<atv310::cd1>(compact::command_channel::ter);
    set_channel const refused = it.told(terminals);
    CHECK(refused.reason().kind == outcome_kind::unknown_register);
    CHECK(it.writes.empty());
    CHECK_FALSE(it.has_power());
    set_channel const taken = it.told(terminals, {.accept_unseen_inputs = true});
    CHECK(taken.reason().kind == outcome_kind::started_by_terminals);
    CHECK(taken.reason().state == state::operation_enabled);
    CHECK(it.writes.back() == std::pair<std::uint16_t, std::uint16_t>{cmd, 0});
    // The same where the drive turns out not to have the register.
    bench_320 other;
    other.missing = 5202;
    set_channel const unseen = other.told(apart_by_terminals);
    CHECK(unseen.reason().kind == outcome_kind::unknown_register);
    CHECK(unseen.address() == 5202);
    CHECK(unseen.word() == 0);
    CHECK(other.told(apart_by_terminals, {.accept_unseen_inputs = true}).succeeded());
}

TEST_CASE("motion law: S29 an input closed between two writes stops the set-up before the next")
{
    bench_320 it;
    bool is_closed = false;
    set_channel conversation{it.drive, apart_by_terminals};
    while (not conversation.settled()) {
        it.step([&](instant now) { it.link().converse(conversation, now); }, milliseconds(5));
        if (not is_closed and conversation.written() == 1) {
            is_closed = true;
            it.far().set_input(1, true);
        }
    }
    CHECK(is_closed);
    CHECK(conversation.reason().kind == outcome_kind::run_input_closed);
    CHECK(it.far().word("CD1") == 1);
    CHECK(it.far().word("CHCF") == 1);
    it.idle(milliseconds(500));
    CHECK_FALSE(it.has_power());
}

TEST_CASE("motion law: S29 channels of a drive that runs, or is in fault, stay as they are")
{
    test::later_drives::for_each([]<typename Device>() {
        bench<Device> other;
        other.set(fr1, 1);
        other.far().inject_fault(9);
        other.idle(milliseconds(500));
        set_channel const in_fault = other.told(channel_settings<Device>::by_modbus(), {.accept_unseen_inputs = true});
        CHECK(in_fault.reason().kind == outcome_kind::in_fault);
        CHECK(in_fault.reason().fault == 9);
        CHECK(other.writes.empty());
    });
    bench_320 it;
    start go{it.drive, 20_Hz};
    REQUIRE(it.run(go));
    CHECK(it.told(apart_by_terminals).reason().kind == outcome_kind::refused_while_running);
    CHECK(it.writes.empty());
    CHECK(it.has_power());
}

TEST_CASE("a control word that stands from before is cleared before Modbus gets the command")
{
    bench_320 it;
    it.set(fr1, 1); // terminals command
    it.set(cmd, 0x000F);
    CHECK(it.told(settings_320::by_modbus()).succeeded());
    CHECK(it.writes.front() == std::pair<std::uint16_t, std::uint16_t>{cmd, 0});
    CHECK(it.far().word("CMD") == 0);
    CHECK_FALSE(it.has_power());
}

TEST_CASE("a setting that reads back otherwise, or is not there, is told by its register")
{
    bench_320 it;
    it.set(fr1, 1);
    // Somebody at the keypad sets it back behind the write.
    it.disturb([&](std::vector<std::byte>& frame, bool is_request) {
        if (not is_request and frame[1] == std::byte{6} and u16_at(byte_view{frame}, 2) == fr1) {
            register_block const value{std::uint16_t{2}};
            static_cast<void>(it.far().write(fr1, value));
        }
    });
    set_channel const back = it.told(settings_320::by_modbus());
    CHECK(back.reason().kind == outcome_kind::not_taken);
    CHECK(back.address() == fr1);
    CHECK(back.word() == 2);

    bench_320 without;
    without.set(fr1, 1);
    without.missing = chcf;
    set_channel const missing = without.told(settings_320::by_modbus());
    CHECK(missing.reason().kind == outcome_kind::unknown_register);
    CHECK(missing.address() == chcf);
    CHECK(missing.word() == 0);
    CHECK(without.writes.empty());
}

TEST_CASE("in three-wire control a standing input starts nothing, and counts for nothing")
{
    bench_320 it;
    it.set(tcc, 1);
    it.set(fr1, 1);
    it.set(fr1, 164);
    it.set(flo, 132);
    it.close(1);
    CHECK(it.told(settings_320::by_modbus()).succeeded());
}

TEST_CASE("a write that is refused is told by its register, and nothing of nothing")
{
    bench_320 it;
    it.set(fr1, 1);
    it.disturb([&](std::vector<std::byte>& frame, bool is_request) {
        if (not is_request and frame[1] == std::byte{6} and u16_at(byte_view{frame}, 2) == fr1) {
            bench_320::append_crc(frame = {frame[0], std::byte{0x86}, std::byte{4}});
        }
    });
    set_channel const refused = it.told(settings_320::by_modbus());
    CHECK(refused.reason().kind == outcome_kind::refused);
    CHECK(refused.reason().error == errc::server_device_failure);
    CHECK(refused.address() == fr1);
    CHECK(refused.word() == 0);
    CHECK(refused.written() == 0);

    bench_320 other;
    set_channel const nothing = other.told(settings_320{});
    CHECK(nothing.succeeded());
    CHECK(nothing.address() == 0);
    CHECK(nothing.word() == 0);
    CHECK(nothing.written() == 0);
    constexpr auto by_line = settings_320{}.with<atv320::fr1>(atv320::reference_channel::mdb);
    CHECK(other.told(by_line).succeeded());
}
