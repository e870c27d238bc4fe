// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A bank that has something for every public function, and that can be told to fail.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/server/banks.hpp>
#include <rtuwire/wire/serial_line/file_records.hpp>

namespace rtuwire::test {

/// Bits that fail where they are told to.
template <std::size_t Count> struct failing_bits : bit_bank<Count> {
    errc broken{errc::none};
    unsigned writes{0};

    constexpr errc read(std::uint16_t start, std::size_t count, byte_span out)
    {
        return broken != errc::none ? broken : bit_bank<Count>::read(start, count, out);
    }
    constexpr errc write(std::uint16_t start, bit_view values)
    {
        ++writes;
        return broken != errc::none ? broken : bit_bank<Count>::write(start, values);
    }
};

/// 16 registers, 64 coils, 32 inputs and 8 input registers from address 0 on; a queue at 100; files 1 and 2 of 8
/// records each. Nothing that is refused may change it, and `all_writes` counts what does.
struct whole_bank {
    word_bank<16> words{};
    failing_bits<64> switched{};
    failing_bits<32> contacts{};
    word_bank<8> measured{};
    std::array<std::uint16_t, 40> queue{};
    std::size_t queued{0};
    std::array<std::array<std::uint16_t, 8>, 2> files{};
    std::uint8_t outputs{0x6D};
    std::array<std::byte, 3> id{std::byte{0x12}, std::byte{0xFF}, std::byte{0x34}};
    std::size_t id_size{3};
    errc broken{errc::none}; ///< what every access returns
    unsigned writes{0};

    /// How often anything was written.
    [[nodiscard]] constexpr unsigned all_writes() const { return writes + switched.writes; }

    /// Lets every access fail.
    constexpr void fail(errc how)
    {
        broken = how;
        switched.broken = how;
        contacts.broken = how;
    }

    constexpr errc check_read(std::uint16_t start, std::size_t count) const { return words.check_read(start, count); }
    constexpr errc check_write(std::uint16_t start, register_view values) const
    {
        return words.check_write(start, values);
    }
    constexpr errc read(std::uint16_t start, std::size_t count, byte_writer& out)
    {
        return broken != errc::none ? broken : words.read(start, count, out);
    }
    constexpr errc write(std::uint16_t start, register_view values)
    {
        ++writes;
        return broken != errc::none ? broken : words.write(start, values);
    }

    constexpr auto& coils() { return switched; }
    constexpr auto& discrete_inputs() { return contacts; }
    constexpr auto& input_registers() { return measured; }
    [[nodiscard]] constexpr std::uint8_t exception_status() const { return outputs; }
    [[nodiscard]] constexpr byte_view server_id() const { return byte_view{id}.first(id_size); }

    constexpr errc read_fifo(std::uint16_t address, byte_writer& out) const
    {
        if (address != 100) {
            return errc::illegal_data_address;
        }
        for (std::size_t i = 0; i < queued; ++i) {
            out.u16(queue[i]);
        }
        return broken;
    }

    constexpr errc check_read_file(file_run run) const
    {
        bool const is_there = run.file <= files.size() and std::size_t{run.record} + run.count <= files[0].size();
        return is_there ? errc::none : errc::illegal_data_address;
    }
    constexpr errc read_file(file_run run, byte_writer& out) const
    {
        for (std::size_t i = 0; i < run.count; ++i) {
            out.u16(files[run.file - 1U][run.record + i]);
        }
        return broken;
    }
    constexpr errc check_write_file(file_run run, register_view) const { return check_read_file(run); }
    constexpr errc write_file(file_run run, register_view values)
    {
        ++writes;
        for (std::size_t i = 0; i < values.size() and broken == errc::none; ++i) {
            files[run.file - 1U][run.record + i] = values[i];
        }
        return broken;
    }
};

} // namespace rtuwire::test
