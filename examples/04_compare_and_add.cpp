// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lesson 4: to compute with values. An amount has a unit and a step (tenths of a hertz, whole volts); the library
// converts steps, and refuses to compare hertz with amperes when it compiles. There is no floating point in it. Builds
// on lesson 3.
#include <iostream>
#include <string>

#include <rtuwire/client.hpp>
#include <rtuwire/print.hpp>

using namespace rtuwire;

namespace {

int wrong = 0;

/// Prints a value, and notes where it is not what a calculator says.
template <typename Value> void show(char const* what, Value const& value, std::string const& expected)
{
    std::string const shown{text_of(value)};
    std::cout << what << ": " << shown << '\n';
    wrong += shown == expected ? 0 : 1;
}

} // namespace

int main()
{
    decihertz const speed{487};  // as a register holds it: 487 steps of 0.1 Hz
    hertz const limit = 50_Hz;   // another step of the same unit
    signed_rpm const back{-900}; // a register may be signed

    show("speed", speed, "48.7 Hz");
    show("below the limit", limit - speed, "1.3 Hz");
    show("and the other way round", speed - limit, "-1.3 Hz");
    show("both together", speed + limit, "98.7 Hz");
    show("twice, three times", 3 * speed - speed / 2, "121.8 Hz"); // a division cuts off: 24.3 Hz
    show("forward again", -back, "900 rpm");

    // Comparisons are by value, whatever the steps and signs.
    wrong += speed < limit and limit == decihertz{500} and signed_decihertz{-1} < decihertz{0} ? 0 : 1;

    // What does not fit is never cut: 7000.0 Hz is no number of tenths in 16 bits. Whether an amount of another program
    // fits is asked when it runs, see 05_write_at_run_time.
    // decihertz const top = 7000_Hz;     // does not compile: this_amount_does_not_fit_the_target
    // bool const odd = speed > 3_A;      // does not compile: these two measure different things
    show("to whole hertz, cut off", truncated_to<hertz>(speed), "48 Hz");

    // A product that is too large says so, in whatever is computed from it.
    show("far too much", 9'000'000'000'000'000'000 * speed - limit, "out of range");
    return wrong == 0 ? 0 : 1;
}
