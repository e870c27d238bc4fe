// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lesson 11: the loop of a firmware: several conversations over one client, each begun again and again in its own time,
// and sleep in between. The board below is simulated, with a drive at the other end of its line; on a real one `send`
// starts the transmitter, interrupts fill the queue, and `sleep_until` waits for one of them or for the timer. Builds
// on lesson 3.
#include <cstdio>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

class simulated_board {
public:
    interrupt_queue<> line; // what the interrupts saw, with its times

    explicit simulated_board(line_timing const& times) : times_{times}, far_{unit_id{7}, times, now_}
    {
        far_.advance(now_); // the drive listens before the first request
    }

    instant now() const { return now_; }
    void send(byte_view frame)
    {
        now_ = now_ + times_.characters(frame.size()); // a real board goes on meanwhile
        far_.receive(frame, now_);
        line.sent(now_); // the interrupt of the last stop bit
    }
    void sleep_until(deadline due)
    {
        while (line.is_empty() and not(due and reached(now_, *due))) {
            now_ = now_ + microseconds(250);
            far_.advance(now_);
            if (byte_view const answer = far_.poll_transmit(); not answer.empty()) {
                for (std::byte const each : answer) {
                    now_ = now_ + times_.characters(1);
                    line.receive(each, now_);
                }
                far_.sent(now_);
            }
        }
    }

private:
    instant now_{0};
    line_timing times_;
    sim::unit<atv320::device> far_;
};

using monitor = read_plan<atv320::device, atv320::eta, atv320::rfr, atv320::lcr>;

} // namespace

int main()
{
    constexpr line_timing times{19'200, character_format::even_8_1};
    constexpr station<atv320::device> far{unit_id{7}};
    simulated_board board{times};
    client link{times};
    poller<monitor> panel{far};                                                               // each 100 ms
    single_request life_sign{far.unit(), write_single_register{.address = 8502, .value = 0}}; // LFR, each 250 ms
    instant panel_due = board.now(), life_sign_due = board.now();
    int rounds = 0, signs = 0, failures = 0;

    while (not reached(board.now(), instant{0} + milliseconds(1'000))) { // a firmware: for (;;)
        instant const now = board.now();
        board.line.deliver_to(link, now);
        link.advance(now);
        if (panel.settled() and reached(now, panel_due)) { // a round is over, and the next is due
            failures += panel.outcome() ? 0 : 1;
            ++rounds;
            panel.again();
            panel_due = now + milliseconds(100);
        }
        if (life_sign.settled() and reached(now, life_sign_due)) {
            failures += life_sign.outcome() ? 0 : 1;
            ++signs;
            life_sign.again();
            life_sign_due = now + milliseconds(250);
        }
        if (not panel.settled()) { // one that has ended rests: a visit would take its outcome back
            link.converse(panel, now);
        }
        if (not life_sign.settled()) { // in the same order in each pass
            link.converse(life_sign, now);
        }
        if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
            board.send(frame);
        }
        deadline wake = link.poll_deadline(); // and what is due while nothing is under way
        wake = panel.settled() ? earlier(wake, panel_due) : wake;
        wake = life_sign.settled() ? earlier(wake, life_sign_due) : wake;
        board.sleep_until(wake);
    }
    std::printf("in a second: %d rounds of %zu requests, %d writes, %d failures\n", rounds, monitor::request_count,
                signs, failures);
    std::puts("left: a drive that no loop asks any more trips at the end of its time-out (SLF1)");
    return rounds >= 9 and rounds <= 11 and signs >= 4 and signs <= 5 and failures == 0 ? 0 : 1;
}
