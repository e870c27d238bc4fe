// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Every kind of conversation that ends, used again: visits send nothing and say so, `again()` begins it anew as it was
// made. That no kind is missing here is a test of the project's shape (tests/structure/lists.py).
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <concepts>
#include <cstdint>
#include <optional>
#include <vector>

#include <rtuwire/altivar/all.hpp>
#include <rtuwire/altivar/atv320_parameters.hpp>
#include <rtuwire/altivar/maintenance/backup.hpp>
#include <rtuwire/altivar/maintenance/restore.hpp>
#include <rtuwire/altivar/procedure/commissioning/broadcast_setting.hpp>
#include <rtuwire/altivar/procedure/commissioning/channel.hpp>
#include <rtuwire/altivar/procedure/commissioning/configure_scanner.hpp>
#include <rtuwire/altivar/procedure/commissioning/recall_from_eeprom.hpp>
#include <rtuwire/altivar/procedure/commissioning/release_link.hpp>
#include <rtuwire/altivar/procedure/commissioning/restore_factory_settings.hpp>
#include <rtuwire/altivar/procedure/commissioning/save_to_eeprom.hpp>
#include <rtuwire/altivar/procedure/inspection/identify.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_freewheel.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/reset_fault.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/plan_writer.hpp>
#include <rtuwire/ask/poller.hpp>
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/ask/words_read.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

template <typename Device> inline constexpr station<Device> drive{unit_id{3}};

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};
using frames = std::vector<test::frame_bytes>;

/// What befalls the line.
enum class fate : std::uint8_t { good, dead, refusing };

