// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One board that answers as several units: held against as many servers of one unit, each with a framer of its own, on
// the same line; and what only the line as a whole has: broadcasts, counters, the listen-only mode.
#include <rtuwire/server.hpp>

#include <array>
#include <optional>

#include "support/proof.hpp"
#include "support/random.hpp"
#include "support/server_on_a_line.hpp"
#include "support/whole_bank.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr line_timing timing{19'200, character_format::even_8_1};
constexpr unit_id three{3}, four{4};

/// A PDU as a frame to a unit.
struct framed {
    std::array<std::byte, max_adu_size> bytes{};
    std::size_t size{0};

    constexpr framed(std::uint8_t unit, byte_view pdu)
    {
        byte_writer out{bytes};
        out.u8(unit);
        out.bytes(pdu);
        std::uint16_t const crc = crc16(out.written());
        out.u8(crc & 0xFFU);
        out.u8(std::uint32_t{crc} >> 8U);
        size = out.size();
    }
    constexpr byte_view view() const { return byte_view{bytes}.first(size); }
};

/// A server on a line with a clock. What it sends ends with the next call.
template <typename Server> struct on_a_line {
    Server node; // made here: a constant expression does not copy memory that is not set yet
    instant now{0};
    bool is_started{false};

    constexpr void pass(duration length)
    {
        now = now + length;
        node.serve(now);
    }

    constexpr void hear(byte_view bytes)
    {
        now = now + timing.characters(bytes.size());
        node.receive(bytes, now);
        pass({});
    }

    /// What it answers to a frame.
    constexpr byte_view answer(byte_view frame)
    {
        if (not is_started) {
            is_started = true;
            node.advance(now);
            pass(milliseconds(100));
        }
        hear(frame);
        pass(timing.t3_5());
        byte_view const response = node.poll_transmit();
        if (not response.empty()) {
            now = now + timing.characters(response.size());
            node.sent(now);
        }
        pass(timing.t3_5());
        return response;
    }
    constexpr bool says(std::uint8_t unit, byte_view pdu, byte_view wanted)
    {
        framed const asked{unit, pdu};
        framed const expected{unit, wanted};
        return same_bytes(answer(asked.view()), wanted.empty() ? byte_view{} : expected.view());
    }
};
template <typename Server> on_a_line(Server) -> on_a_line<Server>;

constexpr bool own_banks()
{
    word_bank<4> io;
    word_bank<2> meter{100};
    static_cast<void>(meter.set(101, 0x1234));
    on_a_line it{server::for_units(timing, bank_at{three, io}, bank_at{four, meter})};
    bool ok = it.says(3, "06 00 02 00 07"_hex, "06 00 02 00 07"_hex) and io.get(2) == 7;
    ok = it.says(3, "03 00 02 00 01"_hex, "03 02 00 07"_hex) and ok;
    ok = it.says(4, "03 00 65 00 01"_hex, "03 02 12 34"_hex) and ok;
    ok = it.says(4, "03 00 02 00 01"_hex, "83 02"_hex) and it.says(3, "03 00 65 00 01"_hex, "83 02"_hex) and ok;
    return ok and it.says(2, "03 00 02 00 01"_hex, {}) and it.says(5, "03 00 02 00 01"_hex, {});
}
PROOF("each unit answers from its own bank, and no other does", own_banks)

/// Functions that only one of the banks has something for, and what each says of itself.
constexpr device_object module_objects[] = {{vendor_name, "A"}, {product_code, "I/O"}, {2, "1"}};
constexpr device_object meter_objects[] = {{vendor_name, "A"}, {product_code, "M"}, {2, "1"}};
constexpr server_profile module_profile{.identity = identity_of<module_objects>};
constexpr server_profile meter_profile{.limits = {.read = 1}, .identity = identity_of<meter_objects>};

constexpr bool own_functions()
{
    test::whole_bank module;
    word_bank<4> meter;
    on_a_line it{counting_server::with<public_functions>::for_units(timing, bank_at{three, module, module_profile},
                                                                    bank_at{four, meter, meter_profile})};
    bool ok = it.says(3, "05 00 01 FF 00"_hex, "05 00 01 FF 00"_hex) and module.switched.get(1);
    ok = it.says(4, "05 00 01 FF 00"_hex, "85 01"_hex) and it.says(4, "01 00 00 00 01"_hex, "81 01"_hex) and ok;
    ok = it.says(3, "2B 0E 04 01"_hex, "2B 0E 04 81 00 00 01 01 03 49 2F 4F"_hex) and ok;
    ok = it.says(4, "2B 0E 04 01"_hex, "2B 0E 04 81 00 00 01 01 01 4D"_hex) and ok;
    return ok and it.says(4, "03 00 00 00 02"_hex, "83 03"_hex) and
           it.says(3, "03 00 00 00 02"_hex, "03 04 00 00 00 00"_hex);
}
PROOF("each unit has the functions of its bank, its limits and its identity", own_functions)

