// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Frames as the simulated world makes and reads them: its own bytes and its own CRC, so that nothing here
// agrees with the library by construction.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace rtuwire::simulation {

/// Microseconds since the simulation began; never wraps.
using moment = std::uint64_t;
inline constexpr moment never = ~moment{0};

using bytes_view = std::span<std::byte const>;

/// CRC-16/MODBUS, bit by bit for the table.
inline std::uint16_t crc_of(bytes_view bytes)
{
    static auto const table = [] {
        std::array<std::uint16_t, 256> made{};
        for (unsigned i = 0; i < made.size(); ++i) {
            unsigned value = i;
            for (int bit = 0; bit < 8; ++bit) {
                value = (value & 1U) != 0 ? value >> 1U ^ 0xA001U : value >> 1U;
            }
            made[i] = static_cast<std::uint16_t>(value);
        }
        return made;
    }();
    unsigned crc = 0xFFFF;
    for (std::byte const each : bytes) {
        crc = crc >> 8U ^ table[(crc ^ static_cast<unsigned>(each)) & 0xFFU];
    }
    return static_cast<std::uint16_t>(crc);
}

/// A frame and its size.
class frame {
public:
    frame() = default;
    frame(std::uint8_t unit, std::uint8_t function)
    {
        byte(unit);
        byte(function);
    }
    frame(frame const& other) { *this = other; }
    frame& operator=(frame const& other)
    {
        size_ = other.size_;
        std::memcpy(bytes_.data(), other.bytes_.data(), size_);
        return *this;
    }

    frame& byte(unsigned value)
    {
        bytes_[size_++] = static_cast<std::byte>(value);
        return *this;
    }
    frame& word(unsigned value) { return byte(value >> 8U & 0xFFU).byte(value & 0xFFU); }

    /// Appends the CRC.
    frame& close()
    {
        unsigned const crc = crc_of(view());
        return byte(crc & 0xFFU).byte(crc >> 8U);
    }

    void assign(bytes_view bytes)
    {
        size_ = 0;
        for (std::byte const each : bytes) {
            bytes_[size_++] = each;
        }
    }
    void fill(std::byte value) { bytes_.fill(value); }

    bytes_view view() const { return {bytes_.data(), size_}; }
    std::size_t size() const { return size_; }
    std::uint8_t operator[](std::size_t i) const { return static_cast<std::uint8_t>(bytes_[i]); }
    unsigned word_at(std::size_t i) const { return (*this)[i] * 256U + (*this)[i + 1]; }
    std::byte& raw(std::size_t i) { return bytes_[i]; }

private:
    std::size_t size_{0};
    std::array<std::byte, 256> bytes_;
};

inline bool same(bytes_view left, bytes_view right)
{
    return left.size() == right.size() and (left.empty() or std::memcmp(left.data(), right.data(), left.size()) == 0);
}

/// What a register holds at the time of a transmission: the first two words of a read are the
/// transmission's number, the others follow from it.
inline std::uint16_t word_of(std::uint32_t transmission, std::size_t index)
{
    if (index < 2) {
        return static_cast<std::uint16_t>(index == 0 ? transmission >> 16U : transmission);
    }
    std::uint32_t mixed = (transmission + static_cast<std::uint32_t>(index) * 0x10001U) * 0x9E37'79B1U;
    mixed ^= mixed >> 15U;
    return static_cast<std::uint16_t>(mixed * 0x85EB'CA77U >> 16U);
}

/// How many registers a request reads; 0 where it reads none.
inline unsigned read_count_of(frame const& request)
{
    return request[1] == 3 or request[1] == 23 ? request.word_at(4) : 0U;
}

/// How long the response to a request is (AP 6).
inline std::size_t response_size(frame const& request)
{
    switch (request[1]) {
    case 3:
    case 23: return 5 + 2U * read_count_of(request);
    case 8: return request.size();
    default: return 8;
    }
}

/// The response of a unit that answers one transmission of a request.
inline frame response_to(frame const& request, std::uint32_t transmission)
{
    frame made{request[0], request[1]};
    if (unsigned const count = read_count_of(request); count > 0) {
        made.byte(2 * count);
        for (unsigned i = 0; i < count; ++i) {
            made.word(word_of(transmission, i));
        }
    } else {
        std::size_t const end = request[1] == 8 ? request.size() - 2 : 6;
        for (std::size_t i = 2; i < end; ++i) {
            made.byte(request[i]);
        }
    }
    return made.close();
}

inline frame exception_to(frame const& request, unsigned code)
{
    return frame{request[0], static_cast<std::uint8_t>(request[1] | 0x80U)}.byte(code).close();
}

/// Whether a response could be one to this request by all that it repeats (AP 6, 7).
inline bool could_response(frame const& request, frame const& response)
{
    if (response[0] != request[0] or (response[1] & 0x7FU) != request[1]) {
        return false;
    }
    if (response[1] != request[1]) {
        return response.size() == 5;
    }
    if (response.size() != response_size(request)) {
        return false;
    }
    if (read_count_of(request) > 0) {
        return response[2] == 2 * read_count_of(request);
    }
    std::size_t const repeated = request[1] == 8 ? request.size() - 2 : 6;
    return same(request.view().first(repeated), response.view().first(repeated));
}

} // namespace rtuwire::simulation
