// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A device of one's own: a pump with three registers, its server and a typed client.
#include <iostream>

#include <rtuwire/print.hpp>
#include <rtuwire/rtuwire.hpp>

using namespace rtuwire;

namespace pump {

inline constexpr reg<decihertz> setpoint{.code = "SET", .address = 10, .min = 0, .max = 600};
inline constexpr reg<decihertz> actual{.code = "ACT", .address = 11, .mode = access::read_only};
inline constexpr reg<celsius> bearing{.code = "TMP", .address = 12, .mode = access::read_only};

struct device {
    static constexpr literal name{"pump"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using registers = table<setpoint, actual, bearing>;
};

} // namespace pump

int main()
{
    bank<pump::setpoint, pump::actual, pump::bearing> registers;
    registers.set<pump::bearing>(celsius{-5});
    constexpr station<pump::device> far_pump{unit_id{3}};
    auto const tell = write<pump::setpoint>(far_pump, 47.5_Hz);
    std::array<std::byte, max_pdu_size> place{};
    auto const asked = decode_adu(tell.next()->frame());
    auto const response = respond(asked->pdu(), registers, server_profile{}, place);
    bool const is_written = registers.take_written<pump::setpoint>();
    std::cout << "setpoint " << registers.get<pump::setpoint>() << ", bearing " << registers.get<pump::bearing>()
              << '\n';
    return is_written and response.size() == 5 ? 0 : 1;
}
