// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Captures: any bytes give the same frames and the same error however they are cut, and nothing reads outside; what
// the writer writes comes back as it was.
#include <memory>

#include <rtuwire/trace.hpp>

#include "capture/capture_reader.hpp"
#include "input.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace tool;
using fuzz::require;

namespace {

/// What a reader made of a file: a sum over all that it said.
struct reading_of_file {
    std::uint64_t sum{0};
    std::uint32_t frames{0};
    std::uint32_t skipped{0};
    capture_error error{};

    void add(std::uint64_t number) { sum = (sum ^ number) * 0x0000'0100'0000'01B3U; }
    void add(captured_frame const& captured)
    {
        ++frames;
        require(captured.full_size >= captured.frame.bytes.size());
        for (std::byte const each : captured.frame.bytes) {
            add(to_u8(each));
        }
        add(captured.unix_microseconds);
        add(captured.full_size);
        add(captured.bits_per_second);
        add(captured.line);
        add(static_cast<std::uint64_t>(captured.frame.role) << 8U |
            static_cast<std::uint64_t>(captured.frame.verdict) << 16U | (captured.frame.is_own ? 1U : 0U));
    }
    friend bool operator==(reading_of_file const&, reading_of_file const&) = default;
};

/// Reads a file in pieces of a size, each in memory that ends with it.
reading_of_file read(byte_view file, std::size_t step)
{
    auto const reader = std::make_unique<capture_reader>();
    reading_of_file found;
    for (std::size_t at = 0; at < file.size(); at += step) {
        std::size_t const size = step < file.size() - at ? step : file.size() - at;
        auto const piece = std::make_unique<std::byte[]>(size);
        for (std::size_t i = 0; i < size; ++i) {
            piece[i] = file[at + i];
        }
        reader->receive({piece.get(), size});
        while (auto const next = reader->next()) {
            found.add(*next);
        }
    }
    reader->finish();
    found.skipped = reader->skipped();
    found.error = reader->error();
    require(found.error.offset <= file.size());
    return found;
}

void pieces_are_all_the_same(byte_view file)
{
    auto const whole = read(file, file.size() + 1);
    for (std::size_t const step : {1U, 3U, 13U, 64U}) {
        require(read(file, step) == whole);
    }
}

constexpr capture_form forms[] = {capture_form::udp, capture_form::user0, capture_form::rtac_serial,
                                  capture_form::upper_pdu};

void what_is_written_comes_back(fuzz::input in)
{
    auto const reader = std::make_unique<capture_reader>();
    auto const blocks = std::make_unique<pcapng_blocks>();
    capture_form const form = forms[in.u8() % 4U];
    std::uint64_t time = std::uint64_t{in.u16()} << 32U;
    instant at{std::uint32_t{in.u16()} << 16U};
    reader->receive(blocks->begin({.form = form}, {.unix_microseconds = time, .at = at}));
    require(not reader->next());
    while (not in.is_empty()) {
        std::uint8_t const kind = in.u8();
        std::uint32_t const step = std::uint32_t{in.u16()} << (kind % 16U);
        at = at + duration{step};
        time += step;
        traced_frame const frame{.bytes = in.some(in.u8() + 1U),
                                 .at = at,
                                 .role = static_cast<frame_role>(kind % 3U),
                                 .verdict = static_cast<frame_verdict>(kind / 3U % 6U),
                                 .is_own = kind >= 128};
        reader->receive(blocks->packet(frame));
        auto const read = reader->next();
        require(read and same_bytes(read->frame.bytes, frame.bytes) and read->unix_microseconds == time and
                read->frame.role == frame.role and read->frame.verdict == frame.verdict and
                read->frame.is_own == frame.is_own);
    }
    reader->finish();
    require(reader->error() == capture_error{});
}

/// A file whose first blocks are right, so that more of the bytes are packets.
void behind_right_blocks(byte_view bytes, capture_form form)
{
    pcapng_blocks blocks;
    std::array<std::byte, 4096> file{};
    byte_writer out{file};
    out.bytes(blocks.begin({.form = form}, {.at = instant{0}}));
    out.bytes(blocks.packet({.bytes = bytes.first(bytes.size() < 200 ? bytes.size() : 200), .at = instant{0}}));
    std::size_t const room = file.size() - out.size();
    out.bytes(bytes.first(bytes.size() < room ? bytes.size() : room));
    pieces_are_all_the_same(out.written());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    byte_view const bytes{reinterpret_cast<std::byte const*>(data), size};
    pieces_are_all_the_same(bytes);
    behind_right_blocks(bytes, forms[size % 4]);
    what_is_written_comes_back({data, size});
    return 0;
}
