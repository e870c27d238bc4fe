// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Holds the descriptors of a full map against its rows, from the side of a program that writes typed values. Templates
// only of the types of values: a thousand registers would keep the compiler busy for a minute.
#pragma once

#include "support/proof.hpp"

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rtuwire/altivar/parameters/parameter_map.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/setting.hpp>

namespace rtuwire::test {

using namespace detail;

/// A descriptor without its type, and whether a typed write takes a word of it.
struct described {
    literal code;
    std::uint16_t address;
    access mode;
    provenance source;
    void const* itself;
    bool (*takes)(void const*, std::uint16_t);
};

/// By its type and limits, as `setting` has them.
template <typename T> [[nodiscard]] bool is_taken(void const* itself, std::uint16_t word)
{
    auto const& of = *static_cast<reg<T> const*>(itself);
    std::int32_t const count = raw_count<T>(word);
    return count >= lowest_count<T>(of.min) and count <= highest_count<T>(of.max) and
           has_meaning(listed_words<T>(), word) and not of.gap.contains(count);
}

template <typename T> [[nodiscard]] described described_by(reg<T> const& of)
{
    return {of.code, of.address, of.mode, of.source, &of, &is_taken<T>};
}

template <auto const&... Registers>
void append(std::vector<described>& all, altivar::parameter_list<Registers...> const*)
{
    all.insert(all.end(), {described_by(Registers)...});
}

/// All descriptors of a device with a full map.
template <typename... Groups> [[nodiscard]] std::vector<described> all_of(altivar::grouped_table<Groups...> const*)
{
    std::vector<described> all;
    (append(all, static_cast<Groups const*>(nullptr)), ...);
    return all;
}

/// The words at which a limit, or an enumeration, could be misread.
inline std::set<std::uint16_t> edges_of(altivar::parameter const& row)
{
    std::set<std::uint16_t> words{0, 1, 0x7FFF, 0x8000, 0xFFFF};
    for (bound const& limit : {row.min, row.max}) {
        for (int step = -1; limit.is_number() and step <= 1; ++step) {
            words.insert(static_cast<std::uint16_t>(limit.raw() + step));
        }
    }
    for (named_value const& each : row.type->mnemonics) {
        words.insert(each.value);
        words.insert(static_cast<std::uint16_t>(each.value + 1));
    }
    return words;
}

/// One descriptor against its row.
inline void check_row(described const& of, altivar::parameter const& row)
{
    CHECK(row.address == of.address);
    CHECK(row.mode == of.mode);
    CHECK(row.source == of.source);
    CHECK(row.is_writable() == (of.mode != access::read_only));
    if (row.factory) {
        CHECK(of.takes(of.itself, static_cast<std::uint16_t>(*row.factory)));
    }
    for (std::uint16_t const word : edges_of(row)) {
        CAPTURE(word);
        CHECK(row.takes(row.count_of(word)) == of.takes(of.itself, word));
    }
}

/// Each register of a device is one row, and the other way round; no address and no mnemonic stands twice in all groups.
template <typename Device>
void check_agreement(altivar::parameter_map const& parameters, altivar::parameter_map const& unverified)
{
    std::set<std::uint16_t> addresses;
    std::set<std::string> codes;
    for (described const& each : all_of(static_cast<typename Device::registers const*>(nullptr))) {
        std::string const code{std::string_view{each.code}};
        CAPTURE(code);
        CHECK(addresses.insert(each.address).second);
        CHECK(codes.insert(code).second);
        altivar::parameter const* const main_row = parameters.by_code(each.code);
        altivar::parameter const* const other_row = unverified.by_code(each.code);
        REQUIRE((main_row == nullptr) != (other_row == nullptr));
        check_row(each, main_row != nullptr ? *main_row : *other_row);
        if (other_row != nullptr) {
            CHECK(each.mode == access::read_only);
            CHECK(each.source == provenance::doubtful);
        }
    }
    CHECK(codes.size() == Device::registers::size);
    CHECK(codes.size() == parameters.size() + unverified.size());
}

/// Whether a device with a full map has all registers of the device for driving, the same objects.
template <typename Full, typename Other> [[nodiscard]] bool has_all_of()
{
    std::set<void const*> objects;
    for (described const& each : all_of(static_cast<typename Full::registers const*>(nullptr))) {
        objects.insert(each.itself);
    }
    bool all = true;
    Other::registers::for_each([&]<auto const & R>() { all = all and objects.count(&R) == 1; });
    return all;
}

} // namespace rtuwire::test