/// A drive at one end of a line, a client or a bus at the other.
template <typename Link, typename Device> struct plant : test::simulated_bus<Link, Device> {
    frames sent{};

    explicit plant(fate what) : test::simulated_bus<Link, Device>{Link{test::bus_timing, patient}}
    {
        this->add(unit_id{3});
        this->idle(milliseconds(20));
        this->disturb([this, what](test::frame_bytes& frame, bool is_request) {
            if (is_request) {
                sent.push_back(frame);
            } else if (what == fate::dead) {
                frame.clear();
            } else if (what == fate::refusing) {
                frame = {frame[0], frame[1] | std::byte{0x80}, std::byte{4}};
                std::uint16_t const crc = crc16(frame);
                frame.push_back(static_cast<std::byte>(crc & 0xFFU));
                frame.push_back(static_cast<std::byte>(crc >> 8U));
            }
        });
    }

    template <typename Conversation> void visit(Conversation& conversation, instant now)
    {
        if constexpr (requires { this->link().converse(conversation, now); }) {
            this->link().converse(conversation, now);
        } else {
            this->link().converse(0, conversation, now);
        }
    }

    /// Runs a conversation to its end; what was sent for it.
    template <typename Conversation> frames sent_by(Conversation& conversation)
    {
        sent.clear();
        this->run([&](instant now) { visit(conversation, now); }, [&] { return conversation.settled(); },
                  milliseconds(60'000));
        REQUIRE(conversation.settled());
        return sent;
    }
};

/// Whether it tells that it is used already, and no success.
template <typename Conversation> bool says_used_already(Conversation const& conversation)
{
    if constexpr (requires { conversation.succeeded(); }) {
        if (conversation.succeeded()) {
            return false;
        }
    }
    if constexpr (requires { conversation.reason(0); }) {
        return conversation.reason(0).kind == outcome_kind::used_already;
    } else if constexpr (requires { conversation.reason(); }) {
        return conversation.reason().kind == outcome_kind::used_already;
    } else {
        return conversation.outcome().error() == errc::used_already;
    }
}

template <typename Link, typename Device, typename Make> void use_again(fate what, Make make)
{
    auto conversation = make();
    static_assert(
        requires { conversation.again(); }, "every conversation that ends can begin anew");
    plant<Link, Device> it{what};
    frames const first = it.sent_by(conversation);
    CHECK_FALSE(first.empty());
    CHECK_FALSE(says_used_already(conversation));
    it.sent.clear();
    for (unsigned visit = 0; visit < 5; ++visit) {
        it.step([&](instant now) { it.visit(conversation, now); }, milliseconds(9'000)); // behind its drive's time-out
        CHECK(conversation.settled());
        CHECK(says_used_already(conversation));
    }
    CHECK(it.sent.empty());
    conversation.again();
    CHECK_FALSE(conversation.settled());
    CHECK_FALSE(says_used_already(conversation));
    // On a line as the first one was: the frames of the first time.
    plant<Link, Device> as_before{what};
    CHECK(as_before.sent_by(conversation) == first);
    CHECK_FALSE(says_used_already(conversation));
    // Also begun anew on its way.
    conversation.again();
    plant<Link, Device> cut_short{what};
    cut_short.step([&](instant now) { cut_short.visit(conversation, now); }, milliseconds(1));
    conversation.again();
    plant<Link, Device> once_more{what};
    CHECK(once_more.sent_by(conversation) == first);
}

template <typename Device, typename Make> void use_everywhere(char const* name, Make make)
{
    for (fate const what : {fate::good, fate::dead, fate::refusing}) {
        INFO(name << ", " << static_cast<int>(what));
        use_again<drive_client<4>, Device>(what, make);
        use_again<bus<4>, Device>(what, make);
    }
}

template <typename Device> void use_motion()
{
    constexpr station<Device> const& at = drive<Device>;
    use_everywhere<Device>("start", [&] { return start{at, 40_Hz}; });
    for (stop_by const how :
         {stop_by::ramp, stop_by::freewheel, stop_by::quick_stop, stop_by::halt, stop_by::dc_injection}) {
        if (rtuwire::detail::has_stop(Device::layout, how)) {
            use_everywhere<Device>("stop", [&] { return stop{at, how, milliseconds(2'000)}; });
        }
    }
    use_everywhere<Device>("change_reference", [&] { return change_reference{at, 30_Hz, milliseconds(2'000)}; });
    use_everywhere<Device>("reset_fault", [&] { return reset_fault{at}; });
    use_everywhere<Device>("broadcast_stop", [&] { return broadcast_stop{at}; });
    use_everywhere<Device>("check_supervision", [&] { return check_supervision{at}; });
    use_everywhere<Device>("identify", [&] { return identify<Device>{at}; });
    use_everywhere<Device>("save_to_eeprom", [&] { return save_to_eeprom{at}; });
    use_everywhere<Device>("restore_factory_settings", [&] {
        return restore_factory_settings{at, losing_control_and_address{}, {.accept_unseen_inputs = true}};
    });
}

} // namespace

TEST_CASE("an order that ended and is used again is told apart, sends nothing, and begins anew as it was made")
{
    test::all_drives::for_each([]<typename Device>() { use_motion<Device>(); });
}

TEST_CASE("a set-up that ended and is used again is told apart, sends nothing, and begins anew as it was made")
{
    test::later_drives::for_each([]<typename Device>() {
        use_everywhere<Device>("set_channel", [] {
            return set_channel{drive<Device>, channel_settings<Device>::by_modbus()};
        });
    });
    using device = atv320::device;
    using inputs = scanner_inputs<atv320::eta, atv320::rfrd>;
    using outputs = scanner_outputs<atv320::cmd, atv320::lfrd>;
    use_everywhere<device>("configure_scanner", [] { return configure_scanner<inputs, outputs>{drive<device>}; });
    using old = atv28::device;
    constexpr station<old> const& at = drive<old>;
    use_everywhere<old>("recall_from_eeprom", [&] { return recall_from_eeprom{at}; });
    use_everywhere<old>("release_link", [&] { return atv28::release_link{at}; });
    use_everywhere<old>("activate_link", [&] { return atv28::activate_link{at}; });
    use_everywhere<old>("direct_start", [&] { return atv28::direct_start{at, 40_Hz}; });
    use_everywhere<old>("direct_stop", [&] { return atv28::direct_stop{at, atv28::direct_stop_by::ramp}; });
}

TEST_CASE("a read or a write that ended and is used again is told apart, sends nothing, and begins anew")
{
    using device = atv12::device;
    constexpr station<device> const& at = drive<device>;
    using plan = read_plan<device, atv12::rfr, atv12::acc>;
    using ramps = write_plan<device, atv12::acc, atv12::dec>;
    use_everywhere<device>("register_read", [&] { return read<atv12::rfr>(at); });
    use_everywhere<device>("value_read", [&] { return value_read<atv12::rfr>{unit_id{3}}; });
    use_everywhere<device>("write", [&] { return write<atv12::acc>(at, 2_s); });
    use_everywhere<device>("write_all", [&] { return write_all<atv12::acc, atv12::dec>(at, 2_s, 3_s); });
    use_everywhere<device>("single_request", [&] {
        return single_request{unit_id{3}, read_holding_registers{3'201, 2}};
    });
    use_everywhere<device>("broadcast_setting", [&] { return broadcast_setting<device, atv12::acc>(2_s); });
    use_everywhere<device>("broadcast_freewheel", [&]() -> freewheel_request { return broadcast_freewheel<device>(); });
    use_everywhere<device>("poller", [&] { return poller<plan>{at}; });
    use_everywhere<device>("plan_writer", [&] { return plan_writer<ramps>{at, ramps{2_s, 3_s}}; });
    use_everywhere<device>("line_echo_probe", [&] { return line_echo_probe{unit_id{3}}; });
}

TEST_CASE("a backup or a restore that ended and is used again is told apart, sends nothing, and begins anew")
{
    using device = atv320::device;
    constexpr station<device> const& at = drive<device>;
    unsigned told = 0;
    auto const sink = [&told](parameter_group const&, parameter const&, result<std::uint16_t>) { ++told; };
    auto const report = [&told](parameter_group const&, parameter const&, restore_report const&) { ++told; };
    auto const wanted = [](parameter const& row) -> std::optional<std::uint16_t> {
        return row.code == "ACC" ? std::optional<std::uint16_t>{37} : std::nullopt;
    };
    use_everywhere<device>("backup", [&] { return backup{at, atv320::parameters, sink}; });
    use_everywhere<device>("restore", [&] {
        return restore{at, atv320::parameters, wanted_settings{drive_family::of("ATV320"), wanted}, report, {}};
    });
    CHECK(told != 0);
}

TEST_CASE("a request that could not be made says why once, and once more where it begins anew")
{
    client link{test::bus_timing};
    single_request<read_holding_registers> wrong{unit_id{7}, read_holding_registers{.start = 1, .count = 0}};
    for (unsigned use = 0; use < 2; ++use) {
        link.converse(wrong, instant{0});
        CHECK(wrong.outcome().error() == errc::invalid_quantity);
        link.converse(wrong, instant{0});
        CHECK(wrong.outcome().error() == errc::used_already);
        wrong.again();
    }
    CHECK(link.poll_transmit().empty());
}
