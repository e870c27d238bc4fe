// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The registers of a whole device as words: found by address for the line, by mnemonic for the model. Checks the values
// that each may hold, including limits that depend on other registers; knows what its scanner's words stand for, which
// registers are orders, and where those are that the simulated drive reads or shows.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/device/cycle_registers.hpp>
#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/register_rules.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/table.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// The words of all registers of a device, initially as commissioned.
template <device_type Device> class image {
    using rules = rules_of<typename Device::registers>;
    static constexpr key_index<literal, rules::count> by_code{each_of(rules::list, &register_rule::code)};
    static constexpr key_index<std::uint16_t, rules::count> by_address{each_of(rules::list, &register_rule::address)};

public:
    /// The place of no register. A word stored there is lost, and it reads 0.
    static constexpr std::size_t nowhere = rules::count;

    using words = std::array<std::uint16_t, rules::count>;

    [[nodiscard]] static constexpr std::size_t at(literal code) noexcept { return by_code.find(code); }
    [[nodiscard]] static constexpr std::size_t at_address(std::size_t address) noexcept
    {
        return address > 0xFFFF ? nowhere : by_address.find(static_cast<std::uint16_t>(address));
    }
    [[nodiscard]] static constexpr register_rule const& rule(std::size_t place) noexcept { return rules::list[place]; }

    [[nodiscard]] constexpr std::uint16_t get(std::size_t place) const noexcept
    {
        return place == nowhere ? std::uint16_t{0} : words_[place];
    }
    [[nodiscard]] constexpr std::int32_t get_signed(std::size_t place) const noexcept
    {
        return static_cast<std::int16_t>(get(place));
    }

    [[nodiscard]] static constexpr bool is_signed(std::size_t place) noexcept
    {
        return place != nowhere and rule(place).is_signed;
    }

    /// How many steps of a register make one whole unit.
    [[nodiscard]] static constexpr std::int32_t scale(std::size_t place) noexcept
    {
        return place == nowhere ? 1 : rule(place).steps_per_unit;
    }

    /// Stores a word as received over the line.
    constexpr void put_word(std::size_t place, std::uint16_t word) noexcept
    {
        put(place, is_signed(place) ? static_cast<std::int16_t>(word) : std::int32_t{word});
    }

    /// Stores a value, limited to the range of a word.
    constexpr void put(std::size_t place, std::int64_t value) noexcept
    {
        if (place == nowhere) {
            return;
        }
        std::int64_t const least = is_signed(place) ? -32'768 : 0;
        std::int64_t const most = is_signed(place) ? 0x7FFF : 0xFFFF;
        std::int64_t const cut = value < least ? least : value > most ? most : value;
        words_[place] = static_cast<std::uint16_t>(cut);
    }

    /// Whether a register accepts a word; `illegal_data_value` outside its limits, or without a meaning.
    [[nodiscard]] constexpr errc check(std::size_t place, std::uint16_t word) const noexcept
    {
        register_rule const& known = rule(place);
        std::int32_t const raw = known.is_signed ? std::int32_t{static_cast<std::int16_t>(word)} : std::int32_t{word};
        bool const is_inside =
            (known.min.is_open() or raw >= limit(known.min)) and (known.max.is_open() or raw <= limit(known.max));
        bool const is_right = is_inside and not known.gap.contains(raw) and has_meaning(known.listed, word) and
                              has_meaning(known.choices, word);
        return is_right ? errc::none : errc::illegal_data_value;
    }

    [[nodiscard]] constexpr words const& all() const noexcept { return words_; }

    /// Sets every setting that a client may write to its value in `saved`.
    constexpr void restore(words const& saved) noexcept
    {
        for (std::size_t i = 0; i < rules::count; ++i) {
            if (rule(i).mode != access::read_only and not is_order(i)) {
                words_[i] = saved[i];
            }
        }
    }

    /// The words as delivered, and those of a drive that was commissioned.
    [[nodiscard]] static constexpr words factory() noexcept { return all_by(&register_rule::factory); }
    [[nodiscard]] static constexpr words commissioned() noexcept { return all_by(&register_rule::commissioned); }

private:
    /// No setting: by its mnemonic, or an output word of the scanner.
    static constexpr bool is_order(std::size_t place) noexcept
    {
        bool is_output = false;
        if constexpr (has_all_parts<Device>) {
            is_output = Device::scanner.is_output(rule(place).address);
        }
        return is_output or rule(place).is_order;
    }

    static constexpr words all_by(std::uint16_t register_rule::*member) noexcept
    {
        words all = each_of(rules::list, member);
        map_scanner(all);
        return all;
    }

    /// A scanner stands, as delivered, for the registers of the cycle.
    static constexpr void map_scanner(words& all) noexcept
    {
        if constexpr (has_all_parts<Device>) {
            if (Device::cycle.by_scanner) {
                map(all, Device::scanner.input_addresses, Device::cycle.reads);
                map(all, Device::scanner.output_addresses, Device::cycle.writes);
            }
        }
    }
    static constexpr void map(words& all, std::uint16_t first, altivar::cycle_addresses const& list) noexcept
    {
        for (std::size_t i = 0; i < list.size(); ++i) {
            all[at_address(first + i)] = list[i];
        }
    }

    constexpr std::int32_t limit(bound const& of) const noexcept
    {
        std::int32_t const factor = of.factor().size() == 0 ? 1 : std::int32_t{get(at(of.factor()))};
        return of.with(get(at(of.code())), factor);
    }

    words words_{commissioned()};
};

