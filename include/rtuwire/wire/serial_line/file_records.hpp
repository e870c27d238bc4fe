// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Records of files: functions 20, read (AP 6.14), and 21, write file record (AP 6.15). A file has 10 000 records,
// numbered from 0, and a record is one register. A request to write made here has one run; a received one may have
// several.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/serial_line_rules.hpp>
#include <rtuwire/wire/views.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

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

namespace detail {

/// Reads a run's head; the caller has checked that its bytes are there.
[[nodiscard]] constexpr file_run file_run_at(byte_view bytes, std::size_t at) noexcept
{
    return {u16_at(bytes, at + 1), u16_at(bytes, at + 3), u16_at(bytes, at + 5)};
}

/// Takes a run off the front of bytes, with its records where they follow it. Errors: `wrong_length` where the bytes end
/// within it, `malformed` for another reference, and those of the run.
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
[[nodiscard]] constexpr register_view records_of(file_run const& run, std::byte const* end) noexcept
{
    std::size_t const size = std::size_t{2} * run.count;
    return register_view{{end - size, size}};
}

/// The most bytes behind the byte count of a response of function 20.
inline constexpr std::size_t max_file_answer = 245;

/// The bytes of a run in that response: size, reference, records.
[[nodiscard]] constexpr std::size_t size_of_answer(file_run const& run) noexcept
{
    return 2U + std::size_t{2} * run.count;
}

/// Writes a run's head.
constexpr void write_run(byte_writer& out, file_run const& run) noexcept
{
    out.u8(file_reference);
    out.u16(run.file);
    out.u16(run.record);
    out.u16(run.count);
}

/// The exception to a request in which that was found: another reference, file or record is an address to the
/// specification's diagrams.
[[nodiscard]] constexpr errc file_exception(errc wrong) noexcept
{
    bool const is_address = wrong == errc::malformed or wrong == errc::invalid_address_range;
    return is_address ? errc::illegal_data_address : errc::illegal_data_value;
}

/// Whether a bank has files to read, and to write.
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

} // namespace detail

/// The response to function 20: the records of each run that was asked, in the order of the request.
struct read_file_record_response {
    static constexpr function_code code = function_code::read_file_record;
    static constexpr std::size_t max_size = 2 + 245;

    byte_view data; ///< of each run its size, the reference and its records; a view of the received bytes

    /// The records of the run with this index in the request, if there is one. A template: a file that does not
    /// call it has no optional to compile.
    template <std::same_as<register_view> Records = register_view>
    [[nodiscard]] constexpr std::optional<Records> run(std::size_t index) const noexcept
    {
        byte_view rest = data;
        while (has_run(rest)) {
            std::size_t const size = detail::to_u8(rest[0]);
            if (index == 0) {
                return Records{rest.subspan(2, size - 1)};
            }
            --index;
            rest = rest.subspan(1 + size);
        }
        return std::nullopt;
    }

    [[nodiscard]] constexpr errc check() const noexcept
    {
        byte_view rest = data;
        while (has_run(rest)) {
            rest = rest.subspan(1U + detail::to_u8(rest[0]));
        }
        return data.empty() or not rest.empty() or data.size() > max_size - 2 ? errc::malformed : errc::none;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 2 + data.size(); }
    constexpr void write(byte_writer& out) const noexcept { detail::write_counted(out, code, data); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `malformed` where the runs do not fill it.
    [[nodiscard]] static constexpr result<read_file_record_response> decode(byte_view pdu) noexcept
    {
        auto const bytes = detail::decode_counted(pdu, code);
        return bytes ? detail::checked_pdu(read_file_record_response{*bytes}) : bytes.error();
    }

private:
    /// Whether these bytes begin with a whole run: an odd size, the reference and one register at least.
    static constexpr bool has_run(byte_view bytes) noexcept
    {
        return bytes.size() >= 4 and detail::to_u8(bytes[1]) == detail::file_reference and
               detail::to_u8(bytes[0]) >= 3 and detail::to_u8(bytes[0]) % 2 == 1 and
               bytes.size() > detail::to_u8(bytes[0]);
    }
};

/// Runs as they stand in a received request.
class file_runs {
public:
    /// None.
    constexpr file_runs() noexcept = default;
    /// Internal: bytes of whole runs.
    explicit constexpr file_runs(byte_view bytes) noexcept : bytes_{bytes} {}

    [[nodiscard]] constexpr std::size_t size() const noexcept { return bytes_.size() / detail::file_run_size; }

