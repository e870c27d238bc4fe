// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The frame of the serial line: unit, PDU, CRC (SL 2.5.1.1). Encodes any PDU into a caller's span or a value,
// and decodes a received frame after its size and CRC have been checked.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/crc16.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// What can be encoded: it checks that it is allowed on the wire, tells its length, and writes itself.
template <typename T>
concept pdu = requires(T const& value, byte_writer& out)
{
    {
        T::max_size
        } -> std::convertible_to<std::size_t>;
    {
        value.check()
        } -> std::same_as<errc>;
    {
        value.size()
        } -> std::same_as<std::size_t>;
    value.write(out);
};

/// A PDU that needs no response, only an effect, so that it may be broadcast.
template <typename T>
concept broadcastable = pdu<T> and T::may_be_broadcast;

/// A frame with room for the longest PDU of the type.
template <pdu Pdu> using frame_of = fixed_buffer<Pdu::max_size + adu_overhead>;

/// The PDU of a frame of at least 4 bytes.
[[nodiscard]] constexpr byte_view pdu_of(byte_view frame) noexcept
{
    // Not a subspan, which first checks whether its size means "all".
    return {frame.data() + 1, frame.size() - adu_overhead};
}

/// Whether the first `size` bytes of the response are those of the request.
[[nodiscard]] constexpr bool repeats(byte_view request_pdu, byte_view response_pdu, std::size_t size) noexcept
{
    return request_pdu.size() >= size and same_bytes(request_pdu.first(size), response_pdu.first(size));
}

} // namespace detail

/// A received frame whose CRC was right: a view of its bytes, valid as long as they are.
class adu {
public:
    /// From a frame that was checked, 4 bytes at least.
    explicit constexpr adu(byte_view frame) noexcept : bytes_{frame} {}

    /// All bytes, the CRC included.
    [[nodiscard]] constexpr byte_view bytes() const noexcept { return bytes_; }

    /// The unit address, 0 in a broadcast.
    [[nodiscard]] constexpr std::uint8_t unit() const noexcept { return detail::to_u8(bytes_[0]); }
    [[nodiscard]] constexpr byte_view pdu() const noexcept { return detail::pdu_of(bytes_); }

    /// The byte behind the unit address, exception bit included.
    [[nodiscard]] constexpr std::uint8_t wire_code() const noexcept { return detail::to_u8(bytes_[1]); }

    /// The function, exception bit removed.
    [[nodiscard]] constexpr function_code function() const noexcept
    {
        return static_cast<function_code>(wire_code() & ~detail::exception_bit & 0xFF);
    }

    [[nodiscard]] constexpr bool is_exception() const noexcept { return (wire_code() & detail::exception_bit) != 0; }

private:
    byte_view bytes_;
};

namespace detail {

/// Completes a frame whose unit byte and PDU are in `place` already: appends the CRC. `place` has room for
/// it.
constexpr byte_span append_crc(byte_span place, std::size_t pdu_size) noexcept
{
    std::size_t const end = 1 + pdu_size;
    std::uint16_t const crc = crc16(place.first(end));
    place[end] = to_byte(crc);
    place[end + 1] = to_byte(std::uint32_t{crc} >> 8U);
    return place.first(end + 2);
}

/// Writes unit, PDU and CRC into `out`, without checking that this request may go to the unit. Returns the
/// part of `out` written. Errors: what the PDU's own check finds, or `buffer_too_small`; `out` is then
/// unchanged.
template <pdu Pdu>
[[nodiscard]] constexpr result<byte_span> encode_adu(byte_span out, std::uint8_t unit, Pdu const& value) noexcept
{
    if (errc const wrong = value.check(); wrong != errc::none) {
        return wrong;
    }
    std::size_t const size = value.size() + adu_overhead;
    if (size > out.size()) {
        return errc::buffer_too_small;
    }
    byte_writer writer{out.first(size)};
    writer.u8(unit);
    value.write(writer);
    return append_crc(out, size - adu_overhead);
}

} // namespace detail

/// Writes the frame of a request or response of one unit into `out`; returns the part written.
template <detail::pdu Pdu>
[[nodiscard]] constexpr result<byte_span> encode_into(byte_span out, unit_id unit, Pdu const& value) noexcept
{
    return detail::encode_adu(out, unit.byte(), value);
}

/// Writes the frame of a request to one unit, or of a broadcast, into `out`; returns the part written.
template <detail::broadcastable Pdu>
[[nodiscard]] constexpr result<byte_span> encode_into(byte_span out, detail::destination to, Pdu const& value) noexcept
{
    return detail::encode_adu(out, to.byte(), value);
}

/// Writes the frame of a request to the only unit of a line, at address 0, into `out`; returns the part written.
template <detail::pdu Pdu>
    requires(not detail::broadcastable<Pdu>)
[[nodiscard]] constexpr result<byte_span> encode_into(byte_span out, detail::only_unit_t, Pdu const& value) noexcept
{
    return detail::encode_adu(out, 0, value);
}

/// The frame of a request or response, as a value. Store it in a variable before taking a view of its bytes.
/// A request that needs a response cannot be broadcast: that does not compile.
template <typename To, detail::pdu Pdu>
[[nodiscard]] constexpr result<detail::frame_of<Pdu>> encode(To to, Pdu const& value) noexcept
{
    constexpr bool is_of_one = std::same_as<To, unit_id> or std::same_as<To, detail::only_unit_t>;
    static_assert(is_of_one or detail::broadcastable<Pdu>,
                  "a broadcast has no response, so only a write can be broadcast");
    detail::frame_of<Pdu> frame;
    auto const written = encode_into(frame.storage(), to, value);
    if (not written) {
        return written.error();
    }
    frame.resize(written->size());
    return frame;
}

/// A frame known at compile time, as an array of exactly its size. `Make` is a lambda that encodes it:
/// `constant_frame([] { return encode(one, write_multiple_registers{8501, words}); })`. A frame that cannot
/// be encoded does not compile.
template <typename Make> [[nodiscard]] consteval auto constant_frame(Make) noexcept
{
    constexpr auto made = Make{}();
    static_assert(made.has_value(), "this frame cannot be encoded");
    std::array<std::byte, made->size()> frame{};
    for (std::size_t i = 0; i < frame.size(); ++i) {
        frame[i] = made->view()[i];
    }
    return frame;
}

/// Whether a received frame is complete: `frame_too_short`, `frame_too_long`, `crc_mismatch` or none.
[[nodiscard]] constexpr errc check_frame(byte_view frame) noexcept
{
    if (frame.size() < min_adu_size) {
        return errc::frame_too_short;
    }
    if (frame.size() > max_adu_size) {
        return errc::frame_too_long;
    }
    return crc16(frame) == 0 ? errc::none : errc::crc_mismatch;
}

/// Decodes a received frame. Errors: those of `check_frame`.
[[nodiscard]] constexpr result<adu> decode_adu(byte_view frame) noexcept
{
    if (errc const wrong = check_frame(frame); wrong != errc::none) {
        return wrong;
    }
    return adu{frame};
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
