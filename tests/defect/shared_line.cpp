// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server on a line where other units miss responses. The test makes every frame by itself, knows from
// the start which request is ours, and shares no code with the library but the server it feeds.
#include <rtuwire/server/server.hpp>

#include <cstdint>
#include <string>
#include <vector>

#include "support/catch.hpp"

using namespace rtuwire;

namespace {

using frame = std::vector<std::byte>;

constexpr std::uint8_t us = 1;
constexpr std::uint8_t last_unit = 6;

/// Numbers that look random and can be repeated (xorshift).
class numbers {
public:
    explicit numbers(std::uint32_t seed) : state_{seed * 2U + 1U} {}

    std::uint32_t below(std::uint32_t limit)
    {
        state_ ^= state_ << 13U;
        state_ ^= state_ >> 17U;
        state_ ^= state_ << 5U;
        return state_ % limit;
    }
    bool happens(std::uint32_t percent) { return below(100) < percent; }

private:
    std::uint32_t state_;
};

frame with_crc(std::vector<std::uint32_t> const& bytes)
{
    frame made;
    std::uint32_t crc = 0xFFFF;
    for (std::uint32_t const byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc & 1U) != 0 ? (crc >> 1U) ^ 0xA001U : crc >> 1U;
        }
        made.push_back(static_cast<std::byte>(byte));
    }
    made.push_back(static_cast<std::byte>(crc & 0xFFU));
    made.push_back(static_cast<std::byte>(crc >> 8U));
    return made;
}

/// What a client asks, and what the unit asked would respond.
struct asked_and_told {
    frame request;
    frame response;
};

class traffic {
public:
    explicit traffic(std::uint32_t seed) : random_{seed} {}

    numbers& random_source() { return random_; }

    /// A write to us: the only function the server under test is asked to execute.
    asked_and_told ours(std::uint32_t address, std::uint32_t value)
    {
        std::vector<std::uint32_t> const bytes{us, 6, address >> 8U, address & 0xFFU, value >> 8U, value & 0xFFU};
        return {with_crc(bytes), with_crc(bytes)};
    }

    /// Any exchange with another unit.
    asked_and_told foreign()
    {
        std::uint32_t const unit = 2 + random_.below(last_unit - 1);
        constexpr std::uint32_t functions[] = {1, 2, 3, 3, 3, 4, 5, 6, 6, 7, 11, 15, 16, 22, 23, 43};
        std::uint32_t const function = functions[random_.below(16)];
        std::vector<std::uint32_t> asks{unit, function};
        std::vector<std::uint32_t> says{unit, function};
        // Drives keep their registers at 3201 and 8501: as a byte count, the high byte is a long response.
        std::uint32_t const address = random_.happens(50) ? 3201 + random_.below(8) : random_.below(0x10000);
        std::uint32_t const count = 1 + random_.below(40);
        if (function == 7) {
            random_bytes(says, 1);
        } else if (function == 11) {
            word(says, random_.happens(50) ? 0xFFFF : 0); // busy or ready, then a counter
            random_bytes(says, 2);
        } else if (function == 43) {
            for (std::uint32_t const byte : {0x0EU, 1U, 0U}) {
                asks.push_back(byte);
            }
            for (std::uint32_t const byte : {0x0EU, 1U, 0x81U, 0U, 0U, 2U, 0U, 3U}) {
                says.push_back(byte);
            }
            random_bytes(says, 3);
            says.push_back(1);
            says.push_back(2);
            random_bytes(says, 2);
        } else {
            word(asks, address);
            middle(function, count, asks, says);
        }
        if (function != 43 and random_.happens(10)) {
            says = {unit, function | 0x80U, 2};
        }
        return {with_crc(asks), with_crc(says)};
    }

private:
    static void word(std::vector<std::uint32_t>& bytes, std::uint32_t value)
    {
        bytes.push_back(value >> 8U);
        bytes.push_back(value & 0xFFU);
    }

