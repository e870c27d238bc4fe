// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client asks two units that are slow now and then, on a line with faults, and the client or the first unit is traced:
//
//     write_decisions FILE client|server SEED
//
// FILE is the capture of what it decided; standard output has the same as it was decided, a line a frame: microseconds
// since 1970, role, verdict, whether its own, bytes.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include <rtuwire/client.hpp>
#include <rtuwire/server.hpp>
#include <rtuwire/sim.hpp>
#include <rtuwire/trace.hpp>

#include "trace/asked_at_random.hpp"

using namespace rtuwire;

namespace {

constexpr line_timing timing{19'200, character_format::even_8_1};
constexpr std::uint64_t began = 1'700'000'000'000'000;

char const* word_of(frame_role role)
{
    return role == frame_role::request ? "request" : role == frame_role::response ? "response" : "unknown";
}

char const* word_of(frame_verdict verdict)
{
    switch (verdict) {
    case frame_verdict::good: return "good";
    case frame_verdict::damaged: return "damaged";
    case frame_verdict::late: return "late";
    case frame_verdict::foreign: return "foreign";
    case frame_verdict::echo: return "echo";
    case frame_verdict::stray: return "stray";
    }
    return "";
}

/// Says each frame, and gives it to a capture.
class told_and_kept {
public:
    explicit told_and_kept(std::ofstream* file) : file_{file}
    {
        if (file_ != nullptr) {
            write(blocks_.begin({.bits_per_second = 19'200}, {.unix_microseconds = began, .at = instant{0}}));
        }
    }

    void take(traced_frame const& frame) noexcept
    {
        if (file_ == nullptr) {
            return;
        }
        std::printf("%llu,%s,%s,%d,", static_cast<unsigned long long>(began + (frame.at - instant{0}).microseconds),
                    word_of(frame.role), word_of(frame.verdict), frame.is_own ? 1 : 0);
        for (std::byte const each : frame.bytes) {
            std::printf("%02X ", std::to_integer<unsigned>(each));
        }
        std::puts("");
        write(blocks_.packet(frame));
    }

private:
    void write(byte_view block)
    {
        file_->write(reinterpret_cast<char const*>(block.data()), static_cast<std::streamsize>(block.size()));
    }

    std::ofstream* file_;
    pcapng_blocks blocks_{};
};

} // namespace

int main(int argc, char** argv)
{
    if (argc != 4) {
        return 2;
    }
    std::ofstream file{argv[1], std::ios::binary};
    bool const is_client = std::string_view{argv[2]} == "client";
    auto const seed = static_cast<std::uint32_t>(std::strtoul(argv[3], nullptr, 10));
    told_and_kept traced{&file};
    told_and_kept nobody{nullptr};
    sim::line wire{timing, seed};
    wire.set_faults({.bit_errors = 100, .bursts = 20'000, .lost = 20'000, .delayed = 20'000, .delay = milliseconds(3)});
    using traced_client = client::traced_by<told_and_kept>;
    using unit = test::slow_unit<told_and_kept>;
    client_options const options{.response_timeout = milliseconds(30), .late_response = milliseconds(5), .retries = 1};
    detail::basic_bench<traced_client, sim::line, unit, unit> bench{
        timing, wire, traced_client{timing, options}, unit{unit_id{7}, timing, seed, is_client ? nobody : traced},
        unit{unit_id{8}, timing, seed + 1, nobody}};
    bench.link().trace_to(is_client ? traced : nobody);
    test::asks_anything asking{seed};
    bench.run_for(milliseconds(60'000), asking);
    return file.flush().good() ? 0 : 1;
}