    /// The run at an index below `size()`; any other index is misuse, as in a `register_view`.
    [[nodiscard]] constexpr file_run operator[](std::size_t index) const noexcept
    {
        detail::require_register(index, size());
        return detail::file_run_at(bytes_, index * detail::file_run_size);
    }

private:
    byte_view bytes_{};
};

/// Reads records of one unit's files: `read_file_record{file_run{.file = 4, .record = 1, .count = 2}}`, or with several
/// runs, one after the other.
template <typename Runs> struct read_file_record {
    using response = read_file_record_response;
    static constexpr function_code code = detail::function_row<read_file_record<>>::code;
    static constexpr detail::frame_rules rules = detail::function_row<read_file_record<>>::rules;
    static constexpr std::size_t most_runs = 35;
    static constexpr std::size_t max_size = 2 + most_runs * detail::file_run_size;

    Runs runs; ///< 1..35, whose response has 245 bytes at most

    [[nodiscard]] constexpr errc check() const noexcept
    {
        if (not detail::is_quantity(runs.size(), most_runs)) {
            return errc::invalid_quantity;
        }
        std::size_t answer = 0;
        for (std::size_t i = 0; i < runs.size(); ++i) {
            if (errc const wrong = runs[i].check(); wrong != errc::none) {
                return wrong;
            }
            answer += detail::size_of_answer(runs[i]);
        }
        return answer > response::max_size - 2 ? errc::invalid_quantity : errc::none;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 2 + detail::file_run_size * runs.size(); }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(detail::to_u8(code));
        out.u8(static_cast<std::uint32_t>(detail::file_run_size * runs.size()));
        for (std::size_t i = 0; i < runs.size(); ++i) {
            detail::write_run(out, runs[i]);
        }
    }

    /// Whether a bank has what this function serves.
    /// Internal.
    template <typename Bank> static constexpr bool is_served_by = detail::reads_files<Bank>;

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const& at) noexcept
    {
        static_assert(is_served_by<decltype(at.bank)>,
                      "a server of function 20 needs a bank with check_read_file(run) and read_file(run, out)");
        return detail::access_files(pdu.view().subspan(2), at.bank, false, at.out);
    }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `malformed` for another reference than 6, and those of
    /// `check`.
    [[nodiscard]] static constexpr result<read_file_record<>> decode(byte_view pdu) noexcept
    {
        auto const bytes = detail::decode_counted(pdu, code);
        if (not bytes) {
            return bytes.error();
        }
        if (bytes->size() % detail::file_run_size != 0) {
            return errc::wrong_length;
        }
        for (std::size_t at = 0; at < bytes->size(); at += detail::file_run_size) {
            if (detail::to_u8((*bytes)[at]) != detail::file_reference) {
                return errc::malformed;
            }
        }
        return detail::checked_pdu(read_file_record<>{file_runs{*bytes}});
    }
};

template <std::size_t Count>
read_file_record(std::array<file_run, Count>) -> read_file_record<std::array<file_run, Count>>;
template <std::same_as<file_run>... Others>
read_file_record(file_run, Others...) -> read_file_record<std::array<file_run, 1 + sizeof...(Others)>>;

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
        for (byte_view rest = data; detail::take_run(rest, each, true) == errc::none; --index) {
            if (index == 0) {
                return Run{each, detail::records_of(each, rest.data())};
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] constexpr errc check() const noexcept
    {
        file_run each{};
        errc wrong = detail::is_quantity(data.size(), max_size - 2) ? errc::none : errc::invalid_quantity;
        for (byte_view rest = data; wrong == errc::none and not rest.empty();) {
            wrong = detail::take_run(rest, each, true);
        }
        return wrong;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 2 + data.size(); }
    constexpr void write(byte_writer& out) const noexcept { detail::write_counted(out, code, data); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length` (where whole runs do not fill it too), `malformed` for
    /// another reference than 6, `invalid_quantity` without a run, and those of a `file_run`.
    [[nodiscard]] static constexpr result<file_writes> decode(byte_view pdu) noexcept
    {
        auto const bytes = detail::decode_counted(pdu, code);
        return bytes ? detail::checked_pdu(file_writes{*bytes}) : bytes.error();
    }
};

/// Writes records of a file of one unit or of all; the response repeats them. Made of a block, it owns that block; made
/// of a view, its words are stored elsewhere.
template <typename Words> struct write_file_record {
    using response = file_writes;
    static constexpr function_code code = detail::function_row<write_file_record<>>::code;
    static constexpr detail::frame_rules rules = detail::function_row<write_file_record<>>::rules;
    static constexpr std::size_t most = 122;
    static constexpr std::size_t max_size = 2U + detail::file_run_size + detail::bytes_at_most<Words, most>;
    static constexpr bool may_be_broadcast = true;

    std::uint16_t file;   ///< 1..65535
    std::uint16_t record; ///< 0..9999, the first
    Words values;         ///< 1..122 in wire order

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return detail::is_quantity(values.size(), most) ? run().check() : errc::invalid_quantity;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept
    {
        return 2 + detail::file_run_size + values.bytes().size();
    }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(detail::to_u8(code));
        out.u8(static_cast<std::uint32_t>(detail::file_run_size + values.bytes().size()));
        detail::write_run(out, run());
        out.bytes(values.bytes());
    }

    /// Reads a PDU of one run or several; see `file_writes`.
    [[nodiscard]] static constexpr result<file_writes> decode(byte_view pdu) noexcept
    {
        return file_writes::decode(pdu);
    }

    /// Whether a bank has what this function serves.
    /// Internal.
    template <typename Bank> static constexpr bool is_served_by = detail::writes_files<Bank>;

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const& at) noexcept
    {
        static_assert(
            is_served_by<decltype(at.bank)>,
            "a server of function 21 needs a bank with check_write_file(run, values) and write_file(run, values)");
        return detail::access_files(pdu.view().subspan(2), at.bank, true, at.out);
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

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
