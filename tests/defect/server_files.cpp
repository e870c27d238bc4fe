// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 20 with several runs: the place of a run's records in the request was computed, though a request to read has
// none, and came to lie behind the memory of the PDU. A compiler that evaluates it refuses that; a run shows nothing.
#include <rtuwire/server/respond.hpp>

#include <array>

#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

/// Files whose records are their own numbers.
struct numbered_files {
    static constexpr errc check_read_file(file_run) { return errc::none; }
    static constexpr errc read_file(file_run run, byte_writer& out)
    {
        for (std::uint32_t i = 0; i < run.count; ++i) {
            out.u16(run.file * 0x100U + run.record + i);
        }
        return errc::none;
    }
};

using reading_files = function_list<read_file_record<>>;

/// Whether each run is answered by its records, for requests of one run to the most that a request has.
constexpr bool reads_each_run()
{
    bool reads = true;
    for (std::size_t runs = 1; runs <= 35; ++runs) {
        numbered_files bank;
        std::array<std::byte, max_pdu_size> asked{};
        std::array<std::byte, max_pdu_size> place{};
        // As many records as the response has room for: 2 bytes in front of those of each run.
        std::size_t const count = (245 / runs - 2) / 2;
        byte_writer out{asked};
        out.u16(static_cast<std::uint32_t>(0x1400 + 7 * runs));
        for (std::size_t run = 1; run <= runs; ++run) {
            out.u8(6);
            out.u16(static_cast<std::uint32_t>(run));
            out.u16(0);
            out.u16(static_cast<std::uint32_t>(count));
        }
        byte_view const told = respond<reading_files>(out.written(), bank, server_profile{}, place);
        std::size_t const part = 2 + 2 * count;
        reads = reads and told.size() == 2 + runs * part;
        for (std::size_t run = 1; reads and run <= runs; ++run) {
            byte_view const its = told.subspan(2 + (run - 1) * part, part);
            reads = to_u8(its[0]) == 1 + 2 * count and to_u8(its[1]) == 6 and
                    u16_at(its, part - 2) == run * 0x100U + count - 1;
        }
    }
    return reads;
}
PROOF("defect: D30 a request of several runs is read within its memory", reads_each_run)

constexpr auto two_long_runs = "14 0E 06 00 01 00 00 00 3C 06 00 02 00 00 00 3C"_hex;

constexpr bool reads_two_long_runs()
{
    numbered_files bank;
    std::array<std::byte, max_pdu_size> place{};
    byte_view const told = respond<reading_files>(two_long_runs, bank, server_profile{}, place);
    return told.size() == 246 and told[0] == std::byte{0x14} and u16_at(told, 244) == 0x023B;
}
PROOF("defect: D30 two runs of 60 records", reads_two_long_runs)

} // namespace
