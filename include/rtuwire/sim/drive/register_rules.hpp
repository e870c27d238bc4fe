// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a simulated drive knows of each of its registers: made of the descriptors in its table, or of the rows of all
// parameters. With what a register holds as delivered, where its table does not say, and after commissioning: a small
// motor of 1 500 rpm at 50 Hz, on ramps of three seconds. Assumed numbers, plausible for each drive.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/table/table.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// The raw count of a register as delivered.
struct factory_value {
    literal code;
    std::uint16_t raw;
};

/// Values where the table of a drive gives no default, for the registers of this name in all drives: commands from
/// the terminals, the reference from an analog input.
inline constexpr std::array<factory_value, 46> factory_values{{
    {"SFR", 40},  {"TFR", 600},   {"HSP", 500},    {"LSP", 0},     {"ACC", 30},     {"DEC", 30}, {"AC2", 50},
    {"DE2", 50},  {"FRS", 500},   {"UNS", 400},    {"NCR", 20},    {"NSP", 1500},   {"COS", 80}, {"NPR", 8},
    {"ITH", 20},  {"INV", 23},    {"SDS", 30},     {"INR", 1},     {"TTO", 100},    {"SLL", 1},  {"TBR", 32},
    {"TFO", 3},   {"STT", 0},     {"VDP", 0x0201}, {"NCV", 6},     {"CPU", 0x1005}, {"VCAL", 2}, {"BFR", 0},
    {"BDR", 8},   {"ADD", 1},     {"FR1", 1},      {"CD1", 1},     {"CHCF", 1},     {"CD2", 10}, {"FLG", 20},
    {"UFR", 20},  {"CRH", 200},   {"IDC", 14},     {"RPG", 100},   {"RIG", 100},    {"FBS", 10}, {"CTD", 23},
    {"TTD", 100}, {"SPAL", 1500}, {"SPDL", 1500},  {"SMAL", 1500},
}};

/// What commissioning has set: Modbus commands the drive, and gives the reference.
inline constexpr std::array<factory_value, 4> commissioned_values{{
    {"CD1", 10},
    {"FR1", 164},
    {"CHCF", 1},
    {"SLL", 1},
}};

/// Words that are orders, not settings: they are neither saved nor restored, and lost at power-off.
inline constexpr std::array<literal, 17> order_codes{"CMD", "CMDD", "LFR", "LFRD", "CMI", "PISP", "RPI", "IOLR", "AOR",
                                                     "NC1", "NC2",  "NC3", "NC4",  "NC5", "NC6",  "NC7", "NC8"};

[[nodiscard]] constexpr bool is_order(literal code) noexcept
{
    for (literal const each : order_codes) {
        if (each == code) {
            return true;
        }
    }
    return false;
}

/// The value in a list for a register called `code`; else `other`.
template <std::size_t Count>
[[nodiscard]] constexpr std::uint16_t raw_in(std::array<factory_value, Count> const& list, literal code,
                                             std::uint16_t other) noexcept
{
    for (factory_value const& each : list) {
        if (each.code == code) {
            return each.raw;
        }
    }
    return other;
}

// The parameters of a whole drive that are orders, and what a simulated one does with each. No order is a setting: it is
// neither saved nor restored, and the factory settings leave it alone. What a real drive would do and the simulation
// cannot is refused by exception 04; an order that is accepted and not obeyed would be taken for obeyed.
//
//     RPR               sets counters to zero: those of the simulation stand at zero; reads "no" again
//     FCS               64, the factory settings: sets them, as CMI does, and reads "no" again; the stored
//                       configurations and the variant 71 are refused
//     SCS, TUN, RP      refused, except "no": there are no stored configurations, no motor to measure, no restart
//     VAL, FBCD         refused, except 0: there are no parameter sets and no function blocks
//     AIV1, OL1R, AO1R  a reference and outputs that the link writes: the word is kept until power-off
//
// CFG, the macro, is a plain setting: on a drive it sets others, and no source says which.

/// What an order does; the word 0 of each does nothing.
enum class order_effect : std::uint8_t { keeps_word, clears_counters, recalls, is_refused };

/// An order by its mnemonic.
struct menu_order {
    literal code;
    order_effect effect;
};

/// All of them.
inline constexpr std::array<menu_order, 10> menu_orders{{
    {"RPR", order_effect::clears_counters},
    {"FCS", order_effect::recalls},
    {"SCS", order_effect::is_refused},
    {"TUN", order_effect::is_refused},
    {"RP", order_effect::is_refused},
    {"VAL", order_effect::is_refused},
    {"FBCD", order_effect::is_refused},
    {"AIV1", order_effect::keeps_word},
    {"OL1R", order_effect::keeps_word},
    {"AO1R", order_effect::keeps_word},
}};

/// The word of FCS that asks for the factory settings.
inline constexpr std::uint16_t recall_of_factory_settings = 64;

/// Whether a register of a whole drive is an order. RPI, which only an ATV28 forgets, is a setting of the others.
[[nodiscard]] constexpr bool is_order_in_menu(literal code) noexcept
{
    for (menu_order const& each : menu_orders) {
        if (each.code == code) {
            return true;
        }
    }
    return is_order(code) and not(code == literal{"RPI"});
}

/// Whether a register is one of the three frequencies that limit each other: LSP <= HSP <= TFR.
[[nodiscard]] constexpr bool is_speed_limit(literal code) noexcept
{
    return code == literal{"LSP"} or code == literal{"HSP"} or code == literal{"TFR"};
}

