// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Random valid requests, and what a server has to answer, worked out from arrays. Knows neither rtuwire nor libmodbus:
// a client is what has the operations that its program offers.
//
// The device, unit 1: 65 536 coils and holding registers, all 0 at first; input registers and discrete inputs by
// `input_word` and `input_bit`. The other functions show the holding registers in other ways: see `memory`.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace agreement {

using words = std::vector<std::uint16_t>;
using bytes = std::vector<std::uint8_t>;
using bits = std::vector<std::uint8_t>;

constexpr std::size_t addresses = 0x1'0000;

constexpr std::uint16_t input_word(std::size_t address) { return static_cast<std::uint16_t>(address * 40'503U + 7U); }
constexpr bool input_bit(std::size_t address) { return ((address * 40'503U) >> 9U & 1U) != 0; }

/// Where a test tells a server what functions 07, 11, 12, 17 and 08 are to answer.
constexpr std::uint16_t status_at = 0x8000, events_at = 0x8001, messages_at = 0x8002, counters_at = 0x8008,
                        id_at = 0x8010, log_at = 0x8100;

struct memory {
    std::array<std::uint16_t, addresses> held{};
    std::array<bool, addresses> coils{};

    /// As many low bytes of the registers behind the one at `at` as that one says, `most` at most.
    bytes counted(std::size_t at, std::size_t most) const
    {
        bytes found(held[at] % (most + 1));
        for (std::size_t i = 0; i < found.size(); ++i) {
            found[i] = static_cast<std::uint8_t>(held[at + 1 + i]);
        }
        return found;
    }
    static std::uint16_t record_at(std::size_t file, std::size_t record)
    {
        return static_cast<std::uint16_t>(file * 10'007 + record);
    }
    /// A queue: a register with its length, up to 31, and those behind it.
    words queue(std::uint16_t at) const
    {
        words found(held[at] % 32U);
        for (std::size_t i = 0; i < found.size(); ++i) {
            found[i] = held[(at + 1 + i) % addresses];
        }
        return found;
    }
};

enum class outcome { done, lost, refused };

/// Requests, the memory that they should leave behind, and what was not as it should be.
class agreement_test {
public:
    explicit agreement_test(unsigned seed) : random_{seed} {}

    memory expected{};

    std::size_t number(std::size_t least, std::size_t most)
    {
        return std::uniform_int_distribution<std::size_t>{least, most}(random_);
    }
    std::uint16_t word() { return static_cast<std::uint16_t>(number(0, 0xFFFF)); }
    /// A quantity: small, large, or any.
    std::uint16_t count(std::size_t most)
    {
        std::size_t const kind = number(0, 7);
        return static_cast<std::uint16_t>(kind == 0 ? 1 : kind == 1 ? most : number(1, kind < 5 ? most / 4 + 1 : most));
    }
    /// Where a run of `size` starts: in the first or the last 4096 addresses, each end included.
    std::uint16_t start(std::size_t size)
    {
        std::size_t const from = number(0, 1) == 0 ? 0 : addresses - window;
        std::size_t const last = from + window - size;
        std::size_t const kind = number(0, 15);
        return static_cast<std::uint16_t>(kind == 0 ? from : kind == 1 ? last : number(from, last));
    }
    words random_words(std::size_t size)
    {
        words made(size);
        for (auto& each : made) {
            each = word();
        }
        return made;
    }
    bits random_bits(std::size_t size)
    {
        bits made(size);
        for (auto& each : made) {
            each = static_cast<std::uint8_t>(number(0, 1));
        }
        return made;
    }

    void put(std::size_t at, words const& values)
    {
        for (std::size_t i = 0; i < values.size(); ++i) {
            expected.held[at + i] = values[i];
        }
    }
    words held(std::size_t at, std::size_t size) const
    {
        return {expected.held.begin() + static_cast<std::ptrdiff_t>(at),
                expected.held.begin() + static_cast<std::ptrdiff_t>(at + size)};
    }

    /// Asks, again where the machine was too slow to be answered in time, and counts.
    template <typename Ask> bool asked(Ask const& ask)
    {
        outcome ended = outcome::lost;
        for (int i = 0; i < 3 and ended == outcome::lost; ++i) {
            repeated_ += i > 0 ? 1 : 0;
            ended = ask();
        }
        return ended == outcome::done;
    }
    void expect(bool is_right, char const* what, std::size_t first = 0, std::size_t second = 0)
    {
        if (not is_right and ++differences_ <= 10) {
            std::printf("FAIL %s (%zu, %zu)\n", what, first, second);
        }
    }
    void end_of(unsigned function, unsigned requests)
    {
        std::printf("%s function %02u: %u requests\n", differences_ == 0 ? "ok  " : "FAIL", function, requests);
    }
    /// The status of the program. One request in a hundred may have been asked again.
    int status(unsigned requests) const
    {
        std::printf("differences: %u, asked again: %u\n", differences_, repeated_);
        return differences_ == 0 and repeated_ * 100 <= requests ? 0 : 1;
    }

    static constexpr std::size_t window = 4096;

private:
    std::mt19937 random_;
    unsigned differences_{0};
    unsigned repeated_{0};
};

/// Runs of functions 01 to 06, 15, 16, 17, 22 and 23: those that both clients have.
template <typename Client> class common_requests {
public:
    common_requests(agreement_test& test, Client& client) : test_{test}, client_{client} {}

    /// Gives every register or coil of both windows a value, where a function uses them.
    void fill(unsigned function)
    {
        each_part(
            function, [this](std::uint16_t at, std::uint16_t size) { write_words(at, std::size_t{size}); },
            [this](std::uint16_t at, std::uint16_t size) { write_bits(at, size); });
    }

    /// Reads them.
    void sweep(unsigned function)
    {
        each_part(
            function, [this](std::uint16_t at, std::uint16_t size) { read_words(3, at, size); },
            [this](std::uint16_t at, std::uint16_t size) { read_bits(1, at, size); });
    }

    /// One random request; false where this client or its server has not the function.
    bool request(unsigned function)
    {
        std::uint16_t size = 0;
        switch (function) {
        case 1:
        case 2:
            size = test_.count(2000);
            read_bits(function, test_.start(size), size);
            return true;
        case 3:
        case 4:
            size = test_.count(125);
            read_words(function, test_.start(size), size);
            return true;
        case 5: write_bit(); return true;
        case 6: write_word(); return true;
        case 15:
            size = test_.count(1968);
            write_bits(test_.start(size), size);
            return true;
        case 16:
            size = test_.count(123);
            write_words(test_.start(size), size);
            return true;
        case 22: mask(); return true;
        case 23: exchange(); return true;
        default: return false;
        }
    }

    void write_words(std::uint16_t start, words const& values)
    {
        bool const done = test_.asked([&] { return client_.write_words(start, values); });
        test_.expect(done, "16 writes", start, values.size());
        test_.put(start, values);
    }

private:
    template <typename Words, typename Bits>
    static void each_part(unsigned function, Words const& visit_words, Bits const& visit_bits)
    {
        bool const is_of_bits = function == 1 or function == 5 or function == 15;
        std::uint16_t const size = is_of_bits ? 1024 : 64;
        for (std::size_t const from : {std::size_t{0}, addresses - agreement_test::window}) {
            for (std::size_t at = from; at < from + agreement_test::window; at += size) {
                is_of_bits ? visit_bits(static_cast<std::uint16_t>(at), size)
                           : visit_words(static_cast<std::uint16_t>(at), size);
            }
        }
    }
    void read_bits(unsigned function, std::uint16_t start, std::uint16_t size)
    {
        bits seen;
        bool const done = test_.asked([&] { return client_.read_bits(function, start, size, seen); });
        bool is_same = done and seen.size() == size;
        for (std::size_t i = 0; is_same and i < size; ++i) {
            is_same = (seen[i] != 0) == (function == 1 ? test_.expected.coils[start + i] : input_bit(start + i));
        }
        test_.expect(is_same, function == 1 ? "01 reads" : "02 reads", start, size);
    }
    void read_words(unsigned function, std::uint16_t start, std::uint16_t size)
    {
        words seen;
        bool const done = test_.asked([&] { return client_.read_words(function, start, size, seen); });
        bool is_same = done and seen.size() == size;
        for (std::size_t i = 0; is_same and i < size; ++i) {
            is_same = seen[i] == (function == 3 ? test_.expected.held[start + i] : input_word(start + i));
        }
        test_.expect(is_same, function == 3 ? "03 reads" : "04 reads", start, size);
    }
    void write_bit()
    {
        std::uint16_t const at = test_.start(1);
        bool const value = test_.number(0, 1) != 0;
        test_.expect(test_.asked([&] { return client_.write_bit(at, value); }), "05 writes", at, value ? 1 : 0);
        test_.expected.coils[at] = value;
    }
    void write_word()
    {
        std::uint16_t const at = test_.start(1);
        std::uint16_t const value = test_.word();
        test_.expect(test_.asked([&] { return client_.write_word(at, value); }), "06 writes", at, value);
        test_.expected.held[at] = value;
    }
    void write_bits(std::uint16_t start, std::size_t size)
    {
        bits const values = test_.random_bits(size);
        test_.expect(test_.asked([&] { return client_.write_bits(start, values); }), "15 writes", start, size);
        for (std::size_t i = 0; i < size; ++i) {
            test_.expected.coils[start + i] = values[i] != 0;
        }
    }
    void write_words(std::uint16_t start, std::size_t size) { write_words(start, test_.random_words(size)); }
    void mask()
    {
        std::uint16_t const at = test_.start(1);
        std::uint16_t const and_mask = test_.word();
        std::uint16_t const or_mask = test_.word();
        test_.expect(test_.asked([&] { return client_.mask(at, and_mask, or_mask); }), "22 writes", and_mask, or_mask);
        auto& value = test_.expected.held[at];
        // Bit by bit: AP 6.16 in words.
        std::uint16_t made = 0;
        for (unsigned bit = 0; bit < 16; ++bit) {
            unsigned const source = (and_mask >> bit & 1U) != 0 ? value : or_mask;
            made = static_cast<std::uint16_t>(made | (source & (1U << bit)));
        }
        value = made;
    }
    void exchange()
    {
        std::uint16_t const read_size = test_.count(125);
        std::uint16_t const write_at = test_.start(121);
        words const values = test_.random_words(test_.count(121));
        // Often near what is written, which comes first (AP 6.17).
        std::size_t const lowest = write_at > 60 ? write_at - 60U : 0U;
        bool const is_near = test_.number(0, 1) == 0 and lowest + read_size <= addresses;
        auto const read_at = is_near ? static_cast<std::uint16_t>(lowest) : test_.start(read_size);
        words seen;
        bool const done = test_.asked([&] { return client_.exchange(read_at, read_size, write_at, values, seen); });
        test_.put(write_at, values);
        test_.expect(done and seen == test_.held(read_at, read_size), "23 writes, then reads", read_at, write_at);
    }

    agreement_test& test_;
    Client& client_;
};

} // namespace agreement
