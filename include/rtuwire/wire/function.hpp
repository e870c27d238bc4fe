// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function codes, sets of them, and what a function says of its frames: how their sizes follow from their bytes, and
// which fields of a response repeat those of its request. Each function's class gives its rules; the tables in
// functions.hpp are made of them. And the sizes and quantities of the specifications, each with the clause it comes from:
// AP is Modbus Application Protocol V1.1b3, SL is Modbus over Serial Line V1.02.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

inline constexpr std::size_t min_adu_size = 4;   ///< unit, function, CRC (SL 2.5.1.1)
inline constexpr std::size_t max_adu_size = 256; ///< SL 2.5.1.1
inline constexpr std::size_t max_pdu_size = 253; ///< AP 4.1

namespace detail {

inline constexpr std::size_t adu_overhead = 3;       ///< unit in front, two bytes of CRC behind
inline constexpr std::size_t exception_adu_size = 5; ///< AP 7

} // namespace detail

inline constexpr std::uint16_t max_bit_quantity = 2000;           ///< AP 6.1, 6.2
inline constexpr std::uint16_t max_bit_write_quantity = 1968;     ///< AP 6.11
inline constexpr std::uint16_t max_read_quantity = 125;           ///< AP 6.3
inline constexpr std::uint16_t max_write_quantity = 123;          ///< AP 6.12
inline constexpr std::uint16_t max_exchange_read_quantity = 125;  ///< AP 6.17
inline constexpr std::uint16_t max_exchange_write_quantity = 121; ///< AP 6.17

/// How many registers a device accepts in one request, by direction; the specification's limits unless its
/// manual says less. Zero means that the device lacks the function.
struct device_limits {
    std::uint16_t read{max_read_quantity};                     ///< function 03
    std::uint16_t write{max_write_quantity};                   ///< function 16
    std::uint16_t exchange_read{max_exchange_read_quantity};   ///< function 23, read half
    std::uint16_t exchange_write{max_exchange_write_quantity}; ///< function 23, write half

    friend constexpr bool operator==(device_limits const&, device_limits const&) = default;
};

namespace detail {

/// Whether a quantity lies in 1..limit.
[[nodiscard]] constexpr bool is_quantity(std::size_t quantity, std::size_t limit) noexcept
{
    return quantity - 1U < limit; // 0 wraps: one comparison
}

/// Whether `quantity` registers from `start` end at 65535 or before; computed in 32 bits, so that
/// no sum wraps.
[[nodiscard]] constexpr bool is_address_range(std::uint16_t start, std::size_t quantity) noexcept
{
    return quantity <= 0x1'0000U - std::uint32_t{start};
}

} // namespace detail

/// A function code (AP 5.1). Any code in 1..127 is possible; the public ones have names.
enum class function_code : std::uint8_t {
    read_coils = 1,
    read_discrete_inputs = 2,
    read_holding_registers = 3,
    read_input_registers = 4,
    write_single_coil = 5,
    write_single_register = 6,
    read_exception_status = 7,
    diagnostics = 8,
    get_comm_event_counter = 11,
    get_comm_event_log = 12,
    write_multiple_coils = 15,
    write_multiple_registers = 16,
    report_server_id = 17,
    read_file_record = 20,
    write_file_record = 21,
    mask_write_register = 22,
    read_write_multiple_registers = 23,
    read_fifo_queue = 24,
    encapsulated_interface = 43,
};

namespace detail {

/// The bit that marks an exception response (AP 7).
inline constexpr std::uint8_t exception_bit = 0x80;

/// A code as it stands on the wire.
[[nodiscard]] constexpr std::uint8_t to_u8(function_code code) noexcept { return static_cast<std::uint8_t>(code); }

/// Whether a PDU is a request or normal response of a function.
[[nodiscard]] constexpr bool is_pdu_of(byte_view pdu, function_code code) noexcept
{
    return not pdu.empty() and to_u8(pdu[0]) == to_u8(code);
}

/// Writes a function and its first two fields: what most requests begin with.
constexpr void write_head(byte_writer& out, function_code code, std::uint32_t first, std::uint32_t second) noexcept
{
    constexpr std::size_t size = 5;
    if (std::byte* const at = out.take(size); at != nullptr) {
        at[0] = to_byte(to_u8(code));
        put_u16(at + 1, static_cast<std::uint16_t>(first));
        put_u16(at + 3, static_cast<std::uint16_t>(second));
    }
}

} // namespace detail

