// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A unit of measure that rtuwire does not have.
#include <iostream>

#include <rtuwire/client.hpp>
#include <rtuwire/print.hpp>

using namespace rtuwire;

namespace {

//! [unit]
struct illuminance {
    static constexpr char symbol[] = "lx"; // what text_of shows after a count of whole steps
};
using lux = quantity<illuminance, std::uint16_t>;
using decilux = quantity<illuminance, std::uint16_t, std::deci>; // steps of 0.1 lx
template <char... D> consteval auto operator""_lx() noexcept { return spelled<illuminance, std::ratio<1>, D...>(); }

inline constexpr input_reg<decilux> light{.code = "LIGHT", .address = 3};
inline constexpr reg<float32<lux>> limit{.code = "LIMIT", .address = 8};
//! [unit]

} // namespace

int main()
{
    decilux const seen{5'005};
    std::cout << seen << (seen > 500_lx ? ", bright\n" : "\n");
    real<lux> const wanted{20.5F};
    bool const is_right = seen.as<double>() == 500.5 and wanted.as<double>() == 20.5 and
                          scaled<lux>{123, -1}.as<double>() == 12.3 and scaled<lux>{7, 2}.as<float>() == 700.0F;
    return is_right and light.address == 3 and limit.address == 8 ? 0 : 1;
}
