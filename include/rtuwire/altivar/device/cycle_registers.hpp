// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which words a cycle of a drive reads and writes, in which order and by which function, and where the drive has its
// scanner: registers that one request reads or writes in place of others. Each drive carries both as data.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Where a drive has its scanner; `scanner_registers{}` where it has none. Each row has `words` registers, one after
/// the other, and is named here by its first.
struct scanner_registers {
    std::uint16_t input_addresses{0};  ///< which registers are read (NMA1)
    std::uint16_t output_addresses{0}; ///< which registers are written (NCA1)
    std::uint16_t input_words{0};      ///< what they hold (NM1)
    std::uint16_t output_words{0};     ///< what is written to them (NC1)
    std::uint8_t words{0};             ///< each way; 0: there is no scanner

    /// Whether a register belongs to the scanner.
    [[nodiscard]] constexpr bool has(std::uint16_t address) const noexcept
    {
        return is_from(input_addresses, address) or is_from(output_addresses, address) or
               is_from(input_words, address) or is_from(output_words, address);
    }
    /// Whether a register holds one of the words that are written.
    [[nodiscard]] constexpr bool is_output(std::uint16_t address) const noexcept
    {
        return is_from(output_words, address);
    }

private:
    [[nodiscard]] constexpr bool is_from(std::uint16_t first, std::uint16_t address) const noexcept
    {
        return address >= first and std::uint32_t{address} < std::uint32_t{first} + words;
    }
};

/// Addresses of registers in the order in which a cycle moves their words; up to 8. 0: a word of the scanner that the
/// program may use as it likes.
class cycle_addresses {
public:
    static constexpr std::size_t most = 8;

    /// Takes the addresses in the order of the words; more than `most` do not compile.
    template <std::convertible_to<std::uint16_t>... Addresses>
        requires(sizeof...(Addresses) <= most)
    constexpr cycle_addresses(Addresses... addresses) noexcept
        : addresses_{static_cast<std::uint16_t>(addresses)...}, size_{sizeof...(Addresses)}
    {}

    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr std::uint16_t operator[](std::size_t place) const noexcept { return addresses_[place]; }

    /// Where a register stands; `size()` where it does not.
    [[nodiscard]] constexpr std::size_t place_of(std::uint16_t address) const noexcept
    {
        std::size_t place = 0;
        while (place < size_ and addresses_[place] != address) {
            ++place;
        }
        return place;
    }
    [[nodiscard]] constexpr bool has(std::uint16_t address) const noexcept { return place_of(address) < size_; }

    /// Whether each is the address after the one before.
    [[nodiscard]] constexpr bool follow_one_another() const noexcept
    {
        bool is_so = true;
        for (std::size_t place = 1; place < size_; ++place) {
            is_so = is_so and addresses_[place] == addresses_[0] + place;
        }
        return is_so;
    }

private:
    std::array<std::uint16_t, most> addresses_;
    std::size_t size_;
};

/// What a cycle of a drive moves in each period.
struct cycle_registers {
    function_code by;       ///< 23: one request; 16: a read by function 03, then a write
    cycle_addresses reads;  ///< the status word (ETA) and `speed` are among them
    cycle_addresses writes; ///< the control word (CMD) and one reference are among them
    std::uint16_t speed;    ///< a register that holds 0 while the motor stands
    bool by_scanner{false}; ///< the words are the first ones of the scanner, which stand for these registers
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
