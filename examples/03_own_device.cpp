// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A device of one's own: a pump with three registers as rows, its server and a typed client.
#include <iostream>

#include <rtuwire/print.hpp>
#include <rtuwire/rows.hpp>
#include <rtuwire/rtuwire.hpp>

using namespace rtuwire;

namespace pump {

namespace rows {

using namespace row_words;

// clang-format off
inline constexpr register_row all[]{
    {"SET", 10, rw, in<decihertz>, 0,  600, {}, "Wanted frequency"},
    {"ACT", 11, ro, in<decihertz>, {}, {},  {}, "Frequency"},
    {"TMP", 12, ro, in<celsius>,   {}, {},  {}, "Temperature of the bearing"},
};
// clang-format on

} // namespace rows

struct device {
    static constexpr literal name{"pump"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using amounts = amount_types<decihertz, celsius>;
    using registers = row_table<device, table<>, rows::all>;
};
template <mnemonic Code> inline constexpr auto const& row = parameter_called<device, Code>;

} // namespace pump

int main()
{
    bank_of<pump::device> registers;
    registers.set<pump::row<"TMP">>(celsius{-5});
    constexpr station<pump::device> far_pump{unit_id{3}};
    auto const tell = write<pump::row<"SET">>(far_pump, 47.5_Hz);
    std::array<std::byte, max_pdu_size> place{};
    auto const asked = decode_adu(tell.next()->frame());
    auto const response = respond(asked->pdu(), registers, server_profile{}, place);
    bool const is_written = registers.take_written<pump::row<"SET">>();
    std::cout << "setpoint " << registers.get<pump::row<"SET">>() << ", bearing " << registers.get<pump::row<"TMP">>()
              << '\n';
    return is_written and response.size() == 5 ? 0 : 1;
}
