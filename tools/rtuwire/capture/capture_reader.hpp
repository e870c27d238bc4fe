// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Frames out of a capture file, pcapng or pcap, of either byte order, given in pieces of any size. Knows no file.
// In headers alone, as all of this folder: the fuzz target and the test with Wireshark need no more of the tool.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/trace.hpp>

#include "capture/block_reader.hpp"
#include "capture/captured_frame.hpp"
#include "capture/file_order.hpp"

namespace tool {

/// Puts the parts of a file together that come in pieces of any size: one part at a time, of up to `Capacity` bytes.
template <std::size_t Capacity> class part_gatherer {
public:
    /// The first part has `needed` bytes.
    explicit constexpr part_gatherer(std::size_t needed) noexcept : needed_{needed} {}

    /// The next piece; it has to stay until `gather` says no.
    constexpr void receive(rtuwire::byte_view piece) noexcept { piece_ = piece; }

    /// Whether all bytes of the part are there.
    [[nodiscard]] constexpr bool gather() noexcept
    {
        skip_ -= static_cast<std::uint32_t>(take(skip_ < piece_.size() ? skip_ : piece_.size()).size());
        std::size_t const missing = needed_ - held_;
        for (std::byte const each : take(missing < piece_.size() ? missing : piece_.size())) {
            place_[held_++] = each;
        }
        return held_ == needed_;
    }

    /// The bytes of the part; they stay where they are until the next one is gathered.
    [[nodiscard]] constexpr rtuwire::byte_view held() const noexcept { return rtuwire::byte_view{place_}.first(held_); }

    /// The part goes on: it has `needed` bytes in all, up to the capacity.
    constexpr void extend(std::size_t needed) noexcept { needed_ = needed; }

    /// A new part, behind `skip` bytes that nobody looks at.
    constexpr void begin(std::size_t needed, std::uint32_t skip = 0) noexcept
    {
        needed_ = needed;
        skip_ = skip;
        held_ = 0;
    }

    /// Whether a part has begun, or bytes are being skipped.
    [[nodiscard]] constexpr bool is_inside() const noexcept { return held_ != 0 or skip_ != 0; }

    /// How many bytes of the file were taken.
    [[nodiscard]] constexpr std::uint64_t offset() const noexcept { return offset_; }

private:
    constexpr rtuwire::byte_view take(std::size_t size) noexcept
    {
        rtuwire::byte_view const taken = piece_.first(size);
        piece_ = piece_.subspan(size);
        offset_ += size;
        return taken;
    }

    rtuwire::byte_view piece_{};
    std::uint64_t offset_{0};
    std::uint32_t skip_{0};
    std::size_t held_{0};
    std::size_t needed_;
    std::array<std::byte, Capacity> place_{};
};

/// Reads a capture, in about 5 KB of its own:
///
///     capture_reader reader;
///     for each piece of the file:
///         reader.receive(piece);
///         while (auto const captured = reader.next()) { use(captured->frame); }
///     reader.finish();
///     reader.error()          // what is wrong with the file, if anything; the frames before it were right
///
/// The four forms of `capture_form` are read, whoever wrote them. A packet that is none of them is counted in
/// `skipped`, and a block that is not known is left out. After an error nothing more is read.
class capture_reader {
public:
    static constexpr std::size_t longest_block = 4096;                       ///< of those that are read
    static constexpr std::size_t most_lines = block_reader::most_interfaces; ///< in a section of a file

    /// The next piece of the file. It has to stay until `next` returns nothing; what is left of a piece before that
    /// is lost.
    constexpr void receive(rtuwire::byte_view piece) noexcept { file_.receive(piece); }

    /// The next frame; nothing when the piece is used up. Its bytes are valid until the next call.
    [[nodiscard]] constexpr std::optional<captured_frame> next() noexcept
    {
        while (error_.why == capture_errc::none and file_.gather()) {
            has_found_ = false;
            step();
            if (has_found_) {
                return blocks_.found();
            }
        }
        return std::nullopt;
    }

    /// The file ends here.
    constexpr void finish() noexcept
    {
        if (file_.is_inside() or not is_between_blocks_) {
            check(capture_errc::cut_short);
        }
    }

    /// What is wrong; `why` is `none` while nothing is.
    [[nodiscard]] constexpr capture_error error() const noexcept { return error_; }

    /// How many packets carried no frame.
    [[nodiscard]] constexpr std::uint32_t skipped() const noexcept { return blocks_.skipped(); }

private:
    /// What the bytes that are being gathered are.
    enum class part : std::uint8_t { magic, file_head, record_head, record, block_head, block, block_end };

    /// Keeps the first error; whether there is none.
    constexpr bool check(capture_errc why) noexcept
    {
        if (error_.why == capture_errc::none and why != capture_errc::none) {
            error_ = {why, start_};
        }
        return error_.why == capture_errc::none;
    }

    [[nodiscard]] constexpr rtuwire::byte_view held() const noexcept { return file_.held(); }
    [[nodiscard]] constexpr std::uint32_t u32(std::size_t at) const noexcept { return order().u32(held(), at); }
    [[nodiscard]] constexpr file_order& order() noexcept { return blocks_.order; }
    [[nodiscard]] constexpr file_order const& order() const noexcept { return blocks_.order; }

