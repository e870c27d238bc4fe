// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The frame of the serial line: unit, PDU, CRC (SL 2.5.1.1). Encodes any PDU into a caller's span or
// a value, and takes a received frame apart after its size and CRC have been checked.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/crc16.hpp>
#include <rtuwire/core/fixed_buffer.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/limits.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// What can be encoded: it says whether it is allowed on the wire, how long it is, and writes itself.
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

/// A PDU that asks for nothing but an effect, so that it may be sent to everyone.
template <typename T>
concept broadcastable = pdu<T> and T::may_be_broadcast;

/// A frame of at most as many octets as the PDU type can need.
template <pdu P> using frame_of = fixed_buffer<P::max_size + adu_overhead>;

/// The PDU of a frame, which has at least 4 octets.
[[nodiscard]] constexpr byte_view pdu_of(byte_view frame) noexcept
{
    // Not a subspan, which asks first whether its size means "all".
    return {frame.data() + 1, frame.size() - adu_overhead};
}

/// A received frame whose CRC was right: a view of its octets, valid as long as they are.
class adu {
public:
    /// Of a frame that was checked, 4 octets at least.
    explicit constexpr adu(byte_view frame) noexcept : octets_{frame} {}

    /// All of them, the CRC included.
    [[nodiscard]] constexpr byte_view octets() const noexcept { return octets_; }

    /// The unit address, 0 for everyone.
    [[nodiscard]] constexpr std::uint8_t unit() const noexcept { return to_u8(octets_[0]); }
    [[nodiscard]] constexpr byte_view pdu() const noexcept { return pdu_of(octets_); }

    /// The octet behind the unit address, exception bit included.
    [[nodiscard]] constexpr std::uint8_t wire_code() const noexcept { return to_u8(octets_[1]); }

    /// The function, exception bit removed.
    [[nodiscard]] constexpr function_code function() const noexcept
    {
        return static_cast<function_code>(wire_code() & ~exception_bit & 0xFF);
    }

    [[nodiscard]] constexpr bool is_exception() const noexcept
    {
        return (wire_code() & exception_bit) != 0;
    }

private:
    byte_view octets_;
};

/// Makes a frame of a unit's octet and a PDU that are there already: appends the CRC. `place` has room
/// for it.
constexpr byte_span seal(byte_span place, std::size_t pdu_size) noexcept
{
    std::size_t const end = 1 + pdu_size;
    std::uint16_t const crc = crc16(place.first(end));
    place[end] = to_byte(crc);
    place[end + 1] = to_byte(std::uint32_t{crc} >> 8U);
    return place.first(end + 2);
}

/// Writes unit, PDU and CRC into `out`, without checking that the unit may be asked this. Returns the
/// part of `out` written. Errors: what the PDU finds wrong with itself, or `buffer_too_small`; `out`
/// is then untouched.
template <pdu P>
[[nodiscard]] constexpr result<byte_span> encode_adu(byte_span out, std::uint8_t unit,
                                                     P const& value) noexcept
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
    return seal(out, size - adu_overhead);
}

/// Writes the frame of a request or response of one unit into `out`; returns the part written.
template <pdu P>
[[nodiscard]] constexpr result<byte_span> encode_into(byte_span out, unit_id unit,
                                                      P const& value) noexcept
{
    return encode_adu(out, unit.octet(), value);
}

/// Writes the frame of a request to one unit or to everyone into `out`; returns the part written.
template <broadcastable P>
[[nodiscard]] constexpr result<byte_span> encode_into(byte_span out, destination to,
                                                      P const& value) noexcept
{
    return encode_adu(out, to.octet(), value);
}

/// The frame of a request or response, as a value. It needs a name before it gives a view of its octets. A
/// question cannot be sent to everyone: that does not compile.
template <typename To, pdu P>
[[nodiscard]] constexpr result<frame_of<P>> encode(To to, P const& value) noexcept
{
    static_assert(std::same_as<To, unit_id> or broadcastable<P>,
                  "a broadcast has no answer, so only a write can be broadcast");
    frame_of<P> frame;
    auto const written = encode_into(frame.storage(), to, value);
    if (not written) {
        return written.error();
    }
    frame.resize(written->size());
    return frame;
}

/// A frame that is known when compiling, as an array of exactly its size. `Make` is a lambda that
/// encodes it: `constant_frame([] { return encode(one, write_multiple_registers{8501, words}); })`. One
/// that cannot be encoded does not compile.
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

/// Whether a received frame is whole: `frame_too_short`, `frame_too_long`, `crc_mismatch` or none.
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

/// Takes a received frame apart. Errors: those of `check_frame`.
[[nodiscard]] constexpr result<adu> decode_adu(byte_view frame) noexcept
{
    if (errc const wrong = check_frame(frame); wrong != errc::none) {
        return wrong;
    }
    return adu{frame};
}

} // namespace rtuwire
