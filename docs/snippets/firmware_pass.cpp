// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the page of the simulated drive shows of a firmware's own pass in a test: orders as members, in virtual time.
#include <iostream>
#include <optional>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

//! [application]
constexpr station<atv320::device> drive{unit_id{7}};

class application { // of the firmware and of its test
public:
    void press_start() { go_ = start{drive, 30_Hz}; }

    template <typename Link> void pass(Link& link, instant now) // what the loop does between receiving and sending
    {
        link.converse(ask_, now);
        if (ask_.settled()) {
            if (auto const read_now = ask_.outcome()) {
                speed_ = *read_now;
            }
            ask_.again();
        }
        if (go_ and not go_->settled()) {
            link.converse(*go_, now);
        }
    }

    signed_decihertz speed() const { return speed_; }
    bool is_started() const { return go_ and go_->succeeded(); }

private:
    decltype(read<atv320::rfr>(drive)) ask_ = read<atv320::rfr>(drive);
    std::optional<start> go_;
    signed_decihertz speed_{};
};
//! [application]

} // namespace

int main()
{
    //! [test]
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, drive};
    application app;
    app.press_start();
    auto const pass = [&](instant now) { app.pass(bench.link(), now); };
    bool const is_done = bench.run_until([&] { return app.is_started(); }, milliseconds(3'000), pass);
    std::cout << "done at " << app.speed() << '\n'; // the ramp has only begun
    bool const is_fast = bench.run_until([&] { return app.speed() == 30_Hz; }, milliseconds(10'000), pass);
    std::cout << "then " << app.speed() << '\n';
    //! [test]
    return is_done and is_fast ? 0 : 1;
}