/// What an image needs to know of one register.
struct register_rule {
    literal code;
    std::uint16_t address;
    access mode;
    bool is_signed;
    bound min;
    bound max;
    std::uint16_t factory;                 ///< as delivered
    std::uint16_t commissioned;            ///< as set at commissioning
    bool is_order;                         ///< no setting
    std::int32_t steps_per_unit;           ///< 10 where it counts tenths; 1 where it is no quantity
    std::span<std::uint16_t const> listed; ///< the words that mean something, of an enumeration
    count_range gap;                       ///< raw counts that it does not take
    std::span<choice const> choices{};     ///< the same as `listed`, of a row
};

/// How many steps of a register make one whole unit.
template <auto const& R> [[nodiscard]] constexpr std::int32_t steps_per_unit() noexcept
{
    if constexpr (register_quantity<value_of<R>>) {
        using scale = typename value_of<R>::scale;
        return static_cast<std::int32_t>(scale::den / scale::num);
    } else {
        return 1;
    }
}

/// The value as delivered: from the table, or else from `factory_values`.
template <auto const& R> [[nodiscard]] constexpr std::uint16_t delivered() noexcept
{
    return R.factory ? static_cast<std::uint16_t>(*R.factory) : raw_in(factory_values, R.code, 0);
}

/// The rules of a table's registers, in its order.
template <typename Table> struct rules_of;
template <auto const&... Registers> struct rules_of<table<Registers...>> {
    static constexpr std::size_t count = sizeof...(Registers);
    static constexpr std::array<register_rule, count> list{register_rule{
        Registers.code, Registers.address, Registers.mode, lowest<Registers>() < 0, Registers.min, Registers.max,
        delivered<Registers>(), raw_in(commissioned_values, Registers.code, delivered<Registers>()),
        is_order(Registers.code), steps_per_unit<Registers>(), listed_words<value_of<Registers>>(), Registers.gap}...};
};

// A drive with all its parameters: its rules are made of their rows, in one loop over plain data. A template for each of a
// thousand registers would keep the compiler busy for seconds. Nothing but what a row can be asked for is known here, not
// its class, so that the simulation does not include the lists of all parameters.

/// Registers that can be walked as rows: those in the groups of all parameters.
template <typename Table>
concept table_of_rows = requires
{
    Table::for_each_row([](auto const&) {});
};

/// Whether a device has all its parameters.
template <typename Device> inline constexpr bool is_whole = table_of_rows<typename Device::registers>;

/// The count nearest to 0 that a row takes, as far as its limits are numbers; of an enumeration the lowest one.
template <typename Row> [[nodiscard]] constexpr std::uint16_t nearest_to_zero(Row const& row) noexcept
{
    if (not row.listed().empty()) {
        std::uint16_t lowest = 0xFFFF;
        for (choice const& each : row.listed()) {
            lowest = each.word < lowest ? each.word : lowest;
        }
        return lowest;
    }
    std::int64_t const least = row.min.is_number() and row.min.raw() > 0 ? row.min.raw() : 0;
    std::int64_t const most = row.max.is_number() and row.max.raw() < 0 ? row.max.raw() : least;
    return static_cast<std::uint16_t>(most);
}

/// The value as delivered: from the row; or that of `factory_values`, where the row takes it; or the nearest to 0.
template <typename Row> [[nodiscard]] constexpr std::uint16_t delivered_by(Row const& row) noexcept
{
    if (row.factory) {
        return static_cast<std::uint16_t>(*row.factory);
    }
    std::uint16_t const nearest = nearest_to_zero(row);
    std::uint16_t const usual = raw_in(factory_values, row.code, nearest);
    return row.takes(row.count_of(usual)) ? usual : nearest;
}

/// How many steps of a row make one whole unit.
template <typename Row> [[nodiscard]] constexpr std::int32_t steps_per_unit_of(Row const& row) noexcept
{
    return row.type->step_denominator / row.type->step_numerator;
}

/// A row as a rule. The limits that TFR, HSP and LSP are to each other are left open: `speed_limits` holds these three
/// for a whole request.
template <typename Row> [[nodiscard]] constexpr register_rule rule_of_row(Row const& row) noexcept
{
    bool const has_signed_type = row.count_of(0xFFFF) < 0;
    bool const is_never_negative = row.min.is_number() and row.min.raw() >= 0;
    bool const is_limit = is_speed_limit(row.code);
    std::uint16_t const factory = delivered_by(row);
    return {row.code,
            row.address,
            row.mode(),
            has_signed_type and not is_never_negative,
            is_limit and not row.min.is_number() ? open_bound : row.min,
            is_limit and not row.max.is_number() ? open_bound : row.max,
            factory,
            raw_in(commissioned_values, row.code, factory),
            is_order_in_menu(row.code),
            steps_per_unit_of(row),
            {},
            no_gap,
            row.listed()};
}

/// The rules of all parameters, group by group.
template <table_of_rows Table> struct rules_of<Table> {
    static constexpr std::size_t count = Table::size;
    static constexpr auto list = [] {
        std::array<register_rule, count> rules{};
        std::size_t next = 0;
        Table::for_each_row([&](auto const& row) { rules[next++] = rule_of_row(row); });
        return rules;
    }();
};

/// One member of all rules, as the list of keys that an index takes.
template <typename Value, std::size_t Count>
[[nodiscard]] constexpr std::array<Value, Count> each_of(std::array<register_rule, Count> const& rules,
                                                         Value register_rule::*member) noexcept
{
    std::array<Value, Count> all{};
    for (std::size_t i = 0; i < Count; ++i) {
        all[i] = rules[i].*member;
    }
    return all;
}

} // namespace detail
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
