// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The server's half of functions 20 and 21 (AP 6.14, 6.15): one walk over the runs of a request for both.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/limits.hpp>
#include <rtuwire/wire/parts/file_records.hpp>
#include <rtuwire/wire/register_view.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The exception to a request in which that was found: another reference, file or record is an address to the
/// specification's diagrams.
[[nodiscard]] constexpr errc file_exception(errc wrong) noexcept
{
    bool const is_address = wrong == errc::malformed or wrong == errc::invalid_address_range;
    return is_address ? errc::illegal_data_address : errc::illegal_data_value;
}

/// What a bank has of files.
template <typename Bank>
concept reads_files = requires(Bank& bank, byte_writer& out, file_run run)
{
    bank.read_file(run, out);
};
template <typename Bank>
concept writes_files = requires(Bank& bank, file_run run, register_view values)
{
    bank.write_file(run, values);
};

/// Checks with a bank a run that function 20 or 21 names.
template <typename Bank>
[[nodiscard]] constexpr errc check_run_of(Bank& bank, bool writes, file_run const& run, std::byte const* end) noexcept
{
    if constexpr (writes_files<Bank>) {
        if (writes) {
            return bank.check_write_file(run, records_of(run, end));
        }
    }
    if constexpr (reads_files<Bank>) {
        return bank.check_read_file(run);
    }
    return errc::none;
}

/// Writes that run, or appends its part of a response.
template <typename Bank>
[[nodiscard]] constexpr errc access_run(Bank& bank, bool writes, file_run const& run, std::byte const* end,
                                        byte_writer& out) noexcept
{
    if constexpr (writes_files<Bank>) {
        if (writes) {
            return bank.write_file(run, records_of(run, end));
        }
    }
    if constexpr (reads_files<Bank>) {
        std::size_t const after = out.size() + size_of_answer(run);
        out.u8(1U + 2U * run.count);
        out.u8(file_reference);
        if (errc const wrong = bank.read_file(run, out); wrong != errc::none) {
            return wrong;
        }
        return out.size() == after ? errc::none : errc::server_device_failure;
    }
    return errc::none;
}

/// Answers a request of function 20 or 21, whose data begin behind the byte count. One walk for both. All runs are
/// checked before the first is accessed; the first that is wrong decides.
template <typename Bank>
[[nodiscard]] constexpr errc access_files(byte_view data, Bank& bank, bool writes, byte_writer& out) noexcept
{
    std::array<file_run, max_pdu_size / file_run_size> runs; // apart: a response is written over the request
    file_run* end = runs.data();
    std::size_t answer = 0;
    byte_view rest = data;
    do {
        if (errc const wrong = take_run(rest, *end, writes); wrong != errc::none) {
            return file_exception(wrong);
        }
        answer += size_of_answer(*end);
        if (not writes and answer > max_file_answer) {
            return errc::illegal_data_value;
        }
        if (errc const wrong = check_run_of(bank, writes, *end, rest.data()); wrong != errc::none) {
            return wrong;
        }
        ++end;
    } while (not rest.empty());
    std::byte const* at = data.data();
    for (file_run const* run = runs.data(); run != end; ++run) {
        if (writes) { // a request to read has no records: their place would lie behind its memory
            at += file_run_size + std::size_t{2} * run->count;
        }
        if (errc const wrong = access_run(bank, writes, *run, at, out); wrong != errc::none) {
            return wrong;
        }
    }
    return errc::none;
}

} // namespace rtuwire