/// A set of function codes, in 16 bytes.
class function_set {
public:
    /// The set of the codes given; codes outside 1..127 are never members.
    template <typename... Codes> explicit constexpr function_set(Codes... codes) noexcept { (add(codes), ...); }

    [[nodiscard]] constexpr bool contains(function_code code) const noexcept
    {
        auto const number = detail::to_u8(code);
        return number < 0x80 and ((words_[number / 32U] >> (number % 32U)) & 1U) != 0;
    }

    /// Whether all functions of another set are members.
    [[nodiscard]] constexpr bool contains_all(function_set const& others) const noexcept
    {
        std::uint32_t missing = 0;
        for (std::size_t i = 0; i < words_.size(); ++i) {
            missing |= others.words_[i] & ~words_[i];
        }
        return missing == 0;
    }

    friend constexpr bool operator==(function_set const&, function_set const&) = default;

private:
    constexpr void add(function_code code) noexcept
    {
        auto const number = detail::to_u8(code);
        if (number > 0 and number < 0x80) {
            words_[number / 32U] |= std::uint32_t{1} << (number % 32U);
        }
    }

    std::array<std::uint32_t, 4> words_{};
};

namespace detail {

/// Which way a frame travels.
enum class direction : std::uint8_t { request, response };

/// How the size of an ADU follows from its bytes.
enum class length_rule : std::uint8_t {
    none = 0x00,        ///< only silence ends it
    fixed = 0x20,       ///< as many bytes as its size says
    byte_count = 0x40,  ///< its size, and as many as its last byte before the CRC says
    word_count = 0x60,  ///< the same with the last two bytes, big-endian
    subfunction = 0x80, ///< function 08: its size, but silence for sub-function 0
    own = 0xA0,         ///< the function has a `length` of its own
};

/// The bits of a rule that tell its kind; the others are its size, up to 31.
inline constexpr std::uint8_t length_rule_bits = 0xE0;

/// A rule with its size, CRC included, in one byte.
[[nodiscard]] constexpr std::uint8_t sized(length_rule counts, unsigned size = 0) noexcept
{
    return static_cast<std::uint8_t>(static_cast<unsigned>(counts) | size);
}

/// The size of a rule.
[[nodiscard]] constexpr std::size_t size_in(std::uint8_t rule) noexcept
{
    return rule & ~std::uint32_t{length_rule_bits} & 0xFFU;
}

/// What a normal response has in common with its request.
enum class answer_rule : std::uint8_t {
    unknown,   ///< of a function that is not in the list: it may even be the request
    head,      ///< it is the first five bytes of the request
    whole,     ///< it is the request
    partly,    ///< it has the request's size, and repeats as many bytes as the function's `repeated` says
    own,       ///< the function has a `check_response` of its own
    registers, ///< two bytes for each of the registers that the request's second field counts
    bits,      ///< a byte for each eight of the bits that it counts
    nothing,   ///< nothing but the function; it is never the request
};

/// The rules of one function.
struct frame_rules {
    std::uint8_t request;
    std::uint8_t response;
    answer_rule answers;
};

/// A request says itself whether a response fits it.
template <typename Request>
concept has_response_check = requires(byte_view bytes)
{
    {
        Request::check_response(bytes, bytes)
        } -> std::same_as<errc>;
};

/// A function, by its row, that knows more of its response than the client compares: its conversation asks `check_response` of
/// it.
template <typename Row>
concept checks_response = has_response_check<Row> and not requires
{
    requires Row::rules.answers == answer_rule::own;
};

/// What a rule says of a size, before one above 256 is refused. Two members: the size may be more than fits
/// `length_hint`, and a caller that needs only one need not have the other.
struct raw_length {
    std::size_t size{0};
    bool is_final{false};
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
