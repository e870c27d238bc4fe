// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Banks and plans of a thousand registers: random requests against a map of addresses, which knows nothing of the bank's
// order and search. The registers are named in an order of their own, with gaps between them.
#include <rtuwire/server/typed_bank.hpp>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/random.hpp"

#include <rtuwire/server/respond.hpp>
#include <rtuwire/table/form/whole.hpp>
#include <rtuwire/table/read_plan.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr unsigned count = 1'000;
constexpr char letters[] = "0123456789ABCDEF";
template <unsigned Index>
constexpr char code[5]{letters[Index / 4096 % 16], letters[Index / 256 % 16], letters[Index / 16 % 16],
                       letters[Index % 16], 0};

/// Four registers take five words where the last is wide, and behind sixteen registers there is a gap.
constexpr unsigned address_of(unsigned index) { return 100 + index / 4 * 5 + index % 4 + index / 16; }
constexpr bool is_read_only(unsigned index) { return index % 10 == 1; }
constexpr auto mode_of(unsigned index)
{
    return is_read_only(index) ? rtuwire::access::read_only : rtuwire::access::read_write;
}
constexpr std::uint32_t most_word = 5'000;
constexpr std::uint32_t most_wide = 500'000;

template <unsigned I>
constexpr reg<decihertz> narrow{
    .code = code<I>, .address = address_of(I), .mode = mode_of(I), .max = most_word, .factory = I};
