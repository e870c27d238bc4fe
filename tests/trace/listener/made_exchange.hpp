// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Exchanges as the specification prints them, made byte by byte and with a CRC of their own: nothing of the library
// takes part. What a listener says of a line is compared with them.
#pragma once

#include <cstdint>
#include <vector>

#include "support/random.hpp"

namespace listening {

using bytes = std::vector<std::byte>;

/// A request, and its response; empty where there is none.
struct made_exchange {
    bytes request;
    bytes response;
};

inline void put(bytes& out, unsigned byte) { out.push_back(static_cast<std::byte>(byte & 0xFFU)); }
inline void put_word(bytes& out, unsigned word)
{
    put(out, word >> 8U);
    put(out, word);
}

/// Bit by bit, as SL 6.2.2 describes it.
inline void put_crc(bytes& out)
{
    unsigned crc = 0xFFFF;
    for (std::byte const each : out) {
        crc ^= std::to_integer<unsigned>(each);
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc & 1U) != 0 ? crc >> 1U ^ 0xA001U : crc >> 1U;
        }
    }
    put(out, crc);
    put(out, crc >> 8U);
}

/// Makes exchanges of one kind after the other.
class exchange_maker {
public:
    explicit exchange_maker(std::uint32_t seed) : random_{seed} {}

    unsigned below(unsigned limit) { return random_.next() % limit; }

    /// Of a unit, with any public function; one in eight is refused.
    made_exchange make(unsigned unit)
    {
        constexpr unsigned codes[] = {1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 15, 16, 17, 20, 21, 22, 23, 24, 43};
        unsigned const code = codes[below(sizeof codes / sizeof *codes)];
        bool const is_refused = below(8) == 0;
        return make(unit, code, is_refused);
    }

    made_exchange make(unsigned unit, unsigned code, bool is_refused)
    {
        made_exchange made{begin(unit, code), begin(unit, code)};
        fill(code, made);
        if (is_refused) {
            made.response = begin(unit, code | 0x80U);
            put(made.response, 1 + below(4));
        }
        put_crc(made.request);
        put_crc(made.response);
        return made;
    }

    /// To all units: a write, without a response.
    made_exchange make_broadcast()
    {
        made_exchange made = make(0, below(2) == 0 ? 6 : 16, false);
        made.response.clear();
        return made;
    }

    /// Of a function that nobody knows: only silence ends its frames.
    made_exchange make_unknown(unsigned unit)
    {
        unsigned const code = 65 + below(8);
        made_exchange made{begin(unit, code), begin(unit, code)};
        put_bytes(made.request, below(20));
        put_bytes(made.response, below(20));
        put_crc(made.request);
        put_crc(made.response);
        return made;
    }

private:
    static bytes begin(unsigned unit, unsigned code)
    {
        bytes out;
        put(out, unit);
        put(out, code);
        return out;
    }
    void put_bytes(bytes& out, unsigned count)
    {
        for (unsigned i = 0; i < count; ++i) {
            put(out, random_.next());
        }
    }
    void put_counted(bytes& out, unsigned count)
    {
        put(out, count);
        put_bytes(out, count);
    }
    void put_head(made_exchange& made, unsigned count)
    {
        put_word(made.request, below(10'000));
        put_word(made.request, count);
    }
    static void repeat(made_exchange& made, std::size_t size)
    {
        made.response.assign(made.request.begin(), made.request.begin() + static_cast<std::ptrdiff_t>(size));
    }

    void fill(unsigned code, made_exchange& made)
    {
        switch (code) {
        case 1:
        case 2: return fill_read(made, 1 + below(2'000), 1);
        case 3:
        case 4: return fill_read(made, 1 + below(125), 16);
        case 5: return fill_single(made, below(2) == 0 ? 0xFF00U : 0U);
        case 6: return fill_single(made, random_.next());
        case 7: return put_bytes(made.response, 1);
        case 8: return fill_loopback(made);
        case 11: return put_bytes(made.response, 4);
        case 12: return put_counted(made.response, 6 + below(64));
        case 15: return fill_write(made, 1 + below(1'968), 1);
        case 16: return fill_write(made, 1 + below(123), 16);
        case 17: return put_counted(made.response, 2 + below(60));
        case 20: return fill_file_read(made);
        case 21: return fill_file_write(made);
        case 22: return fill_mask(made);
        case 23: return fill_both(made);
        case 24: return fill_queue(made);
        default: return fill_identity(made);
        }
    }
    void fill_read(made_exchange& made, unsigned count, unsigned bits)
    {
        put_head(made, count);
        put_counted(made.response, (count * bits + 7) / 8);
    }
    void fill_single(made_exchange& made, unsigned value)
    {
        put_head(made, value);
        repeat(made, 6);
    }
    void fill_loopback(made_exchange& made)
    {
        put_word(made.request, 0);
        put_bytes(made.request, 2);
        repeat(made, 6);
    }
    void fill_write(made_exchange& made, unsigned count, unsigned bits)
    {
        put_head(made, count);
        repeat(made, 6);
        put_counted(made.request, (count * bits + 7) / 8);
    }
    void fill_file_read(made_exchange& made)
    {
        unsigned const count = 1 + below(40);
        put(made.request, 7);
        put(made.request, 6);
        put_word(made.request, 1 + below(9));
        put_word(made.request, below(10'000));
        put_word(made.request, count);
        put(made.response, 2 + 2 * count);
        put(made.response, 1 + 2 * count);
        put(made.response, 6);
        put_bytes(made.response, 2 * count);
    }
    void fill_file_write(made_exchange& made)
    {
        unsigned const count = 1 + below(40);
        put(made.request, 7 + 2 * count);
        put(made.request, 6);
        put_word(made.request, 1 + below(9));
        put_word(made.request, below(10'000));
        put_word(made.request, count);
        put_bytes(made.request, 2 * count);
        repeat(made, made.request.size());
    }
    void fill_mask(made_exchange& made)
    {
        put_head(made, random_.next());
        put_bytes(made.request, 2);
        repeat(made, 8);
    }
    void fill_both(made_exchange& made)
    {
        unsigned const reads = 1 + below(125);
        unsigned const writes = 1 + below(121);
        put_head(made, reads);
        put_word(made.request, below(10'000));
        put_word(made.request, writes);
        put_counted(made.request, 2 * writes);
        put_counted(made.response, 2 * reads);
    }
    void fill_queue(made_exchange& made)
    {
        unsigned const count = below(32);
        put_word(made.request, below(10'000));
        put_word(made.response, 2 + 2 * count);
        put_word(made.response, count);
        put_bytes(made.response, 2 * count);
    }
    void fill_identity(made_exchange& made)
    {
        put(made.request, 14);
        put(made.request, 1);
        put(made.request, 0);
        put(made.response, 14);
        put(made.response, 1);
        put(made.response, 1);
        put(made.response, 0);
        put(made.response, 0);
        put(made.response, 3);
        for (unsigned object = 0; object < 3; ++object) {
            put(made.response, object);
            put_counted(made.response, below(20));
        }
    }

    rtuwire::test::random random_;
};

} // namespace listening
