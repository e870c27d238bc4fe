// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Functions 03, 06, 16 and 23, asked one after the other without end by a client that has these four. LINE_IS_CONSTANT: the line's
// times are constants of the program. LONGEST_FRAME: the longest response. ENCODES: each request is encoded when it is asked.
#include "../images/board.hpp"

#include <array>

#include <rtuwire/client/client.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;

namespace {

using four = function_list<read_holding_registers, write_single_register, write_multiple_registers<>,
                           read_write_multiple_registers<>>;
constexpr line_timing timing{19'200, character_format::even_8_1};
#ifdef LINE_IS_CONSTANT
constexpr client_needs<four> needs{.timing = timing, .longest_frame = LONGEST_FRAME};
constinit basic_client<needs> link;
#else
constexpr client_needs<four> needs{.longest_frame = LONGEST_FRAME};
#endif

constexpr unit_id address{1};
constexpr register_block<4> words{1, 2, 3, 4};

#ifndef ENCODES
constexpr auto read = constant_frame([] { return encode(address, read_holding_registers{3201, 4}); });
constexpr auto write = constant_frame([] { return encode(address, write_single_register{8501, 6}); });
constexpr auto write_4 = constant_frame([] { return encode(address, write_multiple_registers{8501, words}); });
constexpr auto exchange = constant_frame([] {
    return encode(address, read_write_multiple_registers{3201, 4, 8501, words});
});
constexpr byte_view requests[] = {read, write, write_4, exchange};
#endif

class four_requests : public asker {
public:
    std::optional<request_frame> next()
    {
#ifdef ENCODES
        switch (number_) {
        case 0: return request_frame{*encode_into(place_, address, read_holding_registers{3201, 4})};
        case 1: return request_frame{*encode_into(place_, address, write_single_register{8501, 6})};
        case 2: return request_frame{*encode_into(place_, address, write_multiple_registers{8501, words})};
        default: break;
        }
        return request_frame{*encode_into(place_, address, read_write_multiple_registers{3201, 4, 8501, words})};
#else
        return request_frame{requests[number_]};
#endif
    }

    void accept(result<response> const& outcome)
    {
        board::put(static_cast<std::byte>(outcome ? value_in(*outcome) : 0));
        number_ = (number_ + 1) % 4;
    }

    static bool settled() { return false; }

private:
    [[gnu::noinline]] std::uint16_t value_in(response const& got) const
    {
        if (number_ == 0) {
            auto const decoded = got.to<read_holding_registers>();
            return decoded ? decoded->registers[0] : std::uint16_t{0};
        }
        if (number_ == 3) {
            auto const decoded = got.to<read_write_multiple_registers<>>();
            return decoded ? decoded->registers[0] : std::uint16_t{0};
        }
        return 0;
    }

    unsigned number_{0};
#ifdef ENCODES
    std::array<std::byte, 32> place_{};
#endif
};

} // namespace

#ifndef LINE_IS_CONSTANT
char size_of_object[sizeof(basic_client<needs>)];
#endif

int main()
{
#ifndef LINE_IS_CONSTANT
    basic_client<needs> link{timing};
#endif
    for (four_requests conversation;;) {
        board::pass(link);
        link.converse(conversation, board::now());
    }
}
