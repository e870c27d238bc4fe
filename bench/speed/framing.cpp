// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Frames made, taken apart, answered, and cut out of a stream.
#include <array>
#include <vector>

#include <benchmark/benchmark.h>

#include <rtuwire/core/hex.hpp>
#include <rtuwire/rtu/framer.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr unit_id one{1};
constexpr line_timing timing{19'200, character_format::even_8_1};

/// A response of function 03 with some registers.
std::vector<std::byte> response_of(std::size_t registers)
{
    std::vector<std::byte> frame(2 * registers + 5);
    frame[0] = std::byte{1};
    frame[1] = std::byte{3};
    frame[2] = static_cast<std::byte>(2 * registers);
    static_cast<void>(append_crc(frame, 2 * registers + 2));
    return frame;
}

void encode_read(benchmark::State& state)
{
    std::array<std::byte, 8> place{};
    std::uint16_t address = 3201;
    for (auto _ : state) {
        benchmark::DoNotOptimize(address);
        benchmark::DoNotOptimize(encode_into(place, one, read_holding_registers{address, 4}));
        benchmark::ClobberMemory();
    }
}
BENCHMARK(encode_read)->Name("codec alone/encode FC03");

void decode_response(benchmark::State& state)
{
    auto const frame = response_of(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) {
        benchmark::ClobberMemory();
        auto const response = decode_adu(frame);
        auto const read = read_holding_registers_response::decode(response->pdu());
        std::uint32_t sum = 0;
        for (std::size_t i = 0; i < read->registers.size(); ++i) {
            sum += read->registers[i];
        }
        benchmark::DoNotOptimize(sum);
    }
}
BENCHMARK(decode_response)->Name("codec alone/decode FC03")->Arg(1)->Arg(4)->Arg(63);

template <std::size_t Size> void serve(benchmark::State& state, std::array<std::byte, Size> request)
{
    std::array<std::byte, max_adu_size> place{};
    word_bank<16> bank;
    no_diagnostics none;
    for (auto _ : state) {
        std::copy(request.begin(), request.end(), place.begin());
        benchmark::DoNotOptimize(place);
        benchmark::DoNotOptimize(response_frame(place, Size, one, bank, server_profile{}, none));
        benchmark::ClobberMemory();
    }
}
BENCHMARK_CAPTURE(serve, read, "01 03 00 01 00 04 15 C9"_hex)->Name("codec alone/serve FC03 x4");
BENCHMARK_CAPTURE(serve, write, "01 10 00 01 00 04 08 00 01 00 02 00 03 00 04 D3 7A"_hex)
    ->Name("codec alone/serve FC16 x4");
BENCHMARK_CAPTURE(serve, exchange, "01 17 00 01 00 04 00 01 00 04 08 00 01 00 02 00 03 00 04 2B 29"_hex)
    ->Name("codec alone/serve FC23 4+4");

/// Full-length answers, one behind the other, in chunks.
void cut_stream(benchmark::State& state)
{
    auto const frame = response_of(125);
    auto const chunk = static_cast<std::size_t>(state.range(0));
    framer<direction::response> cutter{timing};
    instant const now{0};
    cutter.restart(now);
    for (auto _ : state) {
        byte_view rest = frame;
        while (not rest.empty()) {
            byte_view piece = rest.first(chunk < rest.size() ? chunk : rest.size());
            rest = rest.subspan(piece.size());
            while (not piece.empty()) {
                piece = piece.subspan(cutter.receive(piece, now));
            }
        }
        benchmark::DoNotOptimize(cutter.poll_frame());
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(frame.size()));
}
BENCHMARK(cut_stream)->Name("codec alone/framer by chunk")->Arg(1)->Arg(16)->Arg(256);

} // namespace