    /// A part that goes on where the bytes end that are there: `needed` counts them, too.
    constexpr void extend(part what, std::size_t needed) noexcept
    {
        part_ = what;
        is_between_blocks_ = false;
        file_.extend(needed);
    }

    /// A block or a record starts here, or the file ends.
    constexpr void expect_next(part what, std::size_t needed) noexcept
    {
        part_ = what;
        is_between_blocks_ = true;
        start_ = file_.offset();
        file_.begin(needed);
    }

    constexpr void step() noexcept
    {
        switch (part_) {
        case part::magic: return on_magic();
        case part::file_head: return on_file_head();
        case part::record_head: return on_record_head();
        case part::record: return on_record();
        case part::block_head: return on_block_head();
        case part::block: return on_block();
        case part::block_end: return compare_lengths(u32(0));
        }
    }

    constexpr void on_magic() noexcept
    {
        constexpr std::uint32_t microseconds_low = 0xD4C3'B2A1U;
        constexpr std::uint32_t nanoseconds_low = 0x4D3C'B2A1U;
        constexpr std::uint32_t microseconds_high = 0xA1B2'C3D4U;
        constexpr std::uint32_t nanoseconds_high = 0xA1B2'3C4DU;
        std::uint32_t const first = file_order{true}.u32(held(), 0);
        if (first == pcapng_code::section) {
            return extend(part::block_head, block_head_size);
        }
        order() = {first == microseconds_high or first == nanoseconds_high};
        has_nanoseconds_ = first == nanoseconds_low or first == nanoseconds_high;
        bool const is_pcap = order().has_high_first or has_nanoseconds_ or first == microseconds_low;
        if (check(is_pcap ? capture_errc::none : capture_errc::not_a_capture)) {
            extend(part::file_head, file_head_size);
        }
    }

    // pcap: one header, then records.

    constexpr void on_file_head() noexcept
    {
        bool const is_known = order().u16(held(), 4) == 2;
        if (check(is_known ? capture_errc::none : capture_errc::unsupported_version)) {
            blocks_.set_only_interface(u32(20) & 0xFFFFU);
            expect_next(part::record_head, record_head_size);
        }
    }

    constexpr void on_record_head() noexcept
    {
        std::uint32_t const kept = u32(8);
        if (check(kept > longest_block - record_head_size ? capture_errc::block_too_long : capture_errc::none)) {
            extend(part::record, record_head_size + kept);
        }
    }

    constexpr void on_record() noexcept
    {
        std::uint32_t const fraction = has_nanoseconds_ ? u32(4) / 1000U : u32(4);
        std::uint64_t const time = u32(0) * std::uint64_t{1'000'000} + fraction;
        if (check(blocks_.read_record({held().subspan(record_head_size), u32(12)}, time))) {
            has_found_ = blocks_.found().has_value();
            expect_next(part::record_head, record_head_size);
        }
    }

    // pcapng: blocks, each with its length in front and at its end.

    constexpr void on_block_head() noexcept
    {
        if (u32(0) == pcapng_code::section and not take_byte_order()) {
            return static_cast<void>(check(capture_errc::not_a_capture));
        }
        length_ = u32(4);
        bool const is_right = length_ >= block_head_size and length_ % 4 == 0;
        if (not check(is_right ? capture_errc::none : capture_errc::wrong_block_length)) {
            return;
        }
        if (not is_read_block(u32(0))) {
            return leave_out();
        }
        if (check(length_ > longest_block ? capture_errc::block_too_long : capture_errc::none)) {
            extend(part::block, length_);
        }
    }

    /// The type of a section is the same in both orders.
    [[nodiscard]] constexpr bool take_byte_order() noexcept
    {
        order() = {file_order{true}.u32(held(), 8) == pcapng_code::byte_order};
        return u32(8) == pcapng_code::byte_order;
    }

    /// A block that is not looked into: only its last length is compared.
    constexpr void leave_out() noexcept
    {
        if (length_ == block_head_size) {
            return compare_lengths(u32(8));
        }
        extend(part::block_end, 4);
        file_.begin(4, length_ - static_cast<std::uint32_t>(block_head_size) - 4U);
    }

    constexpr void on_block() noexcept
    {
        std::uint32_t const last = u32(length_ - 4U);
        if (last == length_) {
            check(blocks_.read(u32(0), held().subspan(8, length_ - block_head_size)));
            has_found_ = blocks_.found().has_value();
        }
        compare_lengths(last);
    }

    constexpr void compare_lengths(std::uint32_t last) noexcept
    {
        if (check(last == length_ ? capture_errc::none : capture_errc::wrong_block_length)) {
            expect_next(part::block_head, block_head_size);
        }
    }

    static constexpr std::size_t block_head_size = 12; // the shortest block
    static constexpr std::size_t file_head_size = 24;
    static constexpr std::size_t record_head_size = 16;

    part_gatherer<longest_block> file_{4};
    std::uint64_t start_{0}; ///< of the block
    part part_{part::magic};
    bool is_between_blocks_{false};
    bool has_nanoseconds_{false};
    bool has_found_{false};
    std::uint32_t length_{0};
    capture_error error_{};
    block_reader blocks_{};
};

} // namespace tool
