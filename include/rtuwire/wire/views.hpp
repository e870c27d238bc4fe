// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Registers and bits in wire order: views over received bytes, and storage for those to be sent. Both directions share
// one form, so values are not copied into an array of host words on the way. Of bits (AP 6.1) the first one is the
// lowest of the first byte, and what is left of the last byte is 0. And what several functions' PDUs have in common: two
// fields behind the function, bytes behind a byte count, and the responses that have one form, registers that were read and
// a run that was written. Each function has a type of its own of them.
//
// A function's `respond` is the server's half, a template over what the server gives it: the request's memory, which
// the response replaces, and `at` with the server's bank, counters, profile and a writer. What it appends to the writer
// is the response behind a byte count, which the server writes; where it appends nothing, the response stands in the
// memory. It returns the exception to send, or none. The request has the size that the function's length rule tells,
// where it tells one.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Ends a program that reads or sets a register behind the last one; see `on_missing_value`. Not constexpr, so that
/// in a constant expression the compiler reports this name.
[[noreturn]] inline void there_is_no_such_register() noexcept
{
    a_failed_result_has_no_value(errc::invalid_address_range);
}

namespace detail {

/// Checks that there is a register at this index among `count`, where `is_misuse_caught()`.
constexpr void require_register(std::size_t index, std::size_t count) noexcept
{
    if (is_misuse_caught() and index >= count) {
        there_is_no_such_register();
    }
}

} // namespace detail

/// A view of big-endian 16-bit registers; valid as long as its bytes.
class register_view {
public:
    /// No registers.
    constexpr register_view() noexcept = default;

    /// The registers that lie in these bytes; an odd last byte is not part of any.
    explicit constexpr register_view(byte_view bytes) noexcept : bytes_{bytes.data(), bytes.size() - bytes.size() % 2}
    {}

    [[nodiscard]] constexpr std::size_t size() const noexcept { return bytes_.size() / 2; }
    [[nodiscard]] constexpr bool empty() const noexcept { return bytes_.empty(); }

    /// The register at an index below `size()`; any other index is misuse, like reading the value of a failed
    /// result.
    [[nodiscard]] constexpr std::uint16_t operator[](std::size_t index) const noexcept
    {
        detail::require_register(index, size());
        return detail::u16_at(bytes_, index * 2);
    }

    /// Copies the registers into words of this machine; returns how many there were. Where `words` has no
    /// room for all of them, nothing is copied: 0.
    constexpr std::size_t copy_to(std::span<std::uint16_t> words) const noexcept
    {
        if (words.size() < size()) {
            return 0;
        }
        std::size_t done = 0;
        if constexpr (sizeof(void*) >= 8 and std::endian::native == std::endian::little) {
            for (; done + 4 <= size(); done += 4) {
                copy_four(bytes_.data() + 2 * done, words.data() + done);
            }
        }
        for (; done < size(); ++done) {
            words[done] = (*this)[done];
        }
        return size();
    }

    /// Not of a temporary, whose bytes are gone after the expression.
    template <std::size_t Size> explicit register_view(std::array<std::byte, Size> const&& temporary) = delete;

    /// The bytes, two for each register.
    [[nodiscard]] constexpr byte_view bytes() const noexcept { return bytes_; }

    friend constexpr bool operator==(register_view left, register_view right) noexcept
    {
        return detail::same_bytes(left.bytes_, right.bytes_);
    }

private:
    /// Four at once: compilers make one load, two shifts and one store of it.
    static constexpr void copy_four(std::byte const* from, std::uint16_t* to) noexcept
    {
        constexpr std::uint64_t low_bytes = 0x00FF'00FF'00FF'00FF;
        std::uint64_t const bytes = detail::word_at(from);
        std::uint64_t const words = (bytes & low_bytes) << 8U | (bytes >> 8U & low_bytes);
        auto const four = std::bit_cast<std::array<std::uint16_t, 4>>(words);
        to[0] = four[0];
        to[1] = four[1];
        to[2] = four[2];
        to[3] = four[3];
    }

