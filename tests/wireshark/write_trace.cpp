// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Writes a capture file as a client traces its line: write_trace FILE udp|user0|rtac_serial|upper_pdu SCENE
// functions: one exchange of every function. drive: a client and a drive. troubles: one frame of every verdict.
// pairs COUNT: as many exchanges. A response comes 5 ms after its request, but for the late one.
#include <cstdlib>
#include <fstream>
#include <string>

#include <rtuwire/rtuwire.hpp>
#include <rtuwire/trace.hpp>

#include "../interop/conversation_of_all.hpp"

using namespace rtuwire;

namespace {

struct file_output {
    std::ofstream* file;

    void operator()(byte_view block) const
    {
        file->write(reinterpret_cast<char const*>(block.data()), static_cast<std::streamsize>(block.size()));
    }
};

/// A line that is traced by its client.
class traced_line {
public:
    traced_line(std::string const& name, capture_form form) : file_{name, std::ios::binary}, capture_{{&file_}}
    {
        capture_.begin({.form = form, .interface_name = "/dev/ttyUSB0", .bits_per_second = 19'200},
                       {.unix_microseconds = 1'700'000'000'000'000, .at = now_});
    }

    void request(byte_view frame, frame_verdict verdict = frame_verdict::good)
    {
        now_ = now_ + milliseconds(20);
        capture_.take({.bytes = frame,
                       .at = now_,
                       .role = frame_role::request,
                       .verdict = verdict,
                       .is_own = verdict != frame_verdict::foreign and verdict != frame_verdict::echo});
    }

    void response(byte_view frame, frame_verdict verdict = frame_verdict::good)
    {
        now_ = now_ + milliseconds(5);
        capture_.take({.bytes = frame, .at = now_, .role = frame_role::response, .verdict = verdict});
    }

    void other(byte_view bytes, frame_verdict verdict)
    {
        now_ = now_ + milliseconds(5);
        capture_.take({.bytes = bytes, .at = now_, .verdict = verdict});
    }

    void pause(duration length)
    {
        now_ = now_ + length;
        capture_.advance(now_);
    }

    bool is_good() { return file_.flush().good(); }

private:
    std::ofstream file_;
    pcapng_writer<file_output> capture_;
    instant now_{0xFFFF'0000U}; // the counter wraps soon
};

template <typename Request, typename Response>
void exchange_of(traced_line& line, unit_id unit, Request const& request, Response const& response)
{
    auto const asked = encode(unit, request);
    auto const said = encode(unit, response);
    line.request(*asked);
    line.response(*said);
}

void write_functions(traced_line& line)
{
    for (auto const& each : test::conversation_of_all()) {
        line.request(each.request);
        line.response(each.response);
    }
}

/// Registers of an ATV320 at unit 7, of an ATV12 at unit 3, and of a unit that the analyser was told nothing of.
void write_drive(traced_line& line)
{
    constexpr register_block status{0x0237, 500};
    constexpr register_block reverse{0x0237, 0xFFF6};
    constexpr register_block slow{123};
    exchange_of(line, unit_id{7}, read_holding_registers{3201, 2}, read_holding_registers_response{status});
    exchange_of(line, unit_id{7}, write_single_register{9001, 13}, write_single_register{9001, 13});
    exchange_of(line, unit_id{7}, write_multiple_registers{8501, register_block{6, 0xFE0C}},
                write_multiple_registers_response{8501, 2});
    exchange_of(line, unit_id{7}, read_write_multiple_registers{3201, 2, 8501, register_block{15, 500}},
                read_write_multiple_registers_response{reverse});
    exchange_of(line, unit_id{3}, read_holding_registers{3202, 1}, read_holding_registers_response{slow});
    exchange_of(line, unit_id{9}, read_holding_registers{3202, 1}, read_holding_registers_response{slow});
    exchange_of(line, unit_id{7}, write_single_register{9001, 13},
                exception_response{function_code::write_single_register, 3});
    auto const everyone = encode(broadcast, write_single_register{8501, 0});
    line.request(*everyone);
    auto const many = encode(broadcast, write_multiple_registers{8501, register_block{0, 0}});
    line.request(*many);
}

void write_troubles(traced_line& line)
{
    auto const asked = encode(unit_id{7}, read_holding_registers{3202, 1});
    constexpr register_block fifty_hertz{500};
    auto const said = encode(unit_id{7}, read_holding_registers_response{fifty_hertz});
    auto damaged = *said;
    damaged.storage()[4] ^= std::byte{1};
    line.request(*asked);
    line.request(*asked, frame_verdict::echo);
    line.response(damaged, frame_verdict::damaged);
    line.request(*asked);
    line.pause(milliseconds(300));
    line.response(*said, frame_verdict::late);
    line.request(*asked, frame_verdict::foreign);
    line.response(*said, frame_verdict::foreign);
    line.response(*said, frame_verdict::stray);
    line.other("00 FF 13"_hex, frame_verdict::stray);
    line.other(damaged, frame_verdict::damaged);
    line.pause(milliseconds(35 * 60'000)); // longer than two frames may lie apart
    line.pause(milliseconds(35 * 60'000));
    line.request(*asked);
    line.response(*said);
}

capture_form form_named(std::string const& name)
{
    return name == "user0"         ? capture_form::user0
           : name == "rtac_serial" ? capture_form::rtac_serial
           : name == "upper_pdu"   ? capture_form::upper_pdu
                                   : capture_form::udp;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 4) {
        return 2;
    }
    traced_line line{argv[1], form_named(argv[2])};
    std::string const scene = argv[3];
    if (scene == "functions") {
        write_functions(line);
    } else if (scene == "drive") {
        write_drive(line);
    } else if (scene == "troubles") {
        write_troubles(line);
    }
    return line.is_good() ? 0 : 1;
}