/// Wants every function, and leaves nothing of a request.
struct wiping_bank : word_bank<4> {
    int calls{0};
    constexpr std::optional<errc> respond(function_code, pdu_buffer& pdu)
    {
        ++calls;
        for (std::byte& each : pdu.bytes) {
            each = std::byte{0xEE};
        }
        pdu.size = 1;
        return errc::none;
    }
};

constexpr bool broadcasts()
{
    word_bank<2> elsewhere{50}; // refuses with 02, which is written over the request
    wiping_bank wiping;
    test::whole_bank first, last;
    on_a_line it{counting_server::with<public_functions>::for_units(timing, bank_at{unit_id{1}, first},
                                                                    bank_at{unit_id{9}, elsewhere},
                                                                    bank_at{three, wiping}, bank_at{four, last})};
    bool ok = it.says(0, "10 00 02 00 01 02 00 07"_hex, {}) and wiping.get(2) == 7;
    ok = first.words.get(2) == 7 and last.words.get(2) == 7 and ok;
    ok = it.says(0, "06 00 03 12 34"_hex, {}) and first.words.get(3) == 0x1234 and last.words.get(3) == 0x1234 and ok;
    ok = wiping.get(3) == 0x1234 and ok;
    ok = it.says(0, "16 00 03 00 F2 00 25"_hex, {}) and first.words.get(3) == 0x0035 and last.words.get(3) == 0x0035 and
         ok;
    ok = it.says(0, "05 00 07 FF 00"_hex, {}) and first.switched.get(7) and last.switched.get(7) and ok;
    ok = it.says(0, "0F 00 08 00 02 01 03"_hex, {}) and first.switched.get(9) and last.switched.get(9) and ok;
    ok = it.says(0, "15 09 06 00 02 00 07 00 01 12 34"_hex, {}) and last.files[1][7] == 0x1234 and ok;
    unsigned const writes = last.writes;
    // What is no write has no effect, and nobody answers.
    ok = it.says(0, "03 00 00 00 01"_hex, {}) and it.says(0, "17 00 00 00 01 00 00 00 01 02 00 09"_hex, {}) and ok;
    ok = it.says(0, "41 12 34"_hex, {}) and wiping.calls == 0 and ok; // nor has a bank's own function
    return ok and last.writes == writes and it.says(4, "03 00 03 00 01"_hex, "03 02 00 35"_hex);
}
PROOF("a broadcast reaches every bank as it came, and none answers", broadcasts)

/// Function 08, as the line counts it: frames of all units, requests to one of these, and those without a response.
constexpr bool counts()
{
    word_bank<4> io, meter;
    on_a_line it{counting_server::for_units(timing, bank_at{three, io}, bank_at{four, meter})};
    bool ok = it.says(3, "08 00 0B 00 00"_hex, "08 00 0B 00 01"_hex); // its own request
    ok = it.says(4, "03 00 00 00 01"_hex, "03 02 00 00"_hex) and ok;
    ok = it.says(2, "03 00 00 00 01"_hex, {}) and ok; // another unit's
    ok = it.says(4, "03 00 63 00 01"_hex, "83 02"_hex) and ok;
    ok = it.says(0, "06 00 01 00 05"_hex, {}) and it.says(0, "06 00 63 00 05"_hex, {}) and ok;
    ok = it.says(3, "08 00 0B 00 00"_hex, "08 00 0B 00 07"_hex) and ok;   // good frames
    ok = it.says(4, "08 00 0E 00 00"_hex, "08 00 0E 00 07"_hex) and ok;   // to one of these units, or to all
    ok = it.says(3, "08 00 0D 00 00"_hex, "08 00 0D 00 02"_hex) and ok;   // exceptions; one of a broadcast to two banks
    return ok and it.says(3, "08 00 0F 00 00"_hex, "08 00 0F 00 02"_hex); // the broadcasts
}
PROOF("the counters are the line's: a broadcast counts once, whatever unit is asked", counts)

