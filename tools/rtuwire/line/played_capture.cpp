// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/played_capture.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>

#include "exit_status.hpp"

namespace tool {

namespace {

/// The listener, from the first frame on: before that the bit rate is not known.
class player {
public:
    player(line_setting const& how, take_frame const& take) : how_{how}, take_{take} {}

    void play(rtuwire::captured_frame const& captured)
    {
        if (captured.full_size != captured.frame.bytes.size()) {
            return; // cut by who captured it
        }
        if (not tap_) {
            std::uint32_t const rate = captured.bits_per_second != 0 ? captured.bits_per_second : how_.baud;
            tap_ = std::make_unique<rtuwire::line_listener>(rtuwire::line_timing::host(rate, how_.format));
            last_ = captured.unix_microseconds;
        }
        pass_until(captured.unix_microseconds - 1'000'000);
        last_ = captured.unix_microseconds;
        tap_->receive(captured.frame.bytes, captured.frame.at, [this](auto const& it) { hand_on(it); });
    }

    /// What still waits has ended.
    void finish()
    {
        if (tap_) {
            pass_until(last_ + 2'000'000);
        }
    }

private:
    /// In steps: a listener takes no more than 35 minutes at once.
    void pass_until(std::uint64_t end)
    {
        constexpr std::uint64_t longest = 1'000'000'000;
        while (last_ < end) {
            last_ = end - last_ > longest ? last_ + longest : end;
            tap_->advance(instant_of(last_), [this](auto const& it) { hand_on(it); });
        }
    }
    static rtuwire::instant instant_of(std::uint64_t at) { return rtuwire::instant{static_cast<std::uint32_t>(at)}; }

    /// Its time is not far from the last one.
    void hand_on(rtuwire::heard_frame const& it)
    {
        auto const behind = static_cast<std::int32_t>((instant_of(last_) - it.frame.at).microseconds);
        take_({it, static_cast<std::uint64_t>(static_cast<std::int64_t>(last_) - behind)});
    }

    line_setting how_;
    take_frame const& take_;
    std::unique_ptr<rtuwire::line_listener> tap_{};
    std::uint64_t last_{0};
};

} // namespace

void play_capture(std::string const& file, line_setting how, take_frame const& take)
{
    std::ifstream in{file, std::ios::binary};
    if (not in) {
        throw ended{exit_status::port, file + ": " + std::strerror(errno)};
    }
    player frames{how, take};
    rtuwire::capture_reader reader;
    std::array<char, 65'536> piece;
    while (in.read(piece.data(), piece.size()), in.gcount() > 0) {
        reader.receive(std::as_bytes(std::span{piece.data(), static_cast<std::size_t>(in.gcount())}));
        while (auto const captured = reader.next()) {
            frames.play(*captured);
        }
    }
    reader.finish();
    frames.finish();
    if (auto const wrong = reader.error(); wrong.why != rtuwire::capture_errc::none) {
        throw ended{exit_status::port, file + ": " + std::string{name(wrong.why)} + " at byte " +
                                           std::to_string(wrong.offset) + "; the frames before it were right"};
    }
}

} // namespace tool
