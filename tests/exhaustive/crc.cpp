// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The CRC sees every error of up to three bits and every burst of up to 16, in frames of 4 to 256 bytes.
// The CRC is affine, so what an error does to it is the sum of what its bits do alone.
#include <array>
#include <bitset>

#include <rtuwire/core/crc16.hpp>
#include <rtuwire/wire/function.hpp>

#include "share.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

/// What each bit of a frame, alone, does to its CRC; in the order of transmission.
std::vector<std::uint16_t> columns_of(std::size_t size)
{
    std::vector<std::byte> error(size);
    std::uint16_t const none = crc16(error);
    std::vector<std::uint16_t> columns;
    for (std::size_t bit = 0; bit < size * 8; ++bit) {
        error[bit / 8] = static_cast<std::byte>(1U << (bit % 8));
        columns.push_back(static_cast<std::uint16_t>(crc16(error) ^ none));
        error[bit / 8] = {};
    }
    return columns;
}

/// No bit alone, no two and no three cancel out.
bool sees_three_bits(std::vector<std::uint16_t> const& columns)
{
    std::bitset<65'536> known;
    for (std::uint16_t const each : columns) {
        if (each == 0 or known[each]) {
            return false;
        }
        known[each] = true;
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
        for (std::size_t j = i + 1; j < columns.size(); ++j) {
            if (known[static_cast<std::uint16_t>(columns[i] ^ columns[j])]) {
                return false;
            }
        }
    }
    return true;
}

/// Any 16 neighbours are linearly independent: no burst over them cancels out.
bool sees_bursts(std::vector<std::uint16_t> const& columns)
{
    constexpr std::size_t burst = 16;
    for (std::size_t first = 0; first + burst <= columns.size(); ++first) {
        std::array<std::uint16_t, burst> basis{};
        for (std::size_t i = 0; i < burst; ++i) {
            std::uint16_t rest = columns[first + i];
            for (std::size_t bit = burst; bit-- > 0 and rest != 0;) {
                if (((rest >> bit) & 1U) != 0) {
                    if (basis[bit] == 0) {
                        basis[bit] = rest;
                        break;
                    }
                    rest = static_cast<std::uint16_t>(rest ^ basis[bit]);
                }
            }
            if (rest == 0) {
                return false;
            }
        }
    }
    return true;
}

} // namespace

int main(int argc, char** argv)
{
    using exhaustive::holds;
    std::uint64_t const stride = exhaustive::stride_of(argc, argv);
    constexpr std::uint64_t lengths = max_adu_size - min_adu_size + 1;
    auto const columns = [](std::uint64_t at) { return columns_of(at + min_adu_size); };
    bool ok = holds("errors of up to 3 bits, by length", lengths, stride,
                    [&](std::uint64_t at) { return sees_three_bits(columns(at)); });
    ok = holds("bursts of up to 16 bits, by length", lengths, stride,
               [&](std::uint64_t at) { return sees_bursts(columns(at)); }) and
         ok;
    return ok ? 0 : 1;
}