constexpr bool listens_only()
{
    word_bank<4> io, meter;
    on_a_line it{counting_server::for_units(timing, bank_at{three, io}, bank_at{four, meter})};
    bool ok = it.says(3, "08 00 04 00 00"_hex, {}) and it.says(4, "06 00 01 00 05"_hex, {}) and meter.get(1) == 0;
    ok = it.says(4, "08 00 01 00 00"_hex, {}) and ok;
    return ok and it.says(3, "03 00 00 00 01"_hex, "03 02 00 00"_hex);
}
PROOF("the listen-only mode is the line's, and any of its units ends it", listens_only)

constexpr bool is_silent_without_function_08()
{
    word_bank<4> io, meter;
    server_profile const reads{.functions = function_set{function_code::read_holding_registers}};
    on_a_line it{counting_server::for_units(timing, bank_at{three, io}, bank_at{four, meter, reads})};
    bool ok = it.says(4, "08 00 01 00 00"_hex, "88 01"_hex) and it.says(3, "08 00 04 00 00"_hex, {});
    ok = it.says(4, "08 00 01 00 00"_hex, {}) and it.says(4, "08 00 0D 00 00"_hex, {}) and ok;
    ok = it.says(3, "03 00 00 00 01"_hex, {}) and ok;
    return it.says(3, "08 00 01 00 00"_hex, {}) and it.says(3, "08 00 0D 00 00"_hex, "08 00 0D 00 00"_hex) and ok;
}
PROOF("the listen-only mode silences a unit whose profile has no function 08, too", is_silent_without_function_08)

constexpr bool of_arrays()
{
    word_bank<2> racks[3];
    word_bank<2> meter;
    std::array const boards{bank_at{unit_id{10}, racks[0]}, bank_at{unit_id{11}, racks[1]},
                            bank_at{unit_id{12}, racks[2]}};
    on_a_line it{server::for_units(timing, boards, bank_at{four, meter})};
    bool ok = it.says(11, "06 00 01 00 05"_hex, "06 00 01 00 05"_hex) and racks[1].get(1) == 5 and racks[2].get(1) == 0;
    ok = it.says(4, "06 00 01 00 06"_hex, "06 00 01 00 06"_hex) and meter.get(1) == 6 and ok;
    ok = it.says(13, "06 00 01 00 07"_hex, {}) and ok;
    ok = it.says(0, "06 00 01 00 08"_hex, {}) and racks[0].get(1) == 8 and racks[2].get(1) == 8 and ok;
    return ok and meter.get(1) == 8;
}
PROOF("banks may stand in an array", of_arrays)

constexpr bool of_one_address()
{
    word_bank<2> first, second;
    on_a_line it{server::for_units(timing, bank_at{three, first}, bank_at{three, second})};
    bool ok = it.says(3, "06 00 01 00 05"_hex, "06 00 01 00 05"_hex) and second.get(1) == 0;
    return ok and it.says(0, "06 00 01 00 06"_hex, {}) and first.get(1) == 6 and second.get(1) == 6;
}
PROOF("of two banks at one address the first answers", of_one_address)

constexpr bool of_hooks()
{
    word_bank<4> io, meter;
    int acts = 0;
    auto watched = with_hooks(io)
                       .check(1, [](std::uint16_t asked) { return asked > 9 ? errc::illegal_data_value : errc::none; })
                       .on_write(1, [&](std::uint16_t) { ++acts; });
    on_a_line it{server::for_units(timing, bank_at{three, watched}, bank_at{four, meter})};
    bool ok = it.says(3, "06 00 01 00 0A"_hex, "86 03"_hex) and it.says(4, "06 00 01 00 0A"_hex, "06 00 01 00 0A"_hex);
    ok = it.says(0, "06 00 01 00 0B"_hex, {}) and acts == 0 and io.get(1) == 0 and meter.get(1) == 11 and ok;
    return ok and it.says(0, "06 00 01 00 02"_hex, {}) and acts == 1 and io.get(1) == 2;
}
PROOF("a broadcast that one unit's hook refuses reaches the others", of_hooks)

