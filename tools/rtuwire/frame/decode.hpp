// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Bytes of a line, explained: the frames in them, what each may be, and all of its fields.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rtuwire/frames.hpp>
#include <rtuwire/trace.hpp>

#include "frame/frame_fields.hpp"
#include "frame/frame_split.hpp"
#include "frame/known_units.hpp"

namespace tool {

/// A frame as a request or as a response.
struct frame_reading {
    std::string as;                    ///< "request", "response", "request or response"
    std::vector<frame_field> fields{}; ///< from the unit to the CRC
    std::string flaw{};                ///< what is wrong with the fields; empty where nothing is
};

struct decoded_frame {
    std::size_t offset; ///< from the start of the run
    std::vector<std::byte> bytes;
    bool has_right_crc;
    bool is_whole; ///< its length is what its fields say
    /// One that is certain, or all that are possible.
    std::vector<frame_reading> readings{};
    bool is_damaged{false}; ///< a wrong CRC, and no other protocol: `cause_of_damage` may know more

    bool is_good() const { return has_right_crc and is_whole; }
};

/// Explains runs of bytes in the order in which they passed.
class frame_decoder {
public:
    /// What the registers of each unit are called.
    explicit frame_decoder(known_units units) : units_{std::move(units)} {}

    /// The next frame answers this request; where that is empty, none that is known.
    void expect_answer_to(rtuwire::byte_view request);

    /// All frames of a run, one after the other. The response that follows its request is known as that, and the
    /// addresses of its registers with it.
    [[nodiscard]] std::vector<decoded_frame> decode(rtuwire::byte_view run);
    /// One frame of which it is known what it is, right or not.
    [[nodiscard]] decoded_frame decode_as(rtuwire::byte_view frame, rtuwire::frame_role role);

private:
    /// What the last frame asked for, by a request that reads.
    struct question {
        std::byte unit;
        std::byte function;
        asked_run run;
    };

    [[nodiscard]] decoded_frame explain(rtuwire::byte_view bytes, frame_piece const& piece);
    [[nodiscard]] decoded_frame explain_other_protocol(rtuwire::byte_view bytes, frame_piece const& piece) const;
    [[nodiscard]] bool is_answer(rtuwire::byte_view frame) const;
    void remember(rtuwire::byte_view frame);
    void add_readings(decoded_frame& frame, rtuwire::byte_view bytes) const;
    [[nodiscard]] frame_reading read(rtuwire::byte_view bytes, rtuwire::frame_role role, std::size_t tail,
                                     std::size_t& size) const;

    known_units units_;
    std::optional<question> asked_{};
};

} // namespace tool
