// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lesson 16: an I/O module on the line of a drive, polled by the same bus: coils, discrete inputs and values by name as
// rows, and a word of several fields. Where a contact changes, two outputs are switched by one request. Both units are
// simulated here. Builds on lessons 6 and 15.
#include <iostream>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/rows.hpp>
#include <rtuwire/rtuwire.hpp>

using namespace rtuwire;

namespace module {

namespace rows {

using namespace row_words;

inline constexpr choice sources[]{{1, "mains"}, {4, "battery"}};

// clang-format off
inline constexpr register_row all[]{
    {"H1",     0, coil_rw,  in<bool>, {}, {}, {}, "Lamp"},
    {"H2",     1, coil_rw,  in<bool>, {}, {}, {}, "Horn"},
    {"S1",     0, discrete, in<bool>, {}, {}, {}, "Guard"},
    {"S2",     1, discrete, in<bool>, {}, {}, {}, "Reset"},
    {"SUPPLY", 0, input,    sources,  {}, {}, {}, "Where its power comes from"},
};
// clang-format on

} // namespace rows

/// Two values in one word: bits 0 to 3 and bits 8 to 11.
inline constexpr field<count16, 0, 4> slot{};
inline constexpr field<count16, 8, 4> revision{};
inline constexpr input_reg<packed<slot, revision>> identity{.code = "ID", .address = 1};

struct device {
    static constexpr literal name{"I/O module"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using amounts = amount_types<>;
    using registers = row_table<device, table<identity>, rows::all>;
};
template <mnemonic Code> inline constexpr auto const& row = parameter_called<device, Code>;

using registers = bank_of<device>;

} // namespace module

int main()
{
    constexpr station<altivar::atv320::device> drive{unit_id{7}};
    constexpr station<module::device> far_module{unit_id{4}};

    module::registers inside;
    inside.set<module::row<"SUPPLY">>(named<"battery">);
    inside.set<module::identity>({0x0305});
    sim::bench bench{bus<2>{line_timing{19'200, character_format::even_8_1}}, drive,
                     bank_at{far_module.unit(), inside}};

    // Functions 01, 02 and 04: one request for each kind.
    using inputs = read_plan<module::device, module::row<"S1">, module::row<"S2">, module::row<"H1">,
                             module::row<"SUPPLY">, module::identity>;
    static_assert(inputs::request_count == 3);
    poller<inputs> panel{far_module};
    auto status = read<altivar::atv320::eta>(drive);
    if (not bench.run(panel, status) or not panel.outcome() or not status.outcome()) {
        return 1;
    }
    auto const& now = panel.latest();
    auto const supply = now.get<module::row<"SUPPLY">>();
    auto const identity = now.get<module::identity>();
    std::cout << "guard " << now.get<module::row<"S1">>() << ", supply " << name_of(supply) << ", slot "
              << identity.get<module::slot>() << ", revision " << identity.get<module::revision>() << '\n';

    // The guard opens: both outputs are switched by one request, function 15.
    inside.set<module::row<"S1">>(true);
    auto guard = read<module::row<"S1">>(far_module);
    if (not bench.run(guard, status) or not guard.outcome()) {
        return 1;
    }
    auto tell = write_all<module::row<"H1">, module::row<"H2">>(far_module, *guard.outcome(), true);
    bool const is_told = bench.run(tell, status) and tell.outcome();
    bool const is_lit = inside.get<module::row<"H1">>() and inside.take_written<module::row<"H2">>();
    return is_told and is_lit and supply == named<"battery"> ? 0 : 1;
}
