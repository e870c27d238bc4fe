// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The server with its framer and its times, all nineteen public functions and the counters of function 08. What the bank
// does itself for files and a queue is as little as it can be.
#include "board.hpp"

#include <rtuwire/server/banks.hpp>
#include <rtuwire/server/server.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr device_object objects[] = {{vendor_name, "A"}, {product_code, "B"}, {2, "1"}};
constexpr server_profile profile{.identity = identity_of<objects>};
constexpr unit_id address{1};

struct device : word_bank<16> {
    bit_bank<16> outputs{};
    bit_bank<16> contacts{};
    word_bank<16> measured{};
    std::array<std::byte, 2> id{};

    bit_bank<16>& coils() { return outputs; }
    bit_bank<16>& discrete_inputs() { return contacts; }
    word_bank<16>& input_registers() { return measured; }
    std::uint8_t exception_status() const { return static_cast<std::uint8_t>(get(0)); }
    byte_view server_id() const { return id; }
    errc read_fifo(std::uint16_t at, byte_writer& out) { return read(at, 1, out); }
    errc check_read_file(file_run run) const { return check_read(run.record, run.count); }
    errc read_file(file_run run, byte_writer& out) { return read(run.record, run.count, out); }
    errc check_write_file(file_run run, register_view values) const { return check_write(run.record, values); }
    errc write_file(file_run run, register_view values) { return write(run.record, values); }
};
device bank;

using engine = basic_server<serial_diagnostics, public_functions>;

/// Answers a request that waits. A function of its own, so that its stack is seen.
[[gnu::noinline]] void answer(engine& node) { node.serve(bank, board::now()); }

} // namespace

int main()
{
    engine node{address, line_timing{19'200, character_format::even_8_1}, profile};
    for (;;) {
        board::pass(node);
        answer(node);
    }
}
