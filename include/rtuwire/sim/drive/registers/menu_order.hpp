// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
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
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/registers/factory.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

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

/// The orders in a drive's image, by their places. `Image` is that of a whole drive.
template <typename Image> class menu_orders_of {
public:
    /// Whether the simulation cannot do what a word in a register asks for.
    [[nodiscard]] static constexpr bool refuses(std::size_t place, std::uint16_t word) noexcept
    {
        order_effect const effect = effect_at(place);
        return word != 0 and (effect == order_effect::is_refused or
                              (effect == order_effect::recalls and word != recall_of_factory_settings));
    }

    /// Whether a register reads 0 again once a word in it was obeyed.
    [[nodiscard]] static constexpr bool reads_zero_again(std::size_t place) noexcept
    {
        order_effect const effect = effect_at(place);
        return effect == order_effect::clears_counters or effect == order_effect::recalls;
    }

    /// Whether a word in a register asks for the factory settings.
    [[nodiscard]] static constexpr bool recalls_factory_settings(std::size_t place, std::uint16_t word) noexcept
    {
        return word == recall_of_factory_settings and effect_at(place) == order_effect::recalls;
    }

private:
    static constexpr auto places = [] {
        std::array<std::size_t, menu_orders.size()> found{};
        for (std::size_t i = 0; i < found.size(); ++i) {
            found[i] = Image::at(menu_orders[i].code);
        }
        return found;
    }();

    /// What is no order keeps its word.
    static constexpr order_effect effect_at(std::size_t place) noexcept
    {
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (places[i] == place) {
                return menu_orders[i].effect;
            }
        }
        return order_effect::keeps_word;
    }
};

} // namespace rtuwire::sim
