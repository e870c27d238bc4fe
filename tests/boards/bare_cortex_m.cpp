// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The file for a Cortex-M without a library behind a UART that keeps one byte. QEMU runs it on two boards, too.
// PROCESSORS: cortex-m0plus cortex-m3 cortex-m4
#include "lives.hpp"

#define main run_board
#include "../../examples/boards/bare_cortex_m.cpp"
#undef main

namespace {

board::received word{};
bool has_word = false, is_lost = false;
stand_in::wire::time next_tick = 0;

void arrive(std::uint8_t byte, stand_in::arrival how)
{
    using stand_in::arrival;
    if (how == arrival::overrun or has_word) {
        is_lost = true;
    }
    word = {std::byte{byte}, how != arrival::good and how != arrival::overrun, is_lost};
    is_lost = false;
    has_word = true;
    on_line_interrupt();
}

struct bare_cortex_m {
    static constexpr auto timing = line_timing::host(19'200, character_format::even_8_1);
    static void open()
    {
        stand_in::line.on_byte = arrive;
        stand_in::line.on_room = [] { on_line_interrupt(); };
    }
    static void run() { run_board(); }
    template <typename Engine, typename Act> static void pass(Engine& link, Act act)
    {
        line.serve(link, board::now());
        act();
        board::sleep(line);
    }
};

} // namespace

namespace board {

bool line_uart::has_byte() { return has_word; }
received line_uart::take()
{
    has_word = false;
    return word;
}
bool line_uart::has_room() { return stand_in::line.waiting() == 0; }
void line_uart::put(std::byte value) { stand_in::line.put(std::to_integer<std::uint8_t>(value)); }
bool line_uart::is_idle() { return stand_in::line.is_idle(); }
void line_uart::clear_interrupts() {}
void line_uart::request_interrupt() { on_line_interrupt(); }
void driver_enable::set(bool is_on) { stand_in::line.drive(is_on); }
rtuwire::instant now() { return rtuwire::instant{stand_in::line.now_32()}; }
void wait()
{
    auto const now = stand_in::line.now();
    if (next_tick <= now) {
        next_tick = now + 1'000;
    }
    stand_in::line.pass_to_event(next_tick - now);
    if (stand_in::line.now() >= next_tick) {
        on_tick();
    }
}

} // namespace board

int main() { return stand_in::live<bare_cortex_m>(value, trouble); }
