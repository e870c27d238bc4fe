// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A controller: brings a drive up, polls it and prints a line each second, and brings it down again. An error of
// this program stops the motor first. Which drive is chosen when compiling: -DRTUWIRE_DRIVE=atv320.
#include "board.hpp"
#include "last_words.hpp"
#include "line.hpp"

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>

#ifndef RTUWIRE_DRIVE
#define RTUWIRE_DRIVE atv320
#endif

using namespace rtuwire;
using namespace rtuwire::altivar;
namespace model = rtuwire::altivar::RTUWIRE_DRIVE;

namespace {

using monitor = read_plan<model::device, model::eta, model::rfr, model::lcr, model::uln>;

constexpr station<model::device> drive{unit_id{1}};
constexpr auto no_voltage = constant_frame([] {
    return encode(drive.unit(),
                  write_single_register{model::device::layout.cmd, cia402::word_of(cia402::command::disable_voltage)});
});
constexpr client_options patient{.response_timeout = milliseconds(500)};
// An emulated UART delivers in lumps, as a host's does; on a real board the times of
// line_timing{19'200, character_format::even_8_1} are the right ones.
constexpr line_timing timing = line_timing::host(19'200, character_format::even_8_1, milliseconds(20));

/// Shared by the interrupts and the loop.
constinit board::half_duplex_line<board::line_uart, board::driver_enable> line;

/// The client and what it does in each pass.
struct controller {
    static_drive_client<timing, 1, patient, line_statistics> link{};

    template <conversation Conversation> void pass(Conversation& conversation)
    {
        instant const now = board::now();
        line.serve(link, now);
        link.converse(conversation, now);
        board::sleep(line);
    }
    template <conversation Conversation> void run(Conversation& conversation)
    {
        while (not conversation.settled()) {
            pass(conversation);
        }
    }
};

bool report(literal what, reason const& how)
{
    board::print(what);
    board::print(how);
    board::print("\n");
    return how.kind == outcome_kind::succeeded;
}

void print_values(monitor::snapshot const& seen)
{
    board::print("output frequency ");
    board::print(seen.get<model::rfr>());
    board::print(", current ");
    board::print(seen.get<model::lcr>());
    board::print(", mains ");
    board::print(seen.get<model::uln>());
    board::print("\n");
}

using number = quantity<dimensionless, std::uint32_t>;

/// How often the line made the client ask once more.
void print_counts(counters const& seen)
{
    board::print("requests ");
    board::print(number{seen[line_event::request]});
    board::print(", repeated ");
    board::print(number{seen[line_event::repetition]});
    board::print("\n");
}

/// One round of the plan each second; false when one failed.
bool poll_rounds(controller& it, unsigned seconds)
{
    poller<monitor> panel{drive};
    for (unsigned second = 0; second < seconds; ++second) {
        instant const due = board::now() + milliseconds(1'000);
        panel.again();
        it.run(panel);
        if (not panel.outcome()) {
            board::print("no values: ");
            board::print(panel.outcome().error());
            board::print("\n");
            return false;
        }
        print_values(panel.latest());
        while (not reached(board::now(), due)) {
            line.serve(it.link, board::now());
            board::sleep(line);
        }
    }
    return true;
}

/// All zero until the program runs.
constinit controller it;

} // namespace

void on_line_interrupt() { line.on_interrupt(board::now()); }
void on_tick() { line.on_tick(board::now()); }

/// An error of this program must not leave the motor running. On bare metal the check that calls this is built with
/// -DRTUWIRE_CHECKED=1 only; without it the linker leaves this out.
void rtuwire::on_missing_value(rtuwire::errc) noexcept
{
    board::send_last(no_voltage);
    board::print("read a value that is not there; the motor was told to stop\n");
}

int main()
{
    board::start_interrupts();
    board::print("ready on ");
    for (char const* c = board::name; *c != '\0'; ++c) {
        char const letter[] = {*c, '\0'};
        board::print(literal{letter});
    }
    board::print("\n");
    start up{drive, 30_Hz};
    it.run(up);
    bool const is_up = report("start: ", up.reason());
    bool const is_seen = is_up and poll_rounds(it, 4);
    stop down{drive};
    it.run(down);
    print_counts(it.link.statistics().line());
    bool const is_down = report("stop: ", down.reason());
    return is_up and is_seen and is_down ? 0 : 1;
}
