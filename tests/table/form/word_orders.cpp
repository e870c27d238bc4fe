// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Numbers of 32 and 64 bits in the four orders. The bytes are written by hand from the definition, ABCD and so on, and
// the floating point ones are those of Python's struct: struct.pack('>f', 12.5).hex() is 41480000.
#include <rtuwire/table/form/whole.hpp>

#include <array>
#include <bit>
#include <cstring>

#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/table/form/floating.hpp>
#include <rtuwire/table/form/form_setting.hpp>
#include <rtuwire/wire/views.hpp>

using namespace rtuwire;

namespace {

/// Whether a value has these bytes on the wire, and these bytes this value.
template <typename Form, std::size_t Size>
constexpr bool stands_as(typename Form::value_type value, std::array<std::byte, Size> const& bytes)
{
    register_view const words{bytes};
    auto const made = Form::to_words(value);
    typename Form::words read{};
    bool ok = words.size() == made.size() and made.size() == Form::word_count;
    for (std::size_t i = 0; ok and i < made.size(); ++i) {
        ok = made[i] == words[i];
        read[i] = words[i];
    }
    return ok and Form::from_words(read) == value;
}

using order = word_order;
using counts32 = quantity<dimensionless, std::uint32_t>;
using signed_counts32 = quantity<dimensionless, std::int32_t>;
using counts64 = quantity<dimensionless, std::int64_t>;

// 0x0A0B0C0D: A is 0A, B is 0B, C is 0C, D is 0D.
constexpr counts32 abcd{std::uint32_t{0x0A0B'0C0D}};
STATIC_CHECK(stands_as<unsigned32<>>(abcd, "0A 0B 0C 0D"_hex));
STATIC_CHECK(stands_as<unsigned32<count16, order::low_first>>(abcd, "0C 0D 0A 0B"_hex));
STATIC_CHECK(stands_as<unsigned32<count16, order::high_first_bytes_swapped>>(abcd, "0B 0A 0D 0C"_hex));
STATIC_CHECK(stands_as<unsigned32<count16, order::low_first_bytes_swapped>>(abcd, "0D 0C 0B 0A"_hex));

// All bits, and the sign.
STATIC_CHECK(stands_as<unsigned32<>>(counts32{std::uint32_t{4'294'967'295U}}, "FF FF FF FF"_hex));
STATIC_CHECK(stands_as<signed32<>>(signed_counts32{-2}, "FF FF FF FE"_hex));
STATIC_CHECK(stands_as<signed32<count16, order::low_first>>(signed_counts32{-2}, "FF FE FF FF"_hex));
STATIC_CHECK(stands_as<signed32<count16, order::low_first_bytes_swapped>>(signed_counts32{-2}, "FE FF FF FF"_hex));

// 0x0102030405060708.
constexpr counts64 eight{std::int64_t{0x0102'0304'0506'0708}};
STATIC_CHECK(stands_as<unsigned64<>>(eight, "01 02 03 04 05 06 07 08"_hex));
STATIC_CHECK(stands_as<signed64<count16, order::low_first>>(eight, "07 08 05 06 03 04 01 02"_hex));
STATIC_CHECK(stands_as<signed64<count16, order::high_first_bytes_swapped>>(eight, "02 01 04 03 06 05 08 07"_hex));
STATIC_CHECK(stands_as<unsigned64<count16, order::low_first_bytes_swapped>>(eight, "08 07 06 05 04 03 02 01"_hex));
STATIC_CHECK(stands_as<signed64<>>(counts64{std::int64_t{-3}}, "FF FF FF FF FF FF FF FD"_hex));

// What a count of 64 bits does not hold is refused, whichever end.
constexpr auto read64 = [](auto const& bytes, auto form) {
    register_view const words{bytes};
    return decltype(form)::from_words({words[0], words[1], words[2], words[3]}).error();
};
STATIC_CHECK(read64("80 00 00 00 00 00 00 00"_hex, unsigned64<>{}) == errc::value_too_high);
STATIC_CHECK(read64("FF FF FF FF FF FF FF FF"_hex, unsigned64<>{}) == errc::value_too_high);
STATIC_CHECK(read64("7F FF FF FF FF FF FF FF"_hex, unsigned64<>{}) == errc::value_too_high);
STATIC_CHECK(read64("7F FF FF FF FF FF FF FE"_hex, unsigned64<>{}) == errc::none);
STATIC_CHECK(read64("80 00 00 00 00 00 00 00"_hex, signed64<>{}) == errc::value_too_low);
STATIC_CHECK(read64("80 00 00 00 00 00 00 01"_hex, signed64<>{}) == errc::none);

// struct.pack('>f', 12.5), ('>f', -0.1), ('>d', 12.5), ('>d', -1e100)
using energy = real<kilowatt_hours>;
using fine_energy = real<kilowatt_hours, double>;
STATIC_CHECK(stands_as<float32<kilowatt_hours>>(energy{12.5F}, "41 48 00 00"_hex));
STATIC_CHECK(stands_as<float32<kilowatt_hours>>(energy{-0.1F}, "BD CC CC CD"_hex));
STATIC_CHECK(stands_as<float32<kilowatt_hours, order::low_first>>(energy{-0.1F}, "CC CD BD CC"_hex));
STATIC_CHECK(stands_as<float32<kilowatt_hours, order::high_first_bytes_swapped>>(energy{-0.1F}, "CC BD CD CC"_hex));
STATIC_CHECK(stands_as<float32<kilowatt_hours, order::low_first_bytes_swapped>>(energy{-0.1F}, "CD CC CC BD"_hex));
#if __SIZEOF_DOUBLE__ == 8 // an AVR has none of 64 bits
STATIC_CHECK(stands_as<float64<kilowatt_hours>>(fine_energy{12.5}, "40 29 00 00 00 00 00 00"_hex));
STATIC_CHECK(stands_as<float64<kilowatt_hours>>(fine_energy{-1e100}, "D4 B2 49 AD 25 94 C3 7D"_hex));
STATIC_CHECK(stands_as<float64<kilowatt_hours, order::low_first>>(fine_energy{-1e100}, "C3 7D 25 94 49 AD D4 B2"_hex));
STATIC_CHECK(stands_as<float64<kilowatt_hours, order::high_first_bytes_swapped>>(fine_energy{-1e100},
                                                                                 "B2 D4 AD 49 94 25 7D C3"_hex));
STATIC_CHECK(stands_as<float64<kilowatt_hours, order::low_first_bytes_swapped>>(fine_energy{-1e100},
                                                                                "7D C3 94 25 AD 49 B2 D4"_hex));
#endif

// Infinite, its opposite, quiet and signalling "not a number", and the numbers beside them.
constexpr errc read32(std::uint16_t high, std::uint16_t low) { return float32<>::from_words({high, low}).error(); }
STATIC_CHECK(read32(0x7F80, 0x0000) == errc::value_without_meaning);
STATIC_CHECK(read32(0xFF80, 0x0000) == errc::value_without_meaning);
STATIC_CHECK(read32(0x7FC0, 0x0000) == errc::value_without_meaning);
STATIC_CHECK(read32(0x7F80, 0x0001) == errc::value_without_meaning);
STATIC_CHECK(read32(0xFFFF, 0xFFFF) == errc::value_without_meaning);
STATIC_CHECK(read32(0x7F7F, 0xFFFF) == errc::none);
STATIC_CHECK(read32(0x0000, 0x0001) == errc::none);
#if __SIZEOF_DOUBLE__ == 8
STATIC_CHECK(read64("7F F0 00 00 00 00 00 00"_hex, float64<>{}) == errc::value_without_meaning);
STATIC_CHECK(read64("FF F8 00 00 00 00 00 00"_hex, float64<>{}) == errc::value_without_meaning);
STATIC_CHECK(read64("7F EF FF FF FF FF FF FF"_hex, float64<>{}) == errc::none);
#endif

// Settings: whole values in any unit, with limits beyond 16 and 32 bits.
constexpr reg<unsigned32<watt_hours, order::low_first>> budget{.code = "BUD", .address = 10, .max = 3'000'000'000};
constexpr setting<budget> most = 3'000'000_Wh;
STATIC_CHECK(most.words() == std::array<std::uint16_t, 2>{0xC6C0, 0x002D});
STATIC_CHECK(setting<budget>::checked(3'000'001_kWh).error() == errc::value_too_high);
STATIC_CHECK(setting<budget>::checked(3'000'000_kWh).has_value());
STATIC_CHECK(setting<budget>::checked(-1_kWh).error() == errc::value_too_low);
STATIC_CHECK(setting<budget>::checked(0.0001_kWh).error() == errc::value_between_steps);

constexpr reg<signed64<>> total{.code = "TOT", .address = 20, .min = -5'000'000'000, .max = 5'000'000'000};
STATIC_CHECK(setting<total>::checked(5'000'000'000_raw)->words() == std::array<std::uint16_t, 4>{0, 1, 0x2A05, 0xF200});
STATIC_CHECK(setting<total>::checked(5'000'000'001_raw).error() == errc::value_too_high);
STATIC_CHECK(setting<total>::checked(-5'000'000'001_raw).error() == errc::value_too_low);
constexpr reg<signed64<>> open{.code = "OPN", .address = 20};
constexpr counts64 beyond{std::int64_t{9'223'372'036'854'775'807}};
STATIC_CHECK(setting<open>::checked(beyond).error() == errc::value_too_high); // it stands for "out of range"
constexpr reg<unsigned64<>> counter{.code = "CNT", .address = 20};
STATIC_CHECK(setting<counter>::checked(-1_raw).error() == errc::value_too_low);

constexpr reg<float32<kilowatt_hours>> limit{
    .code = "LIM", .address = 30, .min = -10, .max = 1000, .gap = {.first = 5, .last = 6}};
constexpr setting<limit> half = 0.5_kWh;
STATIC_CHECK(half.words() == std::array<std::uint16_t, 2>{0x3F00, 0});
STATIC_CHECK(setting<limit>::checked(1000.1_kWh).error() == errc::value_too_high);
STATIC_CHECK(setting<limit>::checked(energy{-10.5F}).error() == errc::value_too_low);
STATIC_CHECK(setting<limit>::checked(energy{5.5F}).error() == errc::value_never_written);
STATIC_CHECK(setting<limit>::checked(fine_energy{4.5}).has_value());
#if __SIZEOF_DOUBLE__ == 8
STATIC_CHECK(setting<limit>::checked(fine_energy{1e300}).error() == errc::value_too_high);
STATIC_CHECK(setting<limit>::checked(fine_energy{-1e300}).error() == errc::value_too_low);
#endif
constexpr reg<float32<>> any{.code = "ANY", .address = 30};
STATIC_CHECK(setting<any>::checked(real<count16>{std::bit_cast<float>(0x7FC0'0000U)}).error() ==
             errc::value_without_meaning);

} // namespace