    void random_bytes(std::vector<std::uint32_t>& bytes, std::uint32_t count)
    {
        for (std::uint32_t i = 0; i < count; ++i) {
            bytes.push_back(random_.below(256));
        }
    }

    /// Data of registers; now and then a whole request to us lies in it.
    void data(std::vector<std::uint32_t>& bytes, std::uint32_t count)
    {
        std::size_t const start = bytes.size();
        random_bytes(bytes, count);
        if (count >= 8 and random_.happens(30)) {
            frame const hidden = ours(random_.below(1000), 0xDEAD).request;
            std::size_t const at = start + random_.below(count - 7);
            for (std::size_t i = 0; i < hidden.size(); ++i) {
                bytes[at + i] = static_cast<std::uint32_t>(hidden[i]);
            }
        }
    }

    void middle(std::uint32_t function, std::uint32_t count, std::vector<std::uint32_t>& asks,
                std::vector<std::uint32_t>& says)
    {
        std::vector<std::uint32_t> const head{asks.begin() + 2, asks.end()};
        if (function <= 4) {
            std::uint32_t const bytes = function <= 2 ? (count + 7) / 8 : 2 * count;
            word(asks, count);
            says.push_back(bytes);
            data(says, bytes);
        } else if (function == 5 or function == 6) {
            word(asks, function == 5 ? 0xFF00 : random_.below(0x10000));
            says = asks;
        } else if (function == 22) {
            random_bytes(asks, 4);
            says = asks;
        } else if (function == 23) {
            std::uint32_t const written = 1 + random_.below(20);
            word(asks, count);
            word(asks, random_.below(0x10000));
            word(asks, written);
            asks.push_back(2 * written);
            data(asks, 2 * written);
            says.push_back(2 * count);
            data(says, 2 * count);
        } else { // 15, 16
            std::uint32_t const bytes = function == 15 ? (count + 7) / 8 : 2 * count;
            word(asks, count);
            says.insert(says.end(), head.begin(), head.end());
            word(says, count);
            asks.push_back(bytes);
            data(asks, bytes);
        }
    }

    numbers random_;
};

/// Takes every write, and remembers the last.
struct diary {
    unsigned writes{0};
    std::uint16_t address{0};
    std::uint16_t value{0};

    static errc check_read(std::uint16_t, std::size_t) { return errc::illegal_data_address; }
    static errc check_write(std::uint16_t, register_view) { return errc::none; }
    static errc read(std::uint16_t, std::size_t, byte_writer&) { return errc::none; }
    errc write(std::uint16_t start, register_view values)
    {
        ++writes;
        address = start;
        value = values[0];
        return errc::none;
    }
};

/// How a receiver hands over what it has.
enum class chunks { bytes, frames, pieces };

/// The server on its line, and what it did.
class line_played {
public:
    line_played(line_timing const& timing, chunks how) : timing_{timing}, how_{how}, node_{unit_id{us}, timing}
    {
        pass(milliseconds(1));
        pass(milliseconds(200));
    }

    void pass(duration length)
    {
        instant const end = now_ + length;
        // Wakes when it wants to.
        for (deadline next = node_.poll_deadline(); next and not reached(*next, end); next = node_.poll_deadline()) {
            now_ = reached(now_, *next) ? now_ + microseconds(1) : *next;
            turn();
        }
        now_ = end;
        turn();
    }

    void hear(frame const& bytes, numbers& random_source)
    {
        byte_view rest{bytes};
        while (not rest.empty()) {
            std::size_t many = how_ == chunks::bytes ? 1 : rest.size();
            if (how_ == chunks::pieces) {
                many = 1 + random_source.below(static_cast<std::uint32_t>(rest.size()));
            }
            now_ = now_ + timing_.characters(many);
            node_.receive(rest.first(many), now_);
            turn();
            rest = rest.subspan(many);
        }
    }