/// The same bytes to one server of three units and to three servers of one. The times are a host's, so that between the
/// frames there is no silence that would end one: all that is heard of the others has to be right.
class side_by_side {
    static constexpr line_timing line = line_timing::host(19'200, character_format::even_8_1);
    static constexpr std::size_t count = 3;

public:
    constexpr side_by_side()
    {
        pass({});
        pass(milliseconds(60));
    }

    /// A frame of a client, or of a unit elsewhere; whether both answer the same, and have the same registers.
    constexpr bool agree(byte_view frame)
    {
        hear(frame);
        pass(line.t3_5());
        byte_view const response = together_.poll_transmit();
        byte_view said{};
        std::size_t sender = count;
        for (std::size_t i = 0; i < count; ++i) {
            if (byte_view const one = alone_[i].poll_transmit(); not one.empty()) {
                said = one;
                sender = i;
            }
        }
        bool const is_same = same_bytes(response, said);
        if (not response.empty()) {
            now_ = now_ + line.characters(response.size());
            for (std::size_t i = 0; i < count; ++i) {
                if (i == sender) {
                    alone_[i].sent(now_);
                } else {
                    alone_[i].receive(said, now_);
                }
            }
            together_.sent(now_);
            answers_ += 1;
        }
        pass({});
        return is_same and has_same_words();
    }
    constexpr void pass(duration length)
    {
        now_ = now_ + length;
        together_.advance(now_);
        together_.serve(now_);
        for (std::size_t i = 0; i < count; ++i) {
            alone_[i].advance(now_);
            alone_[i].serve(single_[i], now_);
        }
    }
    constexpr int answers() const { return answers_; }

private:
    constexpr void hear(byte_view bytes)
    {
        now_ = now_ + line.characters(bytes.size());
        together_.receive(bytes, now_);
        for (auto& each : alone_) {
            each.receive(bytes, now_);
        }
        pass({});
    }
    constexpr bool has_same_words() const
    {
        bool ok = true;
        for (std::size_t i = 0; i < count; ++i) {
            for (std::uint16_t at = 0; at < 8; ++at) {
                ok = ok and shared_[i].get(at) == single_[i].get(at);
            }
        }
        return ok;
    }

    instant now_{0};
    int answers_{0};
    std::array<word_bank<8>, count> shared_{}, single_{};
    std::array<server, count> alone_{server{unit_id{3}, line}, server{unit_id{4}, line}, server{unit_id{7}, line}};
    decltype(server::for_units(line, bank_at{three, shared_[0]}, bank_at{three, shared_[0]},
                               bank_at{three, shared_[0]})) together_{
        server::for_units(line, bank_at{three, shared_[0]}, bank_at{four, shared_[1]},
                          bank_at{unit_id{7}, shared_[2]})};
};

/// A random request of the server's functions, most of them allowed.
byte_view random_pdu(test::random& draw, byte_span place)
{
    byte_writer out{place};
    std::uint32_t const start = draw.next() % 9, words = 1 + draw.next() % 4;
    switch (draw.next() % 24 / 4) {
    case 0: static_cast<void>((out.u8(3), out.u16(start), out.u16(words))); break;
    case 1: static_cast<void>((out.u8(6), out.u16(start), out.u16(draw.next() & 0xFFFFU))); break;
    case 2:
    case 3:
        out.u8(16);
        out.u16(start);
        out.u16(words);
        out.u8(2 * words);
        for (std::uint32_t i = 0; i < words; ++i) {
            out.u16(draw.next() & 0xFFFFU);
        }
        break;
    default:
        if (draw.next() % 8 == 0) { // only silence ends it
            static_cast<void>((out.u8(8), out.u16(0), out.u16(draw.next() & 0xFFFFU)));
            break;
        }
        out.u8(23);
        out.u16(start);
        out.u16(words);
        out.u16(draw.next() % 9);
        out.u16(1);
        out.u8(2);
        out.u16(draw.next() & 0xFFFFU);
    }
    return out.written();
}

TEST_CASE("several units on one board answer as as many boards do, whatever is on the line")
{
    test::random draw{2026};
    side_by_side boards;
    word_bank<8> foreign;
    constexpr std::array<std::uint8_t, 7> units{0, 2, 2, 3, 4, 7, 5};
    for (int i = 0; i < 20'000; ++i) {
        std::array<std::byte, max_pdu_size> place{}, answer{};
        byte_view const pdu = random_pdu(draw, place);
        std::uint8_t const unit = units[draw.next() % units.size()];
        REQUIRE(boards.agree(framed{unit, pdu}.view()));
        if (unit == 2) { // a board elsewhere, which answers; unit 5 never does
            boards.pass(timing.t3_5());
            REQUIRE(boards.agree(framed{unit, respond(pdu, foreign, server_profile{}, answer)}.view()));
        }
        boards.pass(draw.next() % 8 == 0 ? milliseconds(60) : timing.t3_5());
    }
    CHECK(boards.answers() > 5'000);
}

// One frame's memory for all: a unit costs two pointers and its address, not 256 bytes.
static_assert(sizeof(server::for_units(timing, bank_at{three, std::declval<word_bank<4>&>()},
                                       bank_at{four, std::declval<word_bank<4>&>()})) <=
              sizeof(server) + 8 * sizeof(void*));

} // namespace