/// Places in a device's image; `nowhere` for what the device does not have.
template <device_type Device> struct register_index {
    using registers = image<Device>;
    static constexpr altivar::drive_layout const& layout = Device::layout;
    static constexpr altivar::safeguard_layout const& guards = Device::layout.safeguards;

    /// The place of an address; 0 is none.
    [[nodiscard]] static constexpr std::size_t place(std::uint16_t address) noexcept
    {
        return address == 0 ? registers::nowhere : registers::at_address(address);
    }

    std::size_t cmd{place(layout.cmd)};
    std::size_t cmi{place(layout.cmi)};
    std::size_t eta{place(layout.eta)};
    std::size_t eti{place(layout.eti)};
    std::size_t rfr{place(layout.rfr)};
    std::size_t lft{place(layout.lft)};
    std::size_t lfr{place(Device::frequency_reference.address)};
    std::size_t lfrd{place(Device::speed_reference.address)};
    std::size_t tto{place(guards.tto)};
    std::size_t sll{place(guards.sll)};
    std::size_t chcf{place(guards.chcf)};
    std::size_t cd1{place(guards.cd1)};
    std::size_t fr1{place(guards.fr1)};
    std::size_t flo{place(guards.flo)};
    std::size_t atr{place(guards.atr)};
    std::size_t dotd{place(guards.dotd)};
    std::size_t inputs{place(guards.inputs)};

    std::size_t cmdd{registers::at("CMDD")}, etad{registers::at("ETAD")};
    std::size_t frh{registers::at("FRH")}, rfrd{registers::at("RFRD")};
    std::size_t frhd{registers::at("FRHD")}, spd{registers::at("SPD")};
    std::size_t lcr{registers::at("LCR")}, otr{registers::at("OTR")};
    std::size_t opr{registers::at("OPR")}, uln{registers::at("ULN")};
    std::size_t thd{registers::at("THD")}, thr{registers::at("THR")};
    std::size_t hmis{registers::at("HMIS")}, acc{registers::at("ACC")};
    std::size_t dec{registers::at("DEC")}, inr{registers::at("INR")};
    std::size_t hsp{registers::at("HSP")}, lsp{registers::at("LSP")};
    std::size_t frs{registers::at("FRS")}, nsp{registers::at("NSP")};
    std::size_t sds{registers::at("SDS")}, ncr{registers::at("NCR")};
    std::size_t inv{registers::at("INV")}, ith{registers::at("ITH")};
    std::size_t stt{registers::at("STT")}, li3{registers::at("LI3")};
    std::size_t li4{registers::at("LI4")}, add{registers::at("ADD")};
    std::size_t tbr{registers::at("TBR")}, tfo{registers::at("TFO")};
    std::size_t bdr{registers::at("BDR")}, eti2{registers::at("ETI2")};
    std::size_t ftd{registers::at("FTD")}, ctd{registers::at("CTD")};

    [[nodiscard]] static constexpr bool has(std::size_t place) noexcept { return place != registers::nowhere; }
};

/// One half of a device's communication scanner, inputs or outputs: words that stand for other registers, by addresses
/// that the client sets.
template <device_type Device> class scanner_half {
    using registers = image<Device>;
    static constexpr std::size_t slot_count = Device::scanner.words;

public:
    /// Takes the address of its first word and that of the register with the target of this word.
    constexpr scanner_half(std::uint16_t its_words, std::uint16_t targets) noexcept
        : words_{its_words}, targets_{targets}
    {}

    /// Whether a register is one of its words.
    [[nodiscard]] constexpr bool has(std::size_t place) const noexcept { return slot_of(place) < slot_count; }

    /// The place of the register that a word stands for; `nowhere` for address 0 or one that the device
    /// does not have.
    [[nodiscard]] constexpr std::size_t target_of(std::size_t place, registers const& all) const noexcept
    {
        std::size_t const setting = registers::at_address(targets_ + slot_of(place));
        return registers::at_address(all.get(setting));
    }

private:
    constexpr std::size_t slot_of(std::size_t place) const noexcept
    {
        std::size_t slot = 0;
        while (slot < slot_count and registers::at_address(words_ + slot) != place) {
            ++slot;
        }
        return slot;
    }

    std::uint16_t words_;
    std::uint16_t targets_;
};

/// LSP, HSP and TFR as they are, or as a request would leave them; one that a drive does not have limits nothing. Held
/// for a request as a whole, whatever order its words have: each register by itself, against what the others hold before,
/// would let both of two wrong words pass.
template <typename Image> class speed_limits {
    static constexpr std::size_t lsp = Image::at("LSP");
    static constexpr std::size_t hsp = Image::at("HSP");
    static constexpr std::size_t tfr = Image::at("TFR");
    static constexpr std::uint16_t no_limit = 0xFFFF;

public:
    explicit constexpr speed_limits(Image const& held) noexcept
        : lowest_{held.get(lsp)}, high_{held.get(hsp)}, highest_{tfr == Image::nowhere ? no_limit : held.get(tfr)}
    {}

    /// Takes a word of the request; one of another register changes nothing.
    constexpr void put(std::size_t place, std::uint16_t word) noexcept
    {
        lowest_ = place == lsp ? word : lowest_;
        high_ = place == hsp ? word : high_;
        highest_ = place == tfr ? word : highest_;
    }

    /// Whether they fit each other.
    [[nodiscard]] constexpr bool hold() const noexcept { return lowest_ <= high_ and high_ <= highest_; }

private:
    std::uint16_t lowest_;
    std::uint16_t high_;
    std::uint16_t highest_;
};

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

} // namespace detail
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
