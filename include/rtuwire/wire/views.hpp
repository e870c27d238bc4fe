// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Registers and bits in wire order: views over received bytes, and storage for those to be sent. Both directions share
// one form, so values are not copied into an array of host words on the way. Of bits (AP 6.1) the first one is the
// lowest of the first byte, and what is left of the last byte is 0.
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

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