    byte_view bytes_{};
};

/// `Count` registers in wire order, stored in place.
template <std::size_t Count> class register_block {
public:
    /// No registers.
    constexpr register_block() noexcept = default;

    /// One register for each value.
    template <std::convertible_to<std::uint16_t>... Values>
        requires(sizeof...(Values) == Count and Count > 0)
    constexpr register_block(Values... values) noexcept
    {
        byte_writer out{bytes_};
        (out.u16(static_cast<std::uint16_t>(values)), ...);
    }

    [[nodiscard]] static constexpr std::size_t size() noexcept { return Count; }

    /// The register at an index below `Count`; any other is misuse, as in a view.
    [[nodiscard]] constexpr std::uint16_t operator[](std::size_t index) const noexcept
    {
        detail::require_register(index, Count);
        return detail::u16_at(bytes_, index * 2);
    }

    /// Replaces the register at an index below `Count`; any other is misuse, as in a view.
    constexpr void set(std::size_t index, std::uint16_t value) noexcept
    {
        detail::require_register(index, Count);
        byte_writer{byte_span{bytes_}.subspan(index * 2, 2)}.u16(value);
    }

    /// The registers, valid while the block lives: a temporary block gives no view.
    [[nodiscard]] constexpr register_view view() const& noexcept { return register_view{bytes_}; }
    [[nodiscard]] register_view view() const&& = delete;
    constexpr operator register_view() const& noexcept { return view(); }
    operator register_view() const&& = delete;

    /// The bytes, two for each register, valid while the block lives.
    [[nodiscard]] constexpr byte_view bytes() const& noexcept { return bytes_; }
    [[nodiscard]] byte_view bytes() const&& = delete;

    friend constexpr bool operator==(register_block const&, register_block const&) = default;
    friend constexpr bool operator==(register_view left, register_block const& right) noexcept
    {
        return left == right.view();
    }

private:
    std::array<std::byte, Count * 2> bytes_{};
};

template <typename... Values> register_block(Values...) -> register_block<sizeof...(Values)>;

namespace detail {

/// The most bytes that a request's words can have, where its function allows `Most` registers. A request owns
/// its words, a `register_block`, or has a `register_view` of words that are stored elsewhere.
template <typename Words, std::size_t Most> inline constexpr std::size_t bytes_at_most = 2 * Most;
template <std::size_t Count, std::size_t Most>
inline constexpr std::size_t bytes_at_most<register_block<Count>, Most> = 2 * (Count < Most ? Count : Most);

/// The bytes that so many bits take.
[[nodiscard]] constexpr std::size_t bytes_of_bits(std::size_t count) noexcept { return (count + 7) / 8; }

/// The bit at an index of bytes in wire order; the caller has checked that it is there.
[[nodiscard]] constexpr bool bit_at(byte_view bytes, std::size_t index) noexcept
{
    return ((std::uint32_t{to_u8(bytes[index / 8])} >> (index % 8)) & 1U) != 0;
}

/// Sets that bit.
constexpr void put_bit(byte_span bytes, std::size_t index, bool value) noexcept
{
    std::byte const mask = to_byte(std::uint32_t{1} << (index % 8));
    bytes[index / 8] = value ? bytes[index / 8] | mask : bytes[index / 8] & ~mask;
}

/// Copies `count` bits from one place to another; the caller has checked that they are there.
constexpr void copy_bits(byte_span to, std::size_t to_at, byte_view from, std::size_t from_at,
                         std::size_t count) noexcept
{
    for (; count > 0; --count) {
        put_bit(to, to_at++, bit_at(from, from_at++));
    }
}

} // namespace detail

/// A view of bits; valid as long as its bytes.
class bit_view {
public:
    /// No bits.
    constexpr bit_view() noexcept = default;

