// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Registers of several words and of all four kinds: their requests byte by byte, what is read of them, and the plans
// that keep words together.
#include <rtuwire/ask/access.hpp>

#include <array>

#include "support/proof.hpp"

#include <rtuwire/ask/plan_writer.hpp>
#include <rtuwire/ask/poller.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/table/form/ascii.hpp>
#include <rtuwire/table/form/floating.hpp>
#include <rtuwire/table/form/packed.hpp>
#include <rtuwire/table/form/whole.hpp>
#include <rtuwire/wire/functions.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace meter {

enum class tariff : std::uint16_t { day = 1, night = 2 };

} // namespace meter

template <>
inline constexpr auto rtuwire::enumerators<meter::tariff> = rtuwire::detail::name_list({{1, "day"}, {2, "night"}});

namespace meter {

// The same address in four spaces: four registers.
constexpr reg<float32<kilowatt_hours, word_order::low_first>> energy{.code = "ENERGY", .address = 40};
constexpr reg<unsigned32<watt_hours>> budget{.code = "BUDGET", .address = 42, .max = 5'000'000};
constexpr reg<known<tariff>> in_force{.code = "TARIFF", .address = 44};
constexpr reg<decihertz> setpoint{.code = "SET", .address = 45, .max = 600};
constexpr reg<ascii<6>> place{.code = "PLACE", .address = 46};
constexpr input_reg<decivolts> voltage{.code = "U", .address = 40};
constexpr input_reg<signed_count16> scale{.code = "SF", .address = 43};
constexpr input_reg<scaled_by<quantity<power, std::int16_t>, scale>> load{.code = "P", .address = 41};
constexpr coil relay{.code = "K1", .address = 40};
constexpr coil lamp{.code = "H1", .address = 41};
constexpr discrete_input door{.code = "S1", .address = 40};

struct device {
    static constexpr literal name{"meter"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{.read = 6};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 1> readable{{{42, 42, register_space::input}}};
    using registers = table<energy, budget, in_force, setpoint, place, voltage, scale, load, relay, lamp, door>;
};

} // namespace meter

namespace {

constexpr station<meter::device> unit{unit_id{3}};

/// The request's bytes without its CRC, which other tests hold.
template <typename Conversation, std::size_t Size>
constexpr bool asks(Conversation const& conversation, std::array<std::byte, Size> const& without_crc)
{
    auto const request = conversation.next();
    return request and request->frame().size() == Size + 2 and check_frame(request->frame()) == errc::none and
           same_bytes(request->frame().first(Size), without_crc);
}

template <typename Conversation, std::size_t Size>
constexpr auto answered(Conversation conversation, std::array<std::byte, Size> const& pdu)
{
    conversation.accept(result<response>{response{pdu}});
    return conversation.outcome();
}

// One request each, by the function of its kind.
STATIC_CHECK(asks(read<meter::energy>(unit), "03 03 00 28 00 02"_hex));
STATIC_CHECK(asks(read<meter::place>(unit), "03 03 00 2E 00 03"_hex));
STATIC_CHECK(asks(read<meter::in_force>(unit), "03 03 00 2C 00 01"_hex));
STATIC_CHECK(asks(read<meter::voltage>(unit), "03 04 00 28 00 01"_hex));
STATIC_CHECK(asks(read<meter::load>(unit), "03 04 00 29 00 03"_hex)); // with its scale, and what lies between
STATIC_CHECK(asks(read<meter::relay>(unit), "03 01 00 28 00 01"_hex));
STATIC_CHECK(asks(read<meter::door>(unit), "03 02 00 28 00 01"_hex));

STATIC_CHECK(answered(read<meter::energy>(unit), "03 04 00 00 41 48"_hex) == 12.5_kWh);
STATIC_CHECK(*answered(read<meter::energy>(unit), "03 04 00 00 41 48"_hex) > 5_kWh);
STATIC_CHECK(answered(read<meter::energy>(unit), "03 04 00 00 7F C0"_hex) == errc::value_without_meaning);
STATIC_CHECK(answered(read<meter::energy>(unit), "03 02 41 48"_hex) == errc::wrong_length);
STATIC_CHECK(answered(read<meter::budget>(unit), "03 04 00 01 00 00"_hex) == 65'536_Wh);
STATIC_CHECK(answered(read<meter::in_force>(unit), "03 02 00 02"_hex) == meter::tariff::night);
STATIC_CHECK(answered(read<meter::in_force>(unit), "03 02 00 03"_hex) == errc::value_without_meaning);
STATIC_CHECK(*answered(read<meter::place>(unit), "03 06 48 41 4C 4C 20 00"_hex) == "HALL");
STATIC_CHECK(answered(read<meter::voltage>(unit), "04 02 09 00"_hex) == 230.4_V);
STATIC_CHECK(*answered(read<meter::load>(unit), "04 06 FF 85 00 00 FF FF"_hex) == -12.3_W);
STATIC_CHECK(answered(read<meter::load>(unit), "04 06 80 00 00 00 FF FF"_hex) == errc::value_without_meaning);
STATIC_CHECK(answered(read<meter::relay>(unit), "01 01 01"_hex) == true);
STATIC_CHECK(answered(read<meter::door>(unit), "02 01 00"_hex) == false);
STATIC_CHECK(answered(read<meter::door>(unit), "02 02 01 00"_hex) == errc::wrong_length);

// A wide register is written whole, by function 16.
STATIC_CHECK(asks(write<meter::energy>(unit, 12.5_kWh), "03 10 00 28 00 02 04 00 00 41 48"_hex));
STATIC_CHECK(asks(write<meter::budget>(unit, 70_kWh), "03 10 00 2A 00 02 04 00 01 11 70"_hex));
STATIC_CHECK(asks(write<meter::place>(unit, "HALL"), "03 10 00 2E 00 03 06 48 41 4C 4C 00 00"_hex));
STATIC_CHECK(asks(write<meter::in_force>(unit, meter::tariff::night), "03 06 00 2C 00 02"_hex));
STATIC_CHECK(asks(write<meter::relay>(unit, true), "03 05 00 28 FF 00"_hex));
STATIC_CHECK(asks(write<meter::relay>(unit, false), "03 05 00 28 00 00"_hex));
STATIC_CHECK(asks(write_all<meter::relay, meter::lamp>(unit, false, true), "03 0F 00 28 00 02 01 02"_hex));
STATIC_CHECK(asks(write_all<meter::budget, meter::in_force, meter::setpoint>(unit, 70_kWh, meter::tariff::day, 50_Hz),
                  "03 10 00 2A 00 04 08 00 01 11 70 00 01 01 F4"_hex));
STATIC_CHECK(asks(exchange<contiguous<meter::energy, meter::budget>, meter::budget>(unit, 70_kWh),
                  "03 17 00 28 00 04 00 2A 00 02 04 00 01 11 70"_hex));

/// A count whose scale another register holds, to be written in steps that the program names.
constexpr reg<signed_count16> own_scale{.code = "SF", .address = 3};
constexpr reg<scaled_by<volts, own_scale>> level{.code = "L", .address = 4};
constexpr reg<scaled_by<quantity<power, std::int16_t>, own_scale>> feed{.code = "F", .address = 5, .max = 100};
constexpr reg<scaled_by<quantity<power, std::uint32_t>, own_scale, word_order::low_first>> drawn{.code = "M",
                                                                                                 .address = 6};
struct source {
    static constexpr literal name{"source"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using registers = table<own_scale, level, feed, drawn>;
};
constexpr station<source> supply{unit_id{3}};

template <typename Conversation> constexpr bool is_refused(Conversation conversation, errc why)
{
    return conversation.settled() and not conversation.next() and conversation.outcome() == why;
}

constexpr bool writes_nothing_that_means_not_implemented()
{
    using watts_low_first = unsigned32<quantity<power, std::uint32_t>, word_order::low_first>;
    std::int64_t const one = 1;
    bool ok = asks(write_with_step<decivolts, level>(supply, checked(one * 6553.4_V)), "03 06 00 04 FF FE"_hex);
    ok = ok and is_refused(write_with_step<decivolts, level>(supply, checked(one * 6553.5_V)), errc::value_too_high);
    using own = quantity<power, std::int16_t>;
    ok = ok and asks(write_with_step<own, feed>(supply, checked(-one * 32'767_W)), "03 06 00 05 80 01"_hex);
    ok = ok and is_refused(write_with_step<own, feed>(supply, checked(-one * 32'768_W)), errc::value_too_low);
    ok = ok and is_refused(write_with_step<own, feed>(supply, checked(one * 101_W)), errc::value_too_high);
    ok = ok and asks(write_with_step<watts_low_first, drawn>(supply, checked(one * 4'294'967'294_W)),
                     "03 10 00 06 00 02 04 FF FE FF FF"_hex);
    return ok and is_refused(write_with_step<watts_low_first, drawn>(supply, checked(one * 4'294'967'295_W)),
                             errc::value_too_high);
}
PROOF("what means \"not implemented\" in a count with a scale is never written",
      writes_nothing_that_means_not_implemented)

constexpr bool checks_wide_values()
{
    std::int64_t const most = 5'000'000;
    bool ok = asks(write<meter::budget>(unit, checked(most * 1_Wh)), "03 10 00 2A 00 02 04 00 4C 4B 40"_hex);
    ok = ok and is_refused(write<meter::budget>(unit, checked((most + 1) * 1_Wh)), errc::value_too_high);
    ok = ok and is_refused(write<meter::budget>(unit, checked(-most * 1_Wh)), errc::value_too_low);
    ok = ok and
         is_refused(write_all<meter::budget, meter::in_force>(unit, checked(most * 1_kWh), checked(meter::tariff::day)),
                    errc::value_too_high);
    using both = contiguous<meter::energy>;
    ok = ok and
         asks(exchange<both, meter::budget, meter::in_force>(unit, checked(70 * 1_kWh), checked(meter::tariff::night)),
              "03 17 00 28 00 02 00 2A 00 03 06 00 01 11 70 00 02"_hex);
    ok = ok and is_refused(exchange<both, meter::budget, meter::in_force>(unit, checked(70 * 1_kWh),
                                                                          checked(static_cast<meter::tariff>(3))),
                           errc::value_without_meaning);
    return ok and is_refused(exchange<both, meter::setpoint>(unit, checked(most * 1_Hz)), errc::value_too_high);
}
PROOF("values known at run time are checked in wide registers and in an exchange", checks_wide_values)

// Plans: by kind, wide ones never cut. Six registers fit one request of this device.
using all_of_it = read_plan<meter::device, meter::place, meter::door, meter::load, meter::energy, meter::relay,
                            meter::budget, meter::lamp, meter::voltage>;
static_assert(all_of_it::request_count == 5);
STATIC_CHECK(all_of_it::requests()[0] == address_block{40, 4} and all_of_it::requests()[1] == address_block{46, 3});
STATIC_CHECK(all_of_it::requests()[2] == address_block{40, 4} and
             all_of_it::space_of(2) == register_space::input); // voltage, load, and the scale
STATIC_CHECK(all_of_it::requests()[3] == address_block{40, 2} and all_of_it::space_of(3) == register_space::coil);
STATIC_CHECK(all_of_it::requests()[4] == address_block{40, 1} and
             all_of_it::space_of(4) == register_space::discrete_input);

// Of 42 to 48, six at most in a request: 42 to 47 would be the first, and cut the text at 46 to 48.
using near_limit = read_plan<meter::device, meter::budget, meter::in_force, meter::setpoint, meter::place>;
static_assert(near_limit::request_count == 2);
STATIC_CHECK(near_limit::requests()[0].count + near_limit::requests()[1].count == 7);
STATIC_CHECK(not near_limit::requests()[0].contains(47) and near_limit::requests()[1].contains(46) and
             near_limit::requests()[1].contains(48));

// What is named together is read together, though another cut would do.
using pair = read_plan<meter::device, together<meter::setpoint, meter::place>, meter::energy, meter::budget>;
static_assert(pair::request_count == 2);
STATIC_CHECK(pair::requests()[0] == address_block{40, 4} and pair::requests()[1] == address_block{45, 4});
using other_pair = read_plan<meter::device, meter::energy, together<meter::budget, meter::setpoint>, meter::place>;
STATIC_CHECK(other_pair::requests()[0] == address_block{40, 6} and other_pair::requests()[1] == address_block{46, 3});

/// Answers a poller with words that tell their address and kind.
template <typename Plan> constexpr poller<Plan> polled()
{
    poller<Plan> panel{unit};
    panel.again();
    while (not panel.settled()) {
        auto const frame = panel.next()->frame();
        auto const function = to_u8(frame[1]);
        std::size_t const count = u16_at(frame, 4);
        std::array<std::byte, 16> pdu{frame[1], std::byte{static_cast<std::uint8_t>(function < 3 ? 1 : 2 * count)}};
        for (std::size_t i = 0; function >= 3 and i < count; ++i) {
            pdu[3 + 2 * i] =
                std::byte{static_cast<std::uint8_t>((u16_at(frame, 2) + i) + (function == 4 ? 0x80U : 0U))};
        }
        pdu[2] = function < 3 ? std::byte{static_cast<std::uint8_t>(function)} : pdu[2];
        panel.accept(result<response>{response{byte_view{pdu}.first(function < 3 ? 3 : 2 + 2 * count)}});
    }
    return panel;
}

constexpr bool stores_by_kind()
{
    using other = read_plan<meter::device, meter::door, meter::budget, meter::relay, meter::voltage, meter::lamp,
                            meter::energy, meter::in_force, meter::setpoint>;
    auto const panel = polled<other>();
    auto const& now = panel.latest();
    bool ok = panel.outcome().has_value();
    // Coils answer 01, discrete inputs 02: bits 1 0 and 0.
    ok = ok and now.get<meter::relay>() and not now.get<meter::lamp>() and not now.get<meter::door>();
    ok = ok and now.get<meter::voltage>() == decivolts{0xA8} and now.get<meter::setpoint>() == decihertz{45};
    ok = ok and now.get<meter::budget>().count() == 0x002A'002BU;
    ok = ok and now.get<meter::in_force>() == errc::value_without_meaning; // 44
    return ok and now.get<meter::energy>().has_value();
}
PROOF("a plan over four kinds stores what each function answered", stores_by_kind)

constexpr bool refuses_another_size()
{
    poller<all_of_it> panel{unit};
    panel.again();
    panel.accept(result<response>{response{"03 04 00 00 00 00"_hex}});
    return panel.outcome() == errc::wrong_length;
}
PROOF("a response of another size ends the round", refuses_another_size)

// Before the first round every word is 0.
constexpr all_of_it::snapshot nothing{};
STATIC_CHECK(nothing.get<meter::energy>() == 0_kWh and nothing.get<meter::budget>() == 0_Wh);
STATIC_CHECK(nothing.get<meter::load>() == scaled<quantity<power, std::int16_t>>{0, 0});
STATIC_CHECK(nothing.checked<meter::budget>(70_kWh).has_value() and
             nothing.checked<meter::budget>(70'000_kWh) == errc::value_too_high);

// Write plans with wide registers, and with values known at run time.
using set_up = write_plan<meter::device, meter::place, meter::budget, meter::setpoint>;
STATIC_CHECK(set_up::request_count == 2 and set_up::requests()[0] == address_block{42, 2} and
             set_up::requests()[1] == address_block{45, 4});
constexpr bool writes_wide_registers()
{
    plan_writer<set_up> tell{unit, set_up{"HALL", 70_kWh, 50_Hz}};
    bool ok = asks(tell, "03 10 00 2A 00 02 04 00 01 11 70"_hex);
    tell.accept(result<response>{response{"10 00 2A 00 02"_hex}});
    ok = ok and asks(tell, "03 10 00 2D 00 04 08 01 F4 48 41 4C 4C 00 00"_hex);
    tell.accept(result<response>{response{"10 00 2D 00 04"_hex}});
    int const hertz = 50;
    plan_writer<set_up> same{unit, set_up{checked(literal{"HALL"}), checked(70 * 1_kWh), checked(hertz * 1_Hz)}};
    ok = ok and tell.outcome() and asks(same, "03 10 00 2A 00 02 04 00 01 11 70"_hex);
    plan_writer<set_up> const bad{unit, set_up{checked(literal{"HALL"}), checked(70 * 1_kWh), checked(hertz * 2_Hz)}};
    return ok and is_refused(bad, errc::value_too_high) and bad.written() == 0;
}
PROOF("a plan writes wide registers whole, and nothing where a value does not fit", writes_wide_registers)

// Limits of six words in a write keep the text in one request.
struct small : meter::device {
    static constexpr device_limits limits{.write = 3};
};
using in_small = write_plan<small, meter::budget, meter::in_force, meter::setpoint, meter::place>;
STATIC_CHECK(in_small::request_count == 3 and in_small::requests()[2] == address_block{46, 3});

} // namespace
