// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 21, write file record (AP 6.15). Request and response are the same bytes. A request made here has one run; a
// received one may have several.
#pragma once

#include <concepts>
#include <optional>

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/frame_rules.hpp>
#include <rtuwire/wire/parts/file_records.hpp>
#include <rtuwire/wire/parts/file_serving.hpp>
#include <rtuwire/wire/parts/pdu_fields.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Runs with their records, as they stand in a received request or response.
struct file_writes {
    static constexpr function_code code = function_code::write_file_record;
    static constexpr std::size_t max_size = 2 + 251;

    /// A run and its records.
    struct write_of_run {
        file_run run;
        register_view values;
    };

    byte_view data; ///< of each run its head and its records; a view of the received bytes

    /// The run at an index, if there is one. A template: a file that does not
    /// call it has no optional to compile.
    template <std::same_as<write_of_run> Run = write_of_run>
    [[nodiscard]] constexpr std::optional<Run> run(std::size_t index) const noexcept
    {
        file_run each{};
        for (byte_view rest = data; take_run(rest, each, true) == errc::none; --index) {
            if (index == 0) {
                return Run{each, records_of(each, rest.data())};
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] constexpr errc check() const noexcept
    {
        file_run each{};
        errc wrong = is_quantity(data.size(), max_size - 2) ? errc::none : errc::invalid_quantity;
        for (byte_view rest = data; wrong == errc::none and not rest.empty();) {
            wrong = take_run(rest, each, true);
        }
        return wrong;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 2 + data.size(); }
    constexpr void write(byte_writer& out) const noexcept { write_counted(out, code, data); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length` (where whole runs do not fill it too), `malformed` for
    /// another reference than 6, `invalid_quantity` without a run, and those of a `file_run`.
    [[nodiscard]] static constexpr result<file_writes> decode(byte_view pdu) noexcept
    {
        auto const bytes = decode_counted(pdu, code);
        return bytes ? checked_pdu(file_writes{*bytes}) : bytes.error();
    }
};

/// Writes records of a file of one unit or of all; the response repeats them. Made of a block, it owns that block; made
/// of a view, its words are stored elsewhere.
template <typename Words = register_view> struct write_file_record {
    using response = file_writes;
    static constexpr function_code code = function_code::write_file_record;
    static constexpr frame_rules rules{sized(length_rule::byte_count, 5), sized(length_rule::byte_count, 5),
                                       answer_rule::whole};
    static constexpr std::size_t most = 122;
    static constexpr std::size_t max_size = 2U + file_run_size + bytes_at_most<Words, most>;
    static constexpr bool may_be_broadcast = true;

    std::uint16_t file;   ///< 1..65535
    std::uint16_t record; ///< 0..9999, the first
    Words values;         ///< 1..122 in wire order

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return is_quantity(values.size(), most) ? run().check() : errc::invalid_quantity;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 2 + file_run_size + values.bytes().size(); }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(to_u8(code));
        out.u8(static_cast<std::uint32_t>(file_run_size + values.bytes().size()));
        write_run(out, run());
        out.bytes(values.bytes());
    }

    /// Reads a PDU of one run or several; see `file_writes`.
    [[nodiscard]] static constexpr result<file_writes> decode(byte_view pdu) noexcept
    {
        return file_writes::decode(pdu);
    }

    /// Whether a bank has what this function serves.
    /// Internal.
    template <typename Bank> static constexpr bool is_served_by = writes_files<Bank>;

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const& at) noexcept
    {
        static_assert(
            is_served_by<decltype(at.bank)>,
            "a server of function 21 needs a bank with check_write_file(run, values) and write_file(run, values)");
        return access_files(pdu.view().subspan(2), at.bank, true, at.out);
    }

private:
    [[nodiscard]] constexpr file_run run() const noexcept
    {
        return {file, record, static_cast<std::uint16_t>(values.size())};
    }
};

write_file_record(std::uint16_t, std::uint16_t, register_view)->write_file_record<>;
template <std::size_t Count>
write_file_record(std::uint16_t, std::uint16_t, register_block<Count>) -> write_file_record<register_block<Count>>;

} // namespace rtuwire