template <unsigned I>
constexpr reg<unsigned32<>> wide{
    .code = code<I>, .address = address_of(I), .mode = mode_of(I), .max = most_wide, .factory = 100'000 + I};

template <bool HasWide, unsigned I> constexpr auto const& one() noexcept
{
    if constexpr (HasWide and I % 4 == 3) {
        return wide<I>;
    } else {
        return narrow<I>;
    }
}
template <bool HasWide, std::size_t... I>
bank<one<HasWide, (I * 377 + 5) % count>()...> bank_of(std::index_sequence<I...>);
template <bool HasWide> using thousand = decltype(bank_of<HasWide>(std::make_index_sequence<count>{}));

/// One word of a register.
struct cell {
    unsigned offset;
    unsigned width;
    bool is_writable;
    std::uint16_t word;
};

class model {
public:
    explicit model(bool has_wide)
    {
        for (unsigned i = 0; i < count; ++i) {
            bool const is_wide = has_wide and i % 4 == 3;
            unsigned const value = is_wide ? 100'000 + i : i;
            for (unsigned word = 0; word < (is_wide ? 2U : 1U); ++word) {
                cells_[address_of(i) + word] = {
                    word, is_wide ? 2U : 1U, i % 10 != 1,
                    static_cast<std::uint16_t>(is_wide and word == 0 ? value >> 16U : value)};
            }
        }
    }

    std::vector<std::uint8_t> read(unsigned start, unsigned words) const
    {
        if (not is_whole(start, words, false)) {
            return {0x83, 2};
        }
        std::vector<std::uint8_t> pdu{3, static_cast<std::uint8_t>(2 * words)};
        for (unsigned i = 0; i < words; ++i) {
            unsigned const word = cells_.at(start + i).word;
            pdu.push_back(static_cast<std::uint8_t>(word >> 8U));
            pdu.push_back(static_cast<std::uint8_t>(word));
        }
        return pdu;
    }

    std::vector<std::uint8_t> write(unsigned start, std::vector<std::uint16_t> const& words)
    {
        auto const size = static_cast<unsigned>(words.size());
        if (not is_whole(start, size, true)) {
            return {0x90, 2};
        }
        for (unsigned i = 0; i < size; ++i) {
            cell const& at = cells_.at(start + i);
            if (at.width == 1 ? words[i] > most_word
                              : at.offset == 0 and (std::uint32_t{words[i]} << 16U | words[i + 1]) > most_wide) {
                return {0x90, 3};
            }
        }
        for (unsigned i = 0; i < size; ++i) {
            cells_.at(start + i).word = words[i];
        }
        return {0x10, static_cast<std::uint8_t>(start >> 8U), static_cast<std::uint8_t>(start), 0,
                static_cast<std::uint8_t>(size)};
    }

private:
    bool is_whole(unsigned start, unsigned words, bool is_to_write) const
    {
        for (unsigned i = 0; i < words; ++i) {
            auto const at = cells_.find(start + i);
            if (at == cells_.end() or at->second.offset > i or at->second.width - at->second.offset > words - i or
                (is_to_write and not at->second.is_writable)) {
                return false;
            }
        }
        return true;
    }

    std::map<unsigned, cell> cells_;
};

template <typename Bank> std::vector<std::uint8_t> answer(Bank& bank, std::vector<std::uint8_t> const& request)
{
    std::array<std::byte, max_pdu_size> asked{};
    std::array<std::byte, max_pdu_size> place{};
    for (std::size_t i = 0; i < request.size(); ++i) {
        asked[i] = std::byte{request[i]};
    }
    std::vector<std::uint8_t> told;
    for (std::byte const each : respond(byte_view{asked}.first(request.size()), bank, server_profile{}, place)) {
        told.push_back(std::to_integer<std::uint8_t>(each));
    }
    return told;
}

struct tally {
    unsigned different{0}, read{0}, written{0}, refused_address{0}, refused_value{0};
};

template <bool HasWide> tally in_random_requests(unsigned rounds)
{
    thousand<HasWide> bank;
    model expected{HasWide};
    test::random random{HasWide ? 11U : 12U};
    tally found;
    for (unsigned round = 0; round < rounds; ++round) {
        unsigned const start = 90 + random.below(1'340);
        unsigned const size = 1 + random.below(round % 4 == 0 ? 100 : 9);
        std::vector<std::uint8_t> wanted;
        std::vector<std::uint8_t> request{3, static_cast<std::uint8_t>(start >> 8U), static_cast<std::uint8_t>(start),
                                          0, static_cast<std::uint8_t>(size)};
        if (random.below(2) == 0) {
            wanted = expected.read(start, size);
        } else {
            std::vector<std::uint16_t> words;
            request[0] = 0x10;
            request.push_back(static_cast<std::uint8_t>(2 * size));
            for (unsigned i = 0; i < size; ++i) {
                // Often a high word of a wide register, and now and then too much.
                words.push_back(
                    static_cast<std::uint16_t>(random.below(3) == 0 ? random.below(8) : random.below(5'600)));
                request.push_back(static_cast<std::uint8_t>(words.back() >> 8U));
                request.push_back(static_cast<std::uint8_t>(words.back()));
            }
            wanted = expected.write(start, words);
        }
        found.different += answer(bank, request) == wanted ? 0U : 1U;
        (wanted[0] == 3      ? found.read
         : wanted[0] == 0x10 ? found.written
         : wanted[1] == 2    ? found.refused_address
                             : found.refused_value) += 1;
    }
    return found;
}

template <bool HasWide> void check_random_requests()
{
    tally const found = in_random_requests<HasWide>(20'000);
    CHECK(found.different == 0);
    CHECK(found.read > 500);
    CHECK(found.written > 500);
    CHECK(found.refused_address > 500);
    CHECK(found.refused_value > 50);
}

} // namespace

TEST_CASE("a bank of a thousand registers of one word answers as a map of addresses does")
{
    check_random_requests<false>();
}

TEST_CASE("a bank of a thousand registers, of which some are wide, tears none of them")
{
    check_random_requests<true>();
}

TEST_CASE("each of a thousand registers is found by its name")
{
    thousand<true> bank;
    bank.set<narrow<998>>(decihertz{7});
    bank.set<wide<999>>(unsigned32<>::value_type{70'001});
    CHECK(bank.get<narrow<0>>() == decihertz{0});
    CHECK(bank.get<narrow<998>>() == decihertz{7});
    CHECK(bank.get<wide<999>>().count() == 70'001);
    CHECK(bank.get<wide<3>>().count() == 100'003);
    constexpr register_block one{5};
    CHECK(bank.write(address_of(4), one) == errc::none);
    CHECK(bank.take_written<narrow<4>>());
    CHECK_FALSE(bank.take_written<narrow<4>>());
    CHECK_FALSE(bank.take_written<narrow<5>>());
}

namespace {

template <bool HasWide, std::size_t... I>
table<one<HasWide, static_cast<unsigned>(I)>()...> table_of(std::index_sequence<I...>);
struct device {
    static constexpr literal name{"thousand"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{.read = 60};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 1> readable{{{0, 600}}};
    using registers = decltype(table_of<true>(std::make_index_sequence<count>{}));
};
template <std::size_t... I> read_plan<device, one<true, (I * 377 + 5) % count>()...> plan_of(std::index_sequence<I...>);
using plan = decltype(plan_of(std::make_index_sequence<count>{}));

} // namespace

TEST_CASE("a plan of a thousand registers reads each of them whole")
{
    plan::snapshot seen;
    for (std::size_t request = 0; request < plan::request_count; ++request) {
        address_block const block = plan::requests()[request];
        CHECK(block.count <= device::limits.read);
        std::vector<std::uint16_t> words;
        for (unsigned i = 0; i < block.count; ++i) {
            words.push_back(static_cast<std::uint16_t>(block.start + i));
        }
        seen.store(request, words);
    }
    CHECK(seen.get<narrow<0>>().count() == address_of(0));
    CHECK(seen.get<narrow<998>>().count() == address_of(998));
    CHECK(seen.get<wide<999>>().count() == (address_of(999) << 16U | (address_of(999) + 1)));
    CHECK(seen.get<wide<503>>().count() == (address_of(503) << 16U | (address_of(503) + 1)));
}
