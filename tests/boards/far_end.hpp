// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Who is at the other end of a board's line, frame by frame as the specification has them: a device with two registers, and
// a master that asks one. Both disturb the line as they are told.
#pragma once

#include <cstdlib>
#include <iostream>
#include <vector>

#include "wire.hpp"

namespace stand_in {

using frame = std::vector<std::uint8_t>;

inline frame with_crc(frame bytes)
{
    unsigned crc = 0xFFFF;
    for (std::uint8_t const each : bytes) {
        crc ^= each;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc & 1U) != 0 ? crc >> 1U ^ 0xA001U : crc >> 1U;
        }
    }
    bytes.push_back(static_cast<std::uint8_t>(crc & 0xFFU));
    bytes.push_back(static_cast<std::uint8_t>(crc >> 8U));
    return bytes;
}

inline int failures = 0;

inline void check(bool is_so, char const* what)
{
    if (not is_so) {
        ++failures;
        std::cerr << "not so: " << what << '\n';
    }
}

/// Unit 7: register 3201 is 0x0250, 9001 is written.
class device {
public:
    void attach()
    {
        line.heard = [this](std::uint8_t byte) { hear(byte); };
        line.on_time = nullptr;
    }
    int requests{0};
    std::uint16_t written{0};
    bool is_silent{false};
    /// Of the response to this request, the byte at this place.
    int bad_request{-1};
    std::size_t bad_at{~std::size_t{0}};
    arrival how{arrival::good};
    bool loses_a_byte{false};

private:
    void hear(std::uint8_t byte)
    {
        request_.push_back(byte);
        if (request_.size() < 8) {
            return;
        }
        frame const got = request_;
        request_.clear();
        ++requests;
        check(got == with_crc({got.begin(), got.end() - 2}), "a request has its CRC");
        check(got[0] == 7, "a request is for unit 7");
        frame answer;
        if (got[1] == 3) {
            check(got == with_crc({7, 3, 0x0C, 0x81, 0, 1}), "it reads register 3201");
            answer = with_crc({7, 3, 2, 0x02, 0x50});
        } else {
            check(got[1] == 6, "it reads or writes");
            written = static_cast<std::uint16_t>(got[4] << 8U | got[5]);
            answer = got;
        }
        if (is_silent) {
            return;
        }
        bool const is_bad = requests == bad_request;
        if (is_bad and loses_a_byte) {
            answer.erase(answer.begin() + 3);
        }
        line.speak(answer, 4'000, is_bad and not loses_a_byte ? bad_at : ~std::size_t{0}, how);
    }

    frame request_{};
};

/// A master that reads register 3201 of unit 7 four times a second, and spoils one request in three.
class master {
public:
    static constexpr wire::time period = 250'000;

    void attach()
    {
        next_ = line.now() + period;
        line.heard = [this](std::uint8_t byte) { answer_.push_back(byte); };
        line.on_time = [this] { go_on(); };
    }
    int asked{0}, answered{0}, spoiled{0}, deaf{0}, answered_spoiled{0};

private:
    void go_on()
    {
        if (line.now() < next_) {
            return;
        }
        next_ += period;
        judge();
        ++asked;
        is_spoiled_ = asked % 3 == 2;
        spoiled += is_spoiled_ ? 1 : 0;
        constexpr arrival kinds[] = {arrival::overrun, arrival::parity, arrival::framing, arrival::noise};
        auto const turn = static_cast<std::size_t>(asked / 3);
        line.speak(with_crc({7, 3, 0x0C, 0x81, 0, 1}), 0, is_spoiled_ ? turn % 8 : ~std::size_t{0},
                   kinds[turn / 8 % 4]);
    }
    void judge()
    {
        if (asked == 0) {
            return;
        }
        bool const is_answered = answer_ == with_crc({7, 3, 2, 0x02, 0x50});
        check(is_answered or answer_.empty(), "an answer is whole and right");
        answered += is_answered ? 1 : 0;
        deaf += not is_spoiled_ and not is_answered ? 1 : 0;
        answered_spoiled += is_spoiled_ and is_answered ? 1 : 0;
        answer_.clear();
    }

    wire::time next_{0};
    bool is_spoiled_{false};
    frame answer_{};
};

} // namespace stand_in
