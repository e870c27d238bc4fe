// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The catalogs that frames are explained by, of the registers that the page's drives have. With all parameters of the command line
// tool's catalogs the module would be twice as large.
#include "catalog/catalog_of.hpp"

#include <algorithm>
#include <array>
#include <new>
#include <utility>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>

namespace tool {

namespace {

/// The registers of a table, sorted by the compiler: the module has no code for that. What no text about a frame needs of
/// them is the same in all.
template <auto const&... Registers> constexpr auto sorted(rtuwire::table<Registers...>)
{
    std::array<register_entry, sizeof...(Registers)> all{
        entry_of(rtuwire::altivar::row_of(Registers, rtuwire::altivar::roles::ordinary),
                 names_in_type<rtuwire::value_of<Registers>>())...};
    for (register_entry& each : all) {
        each.name = {};
        each.mode = {};
        each.min = each.max = {};
        each.gap_first = each.gap_last = 0;
        each.factory.reset();
        each.source = {};
    }
    std::ranges::sort(all, {}, &register_entry::address);
    return all;
}

template <typename Drive> constexpr auto registers_of_drive = sorted(typename Drive::registers{});

constexpr bool are_alike(register_entry const& left, register_entry const& right)
{
    return left.kind == right.kind and left.unit == right.unit and left.step.numerator == right.step.numerator and
           left.step.denominator == right.step.denominator and left.steps_set_by == right.steps_set_by and
           left.choices.data() == right.choices.data() and left.choices.size() == right.choices.size() and
           left.has_meanings == right.has_meanings and left.bits.data() == right.bits.data();
}

/// A register as the module keeps it; whole ones would be a fifth of its bytes, a fiftieth with gzip.
struct short_entry {
    char const* code;
    std::uint16_t address;
    std::uint8_t size; ///< of the code
    std::uint8_t like; ///< which of the different ones has the rest
};

template <typename... Drives> struct shortened {
    static constexpr std::size_t count = (registers_of_drive<Drives>.size() + ...);

    /// How many are unlike all before them; those, if there is room.
    template <std::size_t Room> static constexpr auto different()
    {
        std::array<register_entry const*, Room> found{};
        std::size_t size = 0;
        auto const look = [&](register_entry const& each) {
            auto const end = found.begin() + size;
            if (std::none_of(found.begin(), end, [&](auto const* other) { return are_alike(*other, each); })) {
                found[size++] = &each;
            }
        };
        (std::ranges::for_each(registers_of_drive<Drives>, look), ...);
        return std::pair{found, size};
    }
    static constexpr std::size_t kinds = different<count>().second;

    static constexpr std::array<register_entry, kinds> all_different = []<std::size_t... At>(std::index_sequence<At...>)
    {
        constexpr auto found = different<kinds>().first;
        return std::array{*found[At]...};
    }
    (std::make_index_sequence<kinds>{});

    static constexpr std::array<short_entry, count> list = [] {
        std::array<short_entry, count> made{};
        std::size_t size = 0;
        auto const add = [&](register_entry const& each) {
            auto const like = std::ranges::find_if(all_different, [&](auto& other) { return are_alike(other, each); });
            made[size++] = {each.code.data(), each.address, static_cast<std::uint8_t>(each.code.size()),
                            static_cast<std::uint8_t>(like - all_different.begin())};
        };
        (std::ranges::for_each(registers_of_drive<Drives>, add), ...);
        return made;
    }();
    static_assert(kinds < 256);
};

template <typename Drive> constinit drive_catalog catalog = catalog_of<Drive>({}, {});

template <typename... Drives> std::span<drive_catalog const* const> catalogs_of()
{
    using shorts = shortened<Drives...>;
    static drive_catalog const* const all[]{&catalog<Drives>...};
    if (all[0]->registers.empty()) {
        auto* const entries = static_cast<register_entry*>(operator new(sizeof(register_entry) * shorts::count));
        auto* end = entries;
        for (short_entry const& each : shorts::list) {
            auto* const made = new (end++) register_entry{shorts::all_different[each.like]};
            made->code = {each.code, each.size};
            made->address = each.address;
        }
        auto const* first = entries;
        ((catalog<Drives>.registers = {first, registers_of_drive<Drives>.size()},
          first += registers_of_drive<Drives>.size()),
         ...);
    }
    return all;
}

} // namespace

std::span<drive_catalog const* const> all_catalogs() noexcept
{
    return catalogs_of<rtuwire::altivar::atv12::device, rtuwire::altivar::atv28::device,
                       rtuwire::altivar::atv310::device, rtuwire::altivar::atv310::device_2026,
                       rtuwire::altivar::atv320::device>();
}

} // namespace tool