    /// What it sent since this was last asked.
    frame take_said()
    {
        frame const said = said_;
        said_.clear();
        return said;
    }

    diary const& bank() const { return bank_; }

private:
    void turn()
    {
        node_.advance(now_);
        node_.serve(bank_, now_);
        byte_view const out = node_.poll_transmit();
        if (not out.empty()) {
            said_.assign(out.begin(), out.end());
            now_ = now_ + timing_.characters(out.size());
            node_.sent(now_);
        }
    }

    line_timing timing_;
    chunks how_;
    server node_;
    diary bank_{};
    instant now_{0xFFFF'0000U};
    frame said_{};
};

/// How many of `total` exchanges went wrong for us: requests not executed, not answered, or something
/// executed that nobody asked.
std::string failures_of(line_timing const& timing, chunks how, std::uint32_t seed, unsigned total)
{
    constexpr duration gap = milliseconds(5);
    traffic line{seed};
    line_played it{timing, how};
    unsigned lost = 0;
    unsigned unanswered = 0;
    unsigned asked = 0;
    unsigned expected = 0;
    bool is_unasked = false;
    for (unsigned i = 0; i < total; ++i) {
        it.pass(gap);
        if (not line.random_source().happens(30)) {
            asked_and_told const other = line.foreign();
            it.hear(other.request, line.random_source());
            if (not line.random_source().happens(25)) {
                it.pass(gap);
                it.hear(other.response, line.random_source());
            }
            is_unasked = is_unasked or it.bank().writes != expected;
            expected = it.bank().writes;
            continue;
        }
        ++asked;
        std::uint32_t const address = line.random_source().below(1000);
        asked_and_told const mine = line.ours(address, i & 0xFFFFU);
        static_cast<void>(it.take_said());
        it.hear(mine.request, line.random_source());
        it.pass(gap);
        bool const is_done =
            it.bank().writes == expected + 1 and it.bank().address == address and it.bank().value == (i & 0xFFFFU);
        expected = it.bank().writes;
        lost += is_done ? 0U : 1U;
        unanswered += it.take_said() == mine.response ? 0U : 1U;
    }
    return std::to_string(asked) + " asked, " + std::to_string(lost) + " lost, " + std::to_string(unanswered) +
           " not answered" + (is_unasked ? ", unasked writes" : "");
}

bool is_clean(std::string const& report)
{
    return report.find(" 0 lost, 0 not answered") != std::string::npos and report.find("unasked") == std::string::npos;
}

constexpr unsigned exchanges = 20'000;

} // namespace

TEST_CASE("defect: D11 no request is lost on a line where other units miss responses")
{
    auto const host = line_timing::host(19'200, character_format::even_8_1);
    line_timing const receiver{19'200, character_format::even_8_1};
    for (chunks const how : {chunks::bytes, chunks::frames, chunks::pieces}) {
        for (auto const& timing : {host, receiver}) {
            for (std::uint32_t seed = 1; seed <= 3; ++seed) {
                std::string const report = failures_of(timing, how, seed, exchanges);
                INFO(report);
                CHECK(is_clean(report));
            }
        }
    }
}

TEST_CASE("defect: D11 a unit that misses one response costs no request to us")
{
    auto const host = line_timing::host(19'200, character_format::even_8_1);
    constexpr duration gap = milliseconds(5);
    traffic line{1};
    line_played it{host, chunks::frames};
    frame const missed = with_crc({2, 3, 0x0C, 0x81, 0, 6});
    it.hear(missed, line.random_source());
    unsigned done = 0;
    for (unsigned i = 0; i < 100; ++i) {
        it.pass(gap);
        it.hear(missed, line.random_source()); // never answered
        it.pass(gap);
        it.hear(line.ours(1, i).request, line.random_source());
        it.pass(gap);
        done += it.bank().writes == i + 1 ? 1U : 0U;
    }
    CHECK(done == 100);
}