    /// The first `count` bits of these bytes, or all of them where there are fewer.
    constexpr bit_view(byte_view bytes, std::size_t count) noexcept
        : bytes_{bytes}, count_{count < 8 * bytes.size() ? count : 8 * bytes.size()}
    {}

    [[nodiscard]] constexpr std::size_t size() const noexcept { return count_; }
    [[nodiscard]] constexpr bool empty() const noexcept { return count_ == 0; }

    /// The bit at an index below `size()`; any other index is misuse, as in a `register_view`.
    [[nodiscard]] constexpr bool operator[](std::size_t index) const noexcept
    {
        detail::require_register(index, count_);
        return detail::bit_at(bytes_, index);
    }

    /// The bytes that hold them.
    [[nodiscard]] constexpr byte_view bytes() const noexcept { return bytes_.first(detail::bytes_of_bits(count_)); }

    /// Whether they are the same bits, whatever stands behind the last one.
    friend constexpr bool operator==(bit_view left, bit_view right) noexcept
    {
        bool is_same = left.count_ == right.count_;
        for (std::size_t i = 0; is_same and i < left.count_; ++i) {
            is_same = detail::bit_at(left.bytes_, i) == detail::bit_at(right.bytes_, i);
        }
        return is_same;
    }

private:
    byte_view bytes_{};
    std::size_t count_{0};
};

/// `Count` bits in wire order, stored in place: `bit_block{true, false, true}`.
template <std::size_t Count> class bit_block {
public:
    /// No bits.
    constexpr bit_block() noexcept = default;

    /// One bit for each value.
    template <std::same_as<bool>... Values>
        requires(sizeof...(Values) == Count and Count > 0)
    constexpr bit_block(Values... values) noexcept
    {
        std::size_t index = 0;
        (detail::put_bit(bytes_, index++, values), ...);
    }

    [[nodiscard]] static constexpr std::size_t size() noexcept { return Count; }

    /// The bit at an index below `Count`; any other is misuse.
    [[nodiscard]] constexpr bool operator[](std::size_t index) const noexcept
    {
        detail::require_register(index, Count);
        return detail::bit_at(bytes_, index);
    }

    /// Replaces the bit at an index below `Count`; any other is misuse.
    constexpr void set(std::size_t index, bool value) noexcept
    {
        detail::require_register(index, Count);
        detail::put_bit(bytes_, index, value);
    }

    /// The bits, valid while the block lives: a temporary block gives no view.
    [[nodiscard]] constexpr bit_view view() const& noexcept { return {bytes_, Count}; }
    [[nodiscard]] bit_view view() const&& = delete;
    constexpr operator bit_view() const& noexcept { return view(); }
    operator bit_view() const&& = delete;

    /// The bytes that hold them, valid while the block lives.
    [[nodiscard]] constexpr byte_view bytes() const& noexcept { return bytes_; }
    [[nodiscard]] byte_view bytes() const&& = delete;

    friend constexpr bool operator==(bit_block const&, bit_block const&) = default;

private:
    std::array<std::byte, detail::bytes_of_bits(Count)> bytes_{};
};

template <std::same_as<bool>... Values> bit_block(Values...) -> bit_block<sizeof...(Values)>;

