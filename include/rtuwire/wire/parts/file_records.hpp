// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Records of files, as functions 20 and 21 name and carry them (AP 6.14, 6.15): a file has 10 000 records, numbered
// from 0, and a record is one register.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/register_view.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// `count` records of a file from `record` on.
struct file_run {
    std::uint16_t file;   ///< 1..65535
    std::uint16_t record; ///< 0..9999
    std::uint16_t count;  ///< 1 and more; records are not counted past 9999

    [[nodiscard]] constexpr errc check() const noexcept
    {
        constexpr std::uint32_t records = 10'000;
        if (count == 0) {
            return errc::invalid_quantity;
        }
        bool const is_there = file != 0 and std::uint32_t{record} + count <= records;
        return is_there ? errc::none : errc::invalid_address_range;
    }

    friend constexpr bool operator==(file_run const&, file_run const&) = default;
};

/// The byte in front of each run.
/// Internal.
inline constexpr std::uint8_t file_reference = 6;

/// A run's head: reference, file, record, count.
/// Internal.
inline constexpr std::size_t file_run_size = 7;

/// Reads a run's head; the caller has checked that its bytes are there.
/// Internal.
[[nodiscard]] constexpr file_run file_run_at(byte_view bytes, std::size_t at) noexcept
{
    return {u16_at(bytes, at + 1), u16_at(bytes, at + 3), u16_at(bytes, at + 5)};
}

/// Takes a run off the front of bytes, with its records where they follow it. Errors: `wrong_length` where the bytes end
/// within it, `malformed` for another reference, and those of the run.
/// Internal.
[[nodiscard]] constexpr errc take_run(byte_view& bytes, file_run& run, bool with_records) noexcept
{
    if (bytes.size() < file_run_size) {
        return errc::wrong_length;
    }
    if (to_u8(bytes[0]) != file_reference) {
        return errc::malformed;
    }
    run = file_run_at(bytes, 0);
    std::size_t const size = file_run_size + (with_records ? std::size_t{2} * run.count : 0);
    if (bytes.size() < size) {
        return errc::wrong_length;
    }
    bytes = bytes.subspan(size);
    return run.check();
}

/// The records of a run that was just taken, where they ended at `end`.
/// Internal.
[[nodiscard]] constexpr register_view records_of(file_run const& run, std::byte const* end) noexcept
{
    std::size_t const size = std::size_t{2} * run.count;
    return register_view{{end - size, size}};
}

/// The most bytes behind the byte count of a response of function 20.
/// Internal.
inline constexpr std::size_t max_file_answer = 245;

/// The bytes of a run in that response: size, reference, records.
/// Internal.
[[nodiscard]] constexpr std::size_t size_of_answer(file_run const& run) noexcept
{
    return 2U + std::size_t{2} * run.count;
}

/// Writes a run's head.
/// Internal.
constexpr void write_run(byte_writer& out, file_run const& run) noexcept
{
    out.u8(file_reference);
    out.u16(run.file);
    out.u16(run.record);
    out.u16(run.count);
}

} // namespace rtuwire
