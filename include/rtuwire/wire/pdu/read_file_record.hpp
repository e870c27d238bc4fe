// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 20, read file record (AP 6.14): up to 35 runs of records in one request.
#pragma once

#include <array>
#include <concepts>
#include <optional>

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/frame_rules.hpp>
#include <rtuwire/wire/parts/file_records.hpp>
#include <rtuwire/wire/parts/file_serving.hpp>
#include <rtuwire/wire/parts/pdu_fields.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

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
            std::size_t const size = to_u8(rest[0]);
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
            rest = rest.subspan(1U + to_u8(rest[0]));
        }
        return data.empty() or not rest.empty() or data.size() > max_size - 2 ? errc::malformed : errc::none;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 2 + data.size(); }
    constexpr void write(byte_writer& out) const noexcept { write_counted(out, code, data); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `malformed` where the runs do not fill it.
    [[nodiscard]] static constexpr result<read_file_record_response> decode(byte_view pdu) noexcept
    {
        auto const bytes = decode_counted(pdu, code);
        return bytes ? checked_pdu(read_file_record_response{*bytes}) : bytes.error();
    }

private:
    /// Whether these bytes begin with a whole run: an odd size, the reference and one register at least.
    static constexpr bool has_run(byte_view bytes) noexcept
    {
        return bytes.size() >= 4 and to_u8(bytes[1]) == file_reference and to_u8(bytes[0]) >= 3 and
               to_u8(bytes[0]) % 2 == 1 and bytes.size() > to_u8(bytes[0]);
    }
};

/// Runs as they stand in a received request.
class file_runs {
public:
    constexpr file_runs() noexcept = default;
    /// Internal: bytes of whole runs.
    explicit constexpr file_runs(byte_view bytes) noexcept : bytes_{bytes} {}

    [[nodiscard]] constexpr std::size_t size() const noexcept { return bytes_.size() / file_run_size; }

    /// The run at an index below `size()`; any other index is misuse, as in a `register_view`.
    [[nodiscard]] constexpr file_run operator[](std::size_t index) const noexcept
    {
        require_register(index, size());
        return file_run_at(bytes_, index * file_run_size);
    }

private:
    byte_view bytes_{};
};

/// Reads records of one unit's files: `read_file_record{file_run{.file = 4, .record = 1, .count = 2}}`, or with several
/// runs, one after the other.
template <typename Runs = file_runs> struct read_file_record {
    using response = read_file_record_response;
    static constexpr function_code code = function_code::read_file_record;
    static constexpr frame_rules rules{sized(length_rule::byte_count, 5), sized(length_rule::byte_count, 5),
                                       answer_rule::nothing};
    static constexpr std::size_t most_runs = 35;
    static constexpr std::size_t max_size = 2 + most_runs * file_run_size;

    Runs runs; ///< 1..35, whose response has 245 bytes at most

    [[nodiscard]] constexpr errc check() const noexcept
    {
        if (not is_quantity(runs.size(), most_runs)) {
            return errc::invalid_quantity;
        }
        std::size_t answer = 0;
        for (std::size_t i = 0; i < runs.size(); ++i) {
            if (errc const wrong = runs[i].check(); wrong != errc::none) {
                return wrong;
            }
            answer += size_of_answer(runs[i]);
        }
        return answer > response::max_size - 2 ? errc::invalid_quantity : errc::none;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 2 + file_run_size * runs.size(); }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(to_u8(code));
        out.u8(static_cast<std::uint32_t>(file_run_size * runs.size()));
        for (std::size_t i = 0; i < runs.size(); ++i) {
            write_run(out, runs[i]);
        }
    }

    /// The size of the longest response to a request, both ADUs: known of one run.
    /// Internal.
    [[nodiscard]] static constexpr std::size_t longest_response(byte_view request_adu) noexcept
    {
        constexpr std::size_t with_one_run = 12, count_at = 8, most = 121;
        std::size_t const count = request_adu.size() == with_one_run ? u16_at(request_adu, count_at) : most + 1;
        return count <= most ? 7 + 2 * count : max_adu_size;
    }

    /// Whether a response has the records of each run of its request.
    /// Internal.
    [[nodiscard]] static constexpr errc check_response(byte_view request_pdu, byte_view response_pdu) noexcept
    {
        std::size_t at = 2;
        for (std::size_t i = 2; i + file_run_size <= request_pdu.size(); i += file_run_size) {
            std::size_t const size = 1U + std::size_t{2} * u16_at(request_pdu, i + 5);
            if (response_pdu.size() < at + 1 + size or to_u8(response_pdu[at]) != size or
                to_u8(response_pdu[at + 1]) != file_reference) {
                return errc::response_mismatch;
            }
            at += 1 + size;
        }
        return response_pdu.size() == at and at == 2U + to_u8(response_pdu[1]) ? errc::none : errc::wrong_length;
    }

    /// Whether a bank has what this function serves.
    /// Internal.
    template <typename Bank> static constexpr bool is_served_by = reads_files<Bank>;

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const& at) noexcept
    {
        static_assert(is_served_by<decltype(at.bank)>,
                      "a server of function 20 needs a bank with check_read_file(run) and read_file(run, out)");
        return access_files(pdu.view().subspan(2), at.bank, false, at.out);
    }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `malformed` for another reference than 6, and those of
    /// `check`.
    [[nodiscard]] static constexpr result<read_file_record<>> decode(byte_view pdu) noexcept
    {
        auto const bytes = decode_counted(pdu, code);
        if (not bytes) {
            return bytes.error();
        }
        if (bytes->size() % file_run_size != 0) {
            return errc::wrong_length;
        }
        for (std::size_t at = 0; at < bytes->size(); at += file_run_size) {
            if (to_u8((*bytes)[at]) != file_reference) {
                return errc::malformed;
            }
        }
        return checked_pdu(read_file_record<>{file_runs{*bytes}});
    }
};

template <std::size_t Count>
read_file_record(std::array<file_run, Count>) -> read_file_record<std::array<file_run, Count>>;
template <std::same_as<file_run>... Others>
read_file_record(file_run, Others...) -> read_file_record<std::array<file_run, 1 + sizeof...(Others)>>;

} // namespace rtuwire