namespace detail {

/// Whether a run of `count` from `start` may be asked: `invalid_quantity`, `invalid_address_range` or none.
[[nodiscard]] constexpr errc check_run(std::uint16_t start, std::size_t count, std::size_t most) noexcept
{
    if (not is_quantity(count, most)) {
        return errc::invalid_quantity;
    }
    return is_address_range(start, count) ? errc::none : errc::invalid_address_range;
}

/// Whether a PDU is of this function and size: `wrong_function`, `wrong_length` or none.
[[nodiscard]] constexpr errc check_size(byte_view pdu, function_code code, std::size_t size) noexcept
{
    if (not is_pdu_of(pdu, code)) {
        return errc::wrong_function;
    }
    return pdu.size() == size ? errc::none : errc::wrong_length;
}

/// A decoded PDU, or what its own check finds.
template <typename Pdu> [[nodiscard]] constexpr result<Pdu> checked_pdu(Pdu const& read) noexcept
{
    if (errc const wrong = read.check(); wrong != errc::none) {
        return wrong;
    }
    return read;
}

/// Reads a request of two fields, a start and a quantity of 1..most. Errors: those of `check_size`, and
/// `invalid_quantity`.
template <typename Request> [[nodiscard]] constexpr result<Request> decode_run(byte_view pdu, std::size_t most) noexcept
{
    if (errc const wrong = check_size(pdu, Request::code, Request::max_size); wrong != errc::none) {
        return wrong;
    }
    std::uint16_t const count = u16_at(pdu, 3);
    if (not is_quantity(count, most)) {
        return errc::invalid_quantity;
    }
    return Request{u16_at(pdu, 1), count};
}

/// The bytes behind a byte count that is all there is: function, count, bytes. Errors: `wrong_function`, `wrong_length`.
[[nodiscard]] constexpr result<byte_view> decode_counted(byte_view pdu, function_code code) noexcept
{
    constexpr std::size_t head = 2;
    if (not is_pdu_of(pdu, code)) {
        return errc::wrong_function;
    }
    if (pdu.size() < head or pdu.size() != head + to_u8(pdu[1])) {
        return errc::wrong_length;
    }
    return byte_view{pdu.data() + head, pdu.size() - head};
}

/// Writes a function, a byte count and the bytes.
constexpr void write_counted(byte_writer& out, function_code code, byte_view bytes) noexcept
{
    out.u8(to_u8(code));
    out.u8(static_cast<std::uint32_t>(bytes.size()));
    out.bytes(bytes);
}

/// Decodes the response of function 03, 04 or 23 in a PDU: a byte count and as many bytes, two for each of 1..125
/// registers. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
template <typename Response>
[[nodiscard]] constexpr result<Response> decode_registers(byte_view pdu, function_code function) noexcept
{
    constexpr std::size_t head = 2;
    if (not is_pdu_of(pdu, function)) {
        return errc::wrong_function;
    }
    std::size_t const bytes = pdu.size() < head ? 1U : to_u8(pdu[1]);
    if (pdu.size() != head + bytes or bytes % 2 != 0) {
        return errc::wrong_length;
    }
    if (not is_quantity(bytes / 2, max_read_quantity)) {
        return errc::invalid_quantity;
    }
    return Response{register_view{byte_view{pdu.data() + head, bytes}}};
}

} // namespace detail

static_assert(max_exchange_read_quantity == max_read_quantity, "functions 03 and 23 read as many registers");

namespace detail {

/// A response to function 03, 04 or 23: 1 to 125 registers behind a byte count.
template <function_code Function> struct registers_response {
    static constexpr function_code code = Function;
    static constexpr std::size_t max_size = 2U + 2U * max_read_quantity;

    /// In wire order; after decoding, a view of the received bytes.
    register_view registers;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return is_quantity(registers.size(), max_read_quantity) ? errc::none : errc::invalid_quantity;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 2 + registers.bytes().size(); }
    constexpr void write(byte_writer& out) const noexcept { write_counted(out, code, registers.bytes()); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<registers_response> decode(byte_view pdu) noexcept
    {
        return decode_registers<registers_response>(pdu, code);
    }
};

/// A response to function 15 or 16: what was written where, without the values; at most `Most`.
template <function_code Function, std::uint16_t Most> struct written_run_response {
    static constexpr function_code code = Function;
    static constexpr std::size_t max_size = 5;

    std::uint16_t start;
    std::uint16_t count; ///< 1..Most

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return is_quantity(count, Most) ? errc::none : errc::invalid_quantity;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { write_head(out, code, start, count); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<written_run_response> decode(byte_view pdu) noexcept
    {
        return decode_run<written_run_response>(pdu, Most);
    }

    friend constexpr bool operator==(written_run_response const&, written_run_response const&) = default;
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
