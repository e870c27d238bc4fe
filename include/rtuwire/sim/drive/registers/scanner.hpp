// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The communication scanner: words that stand for other registers, by addresses that the client sets.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/registers/image.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// One half of a device's scanner, inputs or outputs.
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

} // namespace rtuwire::sim
