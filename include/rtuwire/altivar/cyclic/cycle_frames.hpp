// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which registers a drive's cycle reads and writes in each period, by the data of the drive; their words, and the requests
// for them. A frame is valid until the next one is made.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/device/cycle_registers.hpp>
#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/registers.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The words that a drive's cycle reads and writes.
template <drive_type Device> struct cycle_layout {
    static constexpr cycle_registers const& words = Device::cycle;
    static constexpr scanner_registers const& scanner = Device::scanner;
    static constexpr bool has_scanner = words.by_scanner;
    static constexpr std::uint16_t inputs = words.reads.size();
    static constexpr std::uint16_t outputs = words.writes.size();
    static constexpr std::uint16_t read_from = has_scanner ? scanner.input_words : words.reads[0];
    static constexpr std::uint16_t write_to = has_scanner ? scanner.output_words : words.writes[0];
    static constexpr std::size_t status_at = words.reads.place_of(Device::layout.eta);
    static constexpr std::size_t speed_at = words.reads.place_of(words.speed);
    static constexpr bool fits_function_23 = words.by == function_code::read_write_multiple_registers;

    /// Whether the reference is a speed in rpm, else a frequency.
    static constexpr bool is_by_speed = words.writes.has(Device::speed_reference.address);
    static constexpr auto const& reference = []() -> auto const&
    {
        if constexpr (is_by_speed) {
            return Device::speed_reference;
        } else {
            return Device::frequency_reference;
        }
    }
    ();
    static constexpr std::size_t command_at = words.writes.place_of(Device::layout.cmd);
    static constexpr std::size_t reference_at = words.writes.place_of(reference.address);

    /// Whether the program may set an output word.
    [[nodiscard]] static constexpr bool is_free(std::size_t slot) noexcept
    {
        return slot < outputs and slot != command_at and slot != reference_at;
    }
};

/// Inputs, outputs and the request of one drive's cycle.
template <drive_type Device> class cycle_frames {
    using words = cycle_layout<Device>;

    static constexpr std::size_t around_words = words::fits_function_23 ? 13 : 9; ///< of a request that writes
    static constexpr std::size_t most_read =
        words::has_scanner and words::inputs < words::outputs ? words::outputs : words::inputs;

public:
    static constexpr frame_sizes longest{.request = around_words + 2 * std::size_t{words::outputs},
                                         .response = 5 + 2 * most_read};

    explicit constexpr cycle_frames(unit_id unit) noexcept : unit_{unit} {}

    [[nodiscard]] constexpr unit_id unit() const noexcept { return unit_; }

    /// Sets an output beyond command and reference, where the device has it.
    constexpr void set_output(std::size_t slot, std::uint16_t word) noexcept
    {
        if (words::is_free(slot)) {
            outputs_[slot] = word;
            in_use_ |= std::uint32_t{1} << slot;
        }
    }
    /// A bit for each output that was set.
    [[nodiscard]] constexpr std::uint32_t outputs_in_use() const noexcept { return in_use_; }

    constexpr void take(register_view inputs) noexcept
    {
        for (std::size_t i = 0; i < words::inputs; ++i) {
            inputs_[i] = inputs[i];
        }
    }
    [[nodiscard]] constexpr std::uint16_t input(std::size_t slot) const noexcept
    {
        return slot < words::inputs ? inputs_[slot] : std::uint16_t{0};
    }
    [[nodiscard]] constexpr std::uint16_t status() const noexcept { return inputs_[words::status_at]; }
    [[nodiscard]] constexpr std::int16_t speed() const noexcept
    {
        return static_cast<std::int16_t>(inputs_[words::speed_at]);
    }

    /// The command and the reference written last.
    [[nodiscard]] constexpr std::uint16_t command() const noexcept { return outputs_[words::command_at]; }
    [[nodiscard]] constexpr std::uint16_t reference() const noexcept { return outputs_[words::reference_at]; }

    /// The requests. Their sizes are constants of the drive, and checked as such: see `takes_its_cycle`.
    constexpr byte_view read(read_holding_registers const& what) noexcept
    {
        return single(function_code::read_holding_registers, what.start, what.count);
    }
    constexpr byte_view read_one(std::uint16_t address) noexcept
    {
        return single(function_code::read_holding_registers, address, 1);
    }
    constexpr byte_view read_inputs() noexcept
    {
        return single(function_code::read_holding_registers, words::read_from, words::inputs);
    }
    constexpr byte_view say(std::uint16_t command) noexcept
    {
        outputs_[words::command_at] = command;
        return single(function_code::write_single_register, Device::layout.cmd, command);
    }
    constexpr byte_view write(std::uint16_t command, std::uint16_t reference) noexcept
    {
        put(function_code::write_multiple_registers, words::write_to, words::outputs);
        return with_words(6, command, reference);
    }
    constexpr byte_view exchange(std::uint16_t command, std::uint16_t reference) noexcept
    {
        put(function_code::read_write_multiple_registers, words::read_from, words::inputs);
        detail::put_u16(&frame_[6], words::write_to);
        detail::put_u16(&frame_[8], words::outputs);
        return with_words(10, command, reference);
    }

private:
    /// Unit, function and two numbers, with which each of these requests begins.
    [[gnu::noinline]] constexpr void put(function_code function, std::uint16_t address, std::uint16_t value) noexcept
    {
        frame_[0] = detail::to_byte(unit_.byte());
        frame_[1] = static_cast<std::byte>(function);
        detail::put_u16(&frame_[2], address);
        detail::put_u16(&frame_[4], value);
    }

    constexpr byte_view single(function_code function, std::uint16_t address, std::uint16_t value) noexcept
    {
        put(function, address, value);
        return whole(6);
    }

    /// The outputs behind a request's first bytes.
    [[gnu::noinline]] constexpr byte_view with_words(std::size_t at, std::uint16_t command,
                                                     std::uint16_t reference) noexcept
    {
        outputs_[words::command_at] = command;
        outputs_[words::reference_at] = reference;
        frame_[at] = detail::to_byte(2U * words::outputs);
        ++at;
        for (std::uint16_t const word : outputs_) {
            detail::put_u16(&frame_[at], word);
            at += 2;
        }
        return whole(at);
    }

    [[gnu::noinline]] constexpr byte_view whole(std::size_t size) noexcept
    {
        detail::append_crc(frame_, size - 1);
        return byte_view{frame_}.first(size + 2);
    }

    std::array<std::byte, longest.request> frame_{};
    std::array<std::uint16_t, words::outputs> outputs_{};
    std::array<std::uint16_t, words::inputs> inputs_{};
    std::uint32_t in_use_{0};
    unit_id unit_;
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
