// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which answers belong to a request, and how long they get: a model from the tables of the Modbus specification.
// Shares no code with the headers.
#pragma once

#include "model_line.hpp"

namespace model {

inline std::size_t word_at(bytes const& frame, std::size_t at)
{
    return frame.size() >= at + 2 ? frame[at] * 256U + frame[at + 1] : 0U;
}

/// Whether a response has the size that its own bytes tell, where they tell one. A page of identification that ends
/// before they do has not.
inline bool matches_size_hint(bytes const& frame)
{
    if (auto const told = size_hint(frame, false)) {
        return *told == frame.size();
    }
    return frame.size() < 3 or frame[1] != 43 or frame[2] != 14;
}

/// The longest response to a request, and whether its own bytes tell its end.
struct response_size {
    std::size_t bytes;
    bool is_final;
};
/// Whether any response to a request tells its size.
inline bool tells_size(bytes const& request)
{
    unsigned const function = request[1];
    bool const is_listed = function <= 7 or function == 11 or function == 12 or (function >= 15 and function <= 17) or
                           (function >= 20 and function <= 24);
    return is_listed or (function == 43 and request.size() > 4 and request[2] == 14);
}
inline response_size longest_response(bytes const& request)
{
    std::size_t const size = request.size();
    std::size_t const quantity = size < 8 ? 0xFFFF : word_at(request, 4);
    auto const counted = [](bool is_allowed, std::size_t data) {
        return response_size{is_allowed ? 5 + data : 256, true};
    };
    switch (request[1]) {
    case 1:
    case 2: return counted(quantity <= 2000, (quantity + 7) / 8);
    case 3:
    case 4:
    case 23: return counted(quantity <= 125, 2 * quantity);
    case 5:
    case 6:
    case 11:
    case 15:
    case 16: return {8, true};
    case 7: return {5, true};
    case 20: return counted(size == 12 and word_at(request, 8) <= 121, 2 + 2 * word_at(request, 8));
    case 21: return {size, true};
    case 22: return {10, true};
    case 8: return word_at(request, 2) == 0 ? response_size{size, false} : response_size{8, true};
    default: return {256, tells_size(request)};
    }
}

/// Whether a diagnostic answers what it was asked, and no number of its own.
constexpr bool is_repeated(std::size_t diagnostic)
{
    return diagnostic <= 1 or diagnostic == 3 or diagnostic == 0x0A or diagnostic == 0x14;
}

/// A page of identification: the type and the code are repeated, the objects rise and fill the frame, and where one was asked
/// for it is that one.
inline fault check_page(bytes const& request, bytes const& frame)
{
    if (request.size() != 7 or request[2] != 14) {
        return none;
    }
    std::size_t const body = frame.size() - 2;
    if (body < 8) {
        return wrong_length;
    }
    bool const is_marked = frame[5] == 0 or frame[5] == 0xFF;
    if (frame[2] != 14 or not is_marked or frame[7] == 0) {
        return malformed;
    }
    std::size_t at = 8;
    int before = -1;
    for (unsigned left = frame[7]; left > 0; --left) {
        if (body < at + 2 or frame[at] <= before) {
            return malformed;
        }
        before = frame[at];
        at += 2U + frame[at + 1];
    }
    if (at != body) {
        return malformed;
    }
    if (frame[3] != request[3]) {
        return response_mismatch;
    }
    if (request[3] == 4 and (frame[7] != 1 or frame[8] != request[4])) {
        return response_mismatch;
    }
    return none;
}

/// Whether a response is never its request.
constexpr bool is_never_repeated(unsigned function, unsigned third_byte)
{
    switch (function) {
    case 43: return third_byte == 14;
    case 5:
    case 6:
    case 8:
    case 21:
    case 22: return false;
    case 20:
    case 23:
    case 24: return true;
    default:
        return function <= 4 or function == 7 or function == 11 or function == 12 or
               (function >= 15 and function <= 17);
    }
}

/// Why a frame with a right CRC is not the response to a request; none where it is, an exception's number where the
/// unit refused.
inline fault check_response(bytes const& request, bytes const& frame)
{
    auto const same = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            if (i >= request.size() - 2 or i >= frame.size() - 2 or request[i] != frame[i]) {
                return false;
            }
        }
        return true;
    };
    if (frame[0] != request[0]) {
        return wrong_unit;
    }
    if (frame[1] == (request[1] | 0x80)) {
        if (frame.size() != 5) {
            return wrong_length;
        }
        unsigned const code = frame[2];
        return code == 0 or code >= 0x80 ? unlisted_exception : static_cast<fault>(code);
    }
    if (frame[1] != request[1]) {
        return wrong_function;
    }
    unsigned const function = request[1];
    bool const is_itself = frame == request;
    if (is_itself and is_never_repeated(function, request[2])) {
        return line_echo;
    }
    auto const counted = [&](std::size_t data) {
        return frame.size() != 5 + data or frame[2] != data ? wrong_length : none;
    };
    switch (function) {
    case 1:
    case 2: return counted((word_at(request, 4) + 7) / 8);
    case 3:
    case 4:
    case 23: return counted(2 * word_at(request, 4));
    case 6:
    case 21:
    case 22:
        if (frame.size() != request.size()) {
            return wrong_length;
        }
        return is_itself ? none : response_mismatch;
    case 5:
    case 15:
    case 16:
        if (frame.size() != 8) {
            return wrong_length;
        }
        return same(2, 6) ? none : response_mismatch;
    case 8:
        if (frame.size() != request.size()) {
            return wrong_length;
        }
        return is_itself or (not is_repeated(word_at(request, 2)) and same(2, 4)) ? none : response_mismatch;
    case 43: return check_page(request, frame);
    default: return none;
    }
}

} // namespace model
