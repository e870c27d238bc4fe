// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Whether a frame answers a question. RTU frames carry no transaction number, so everything that the
// answer repeats is held against the octets that were asked: unit, function, byte count, address,
// quantity and value.
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/frame_length.hpp>
#include <rtuwire/wire/pdu/device_identification.hpp>
#include <rtuwire/wire/pdu/diagnostics.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Whether the first octets of the answer, which has so many, are those of the question.
[[nodiscard]] constexpr bool repeats(byte_view question_pdu, byte_view answer_pdu,
                                     std::size_t size) noexcept
{
    return question_pdu.size() >= size and
           same_bytes(question_pdu.first(size), answer_pdu.first(size));
}

/// The size of the longest answer to a question, an ADU; final where its octets tell its end, so that it needs
/// no silence behind it. Where the question does not tell the size it is the largest possible.
[[nodiscard]] constexpr length_so_far longest_answer(byte_view question_adu) noexcept
{
    std::uint8_t const code = to_u8(question_adu[1]);
    std::uint8_t const rule = length_rules::of(direction::response, code);
    auto const kind = static_cast<length_rule>(rule & length_rules::kind_bits);
    std::size_t size = max_adu_size;
    bool tells_end = kind != length_rule::none;
    if (kind == length_rule::fixed) {
        size = rule & ~length_rules::kind_bits & 0xFF;
    } else if (kind == length_rule::subfunction) {
        size = question_adu.size();
        tells_end = u16_at(question_adu, 2) != 0;
    } else if (kind == length_rule::mei) {
        tells_end = to_u8(question_adu[2]) == identification_mei_type;
    } else if (question_adu.size() >= 8 and
               (code == to_u8(function_code::read_holding_registers) or
                code == to_u8(function_code::read_write_multiple_registers))) {
        std::size_t const told = 5U + 2U * u16_at(question_adu, 4);
        size = told < max_adu_size ? told : max_adu_size;
    }
    return {size, tells_end};
}

/// Its size alone.
[[nodiscard]] constexpr std::size_t answer_size(byte_view question_adu) noexcept
{
    return longest_answer(question_adu).size();
}

/// Holds a page of identification against its question.
[[nodiscard]] constexpr errc check_identification(byte_view question_pdu,
                                                  byte_view answer_pdu) noexcept
{
    constexpr std::size_t count_at = 6;
    constexpr std::size_t first_id_at = device_identification::head_size;
    if (errc const wrong = device_identification::check_page(answer_pdu); wrong != errc::none) {
        return wrong;
    }
    // A stream may start elsewhere than it was asked to; a single object is the one asked for.
    bool const is_single =
        to_u8(question_pdu[2]) == static_cast<std::uint8_t>(identification_access::single);
    bool const is_other = question_pdu[2] != answer_pdu[2] or
                          (is_single and (to_u8(answer_pdu[count_at]) != 1 or
                                          answer_pdu[first_id_at] != question_pdu[3]));
    return is_other ? errc::wrong_echo : errc::none;
}

/// Holds the fields of a normal answer against its question; both PDUs are of one function. Part of
/// `check_answer`, and smaller there than apart.
[[nodiscard, gnu::always_inline]] constexpr errc check_fields(byte_view question_pdu,
                                                              byte_view answer_pdu) noexcept
{
    // A raw question may be shorter than its function allows; then there is nothing to hold against.
    if (question_pdu.size() < read_device_identification::max_size) {
        return errc::none;
    }
    std::size_t size = 5;    // of the answer
    std::size_t same = size; // octets that are those of the question
    switch (static_cast<function_code>(to_u8(question_pdu[0]))) {
    case function_code::read_holding_registers:
    case function_code::read_write_multiple_registers: {
        std::size_t const octets = question_pdu.size() < 5 ? 0U : 2U * u16_at(question_pdu, 3);
        bool const fits = answer_pdu.size() == 2 + octets and to_u8(answer_pdu[1]) == octets;
        return fits ? errc::none : errc::wrong_length;
    }
    case function_code::write_single_register:
    case function_code::write_multiple_registers: break;
    case function_code::diagnostics:
        size = question_pdu.size();
        same = repeats_data(static_cast<subfunction>(u16_at(question_pdu, 1))) ? size : 3;
        break;
    case function_code::encapsulated_interface:
        return to_u8(question_pdu[1]) == identification_mei_type
                   ? check_identification(question_pdu, answer_pdu)
                   : errc::none;
    default: return errc::none;
    }
    if (answer_pdu.size() != size) {
        return errc::wrong_length;
    }
    return repeats(question_pdu, answer_pdu, same) ? errc::none : errc::wrong_echo;
}

/// Whether `answer`, whose CRC was right, answers the question in `question_adu`, a frame that was
/// encoded here. The error is the exception when the server refused; `echoed` when it is the question
/// itself; `wrong_unit`, `wrong_function`, `wrong_length`, `wrong_echo` or `malformed` when this is no
/// answer to it.
[[nodiscard]] constexpr errc check_answer(byte_view const& question_adu, adu const& answer) noexcept
{
    if (answer.unit() != to_u8(question_adu[0])) {
        return errc::wrong_unit;
    }
    byte_view const question_pdu = pdu_of(question_adu);
    byte_view const answer_pdu = answer.pdu();
    if (to_u8(answer.function()) != to_u8(question_pdu[0])) {
        return errc::wrong_function;
    }
    if (answer.is_exception()) {
        return answer_pdu.size() == 2 ? exception_error(to_u8(answer_pdu[1])) : errc::wrong_length;
    }
    errc const wrong = check_fields(question_pdu, answer_pdu);
    bool const is_own = wrong != errc::none and same_bytes(question_adu, answer.octets());
    return is_own ? errc::echoed : wrong;
}

} // namespace rtuwire
