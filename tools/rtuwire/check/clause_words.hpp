// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The words in which clauses say what is sent and what may come back.
//
//   A5           a byte; 5A*252 and (A5 5A)*3 repeat
//   U V          the unit that is checked, and an address that nobody has
//   R RI RC RD   addresses of a holding register, input register, coil and input that can be read; R+1
//   S SC SE      the first scratch register and coil, and the last scratch register
//   XA XC        the first register and coil behind the last that are there
//   PA PQ        address and quantity that are together the CRC of U, 03 and the address
//   READ         the plain read
//   CRC SWAP     the CRC of the frame so far; its bytes exchanged; CRC@V: as if the frame began with V; CRC(...): of others
//   !5^02        byte 5 of the frame is changed by exclusive or, after all else
//   ~1 ~200ms    a silence before the next byte, in characters or in time
//   ;            the next frame begins, without a wait
//   B(e)         a byte: a number, or 2*PQ, N-1, RN
//
// Answers also: `-` nothing, `any`, `??` any byte, OK1 and OK2 a normal response of one and two registers, ECHO what was sent,
// IDENT a response of function 43/14, TEXT a length and so many bytes, FIFO a response of function 24; alternatives by `or`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <rtuwire/frames.hpp>

namespace tool {

using line_bytes = std::vector<std::byte>;

/// Where the unit has what.
struct known_places {
    std::uint8_t unit{1};
    std::uint8_t other{247};
    std::byte read_function{3}; ///< of the plain read
    std::optional<std::uint16_t> holding{}, input{}, coil{}, discrete{};
    unsigned readable{1}; ///< registers from `holding` on
    std::optional<std::uint16_t> scratch{}, scratch_coil{};
    unsigned scratch_count{0};
    std::optional<std::uint16_t> behind_holding{}, behind_coil{};
    std::optional<std::uint16_t> crc_address{};
    std::uint16_t crc_quantity{0};
};

/// A place that is not known: its word.
struct unknown_place : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A silence, then bytes.
struct sent_piece {
    double characters{0}; ///< the silence in characters
    unsigned ms{0};       ///< or in time
    line_bytes bytes{};
};

std::vector<std::string_view> steps_of(std::string_view text);

/// What a step sends. Throws `unknown_place`.
std::vector<sent_piece> pieces_of(std::string_view step, known_places const& where);

/// All bytes of it, without the silences.
line_bytes bytes_of(std::vector<sent_piece> const& pieces);

/// Whether an answer is one of those that a step allows; `before` is the one of the step before it.
bool is_allowed(std::string_view answers, line_bytes const& came, line_bytes const& asked, line_bytes const& before,
                known_places const& where);

/// The plain read.
line_bytes plain_read(known_places const& where);

/// Two bytes, the low one first.
line_bytes crc_of(rtuwire::byte_view bytes);

/// With its CRC behind it.
line_bytes framed(line_bytes frame);

/// As a verdict shows it: "nothing", and no more than the first forty bytes.
std::string shown(line_bytes const& bytes);

/// Of a frame of four bytes or more.
bool has_right_crc(line_bytes const& frame);

} // namespace tool
