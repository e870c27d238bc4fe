// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/played_capture.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>

#include "capture/capture_reader.hpp"
#include "exit_status.hpp"
#include "line/judged_frames.hpp"
#include "port/port_word.hpp"

namespace tool {

namespace {

/// Whether whoever captured a frame said what it is. Nobody calls a frame with a wrong CRC good: then nobody looked.
bool is_judged(rtuwire::traced_frame const& frame)
{
    bool const is_told = frame.role != rtuwire::frame_role::unknown or frame.verdict != rtuwire::frame_verdict::good;
    bool const is_good = frame.verdict == rtuwire::frame_verdict::good;
    return is_told and (not is_good or (frame.bytes.size() > 3 and rtuwire::crc16(frame.bytes) == 0));
}

/// From the first frame on: before that the bit rate is not known.
class player {
public:
    player(std::uint32_t rate, rtuwire::character_format format, std::uint64_t began, take_frame const& take)
        : wire_{rate, format}, take_{take}, judged_{wire_, take},
          tap_{std::make_unique<rtuwire::line_listener>(rtuwire::line_timing::host(rate, format))}, last_{began}
    {}

    void play(captured_frame const& captured)
    {
        if (captured.full_size != captured.frame.bytes.size() or captured.frame.bytes.empty()) {
            return; // cut by who captured it
        }
        std::uint64_t const at = captured.unix_microseconds;
        constexpr std::uint64_t longest_frame = 1'000'000;
        pass_until(at - std::min(at, longest_frame)); // a board without a calendar begins at 0
        last_ = at;
        if (is_judged(captured.frame)) {
            judged_.put(captured.frame, at);
        } else {
            tap_->receive(captured.frame.bytes, captured.frame.at, [this](auto const& it) { hand_on(it); });
        }
    }

    /// What still waits has ended.
    void finish()
    {
        judged_.finish();
        pass_until(last_ + 2'000'000);
    }

private:
    /// Lets a listener see the silence up to then. After two seconds of it nothing waits any more, and after another 35
    /// minutes no response is late, however long it is.
    void pass_until(std::uint64_t end)
    {
        constexpr std::uint64_t settled = 2'000'000;
        if (last_ < end) {
            last_ = end - last_ > settled ? last_ + settled : end;
            tap_->advance(instant_of(last_), [this](auto const& it) { hand_on(it); });
            constexpr rtuwire::duration longest = rtuwire::milliseconds(35 * 60 * 1'000); // that a time can lie ahead
            if (end - last_ > longest.microseconds) {
                tap_->advance(instant_of(last_) + longest, [this](auto const& it) { hand_on(it); });
            }
            last_ = end;
        }
    }
    static rtuwire::instant instant_of(std::uint64_t at) { return rtuwire::instant{static_cast<std::uint32_t>(at)}; }

    /// Its time is not far from the last one.
    void hand_on(rtuwire::heard_frame const& it)
    {
        auto const behind = static_cast<std::int32_t>((instant_of(last_) - it.frame.at).microseconds);
        take_({it, static_cast<std::uint64_t>(static_cast<std::int64_t>(last_) - behind), wire_});
    }

    rtuwire::line_timing wire_;
    take_frame const& take_;
    judged_frames judged_;
    std::unique_ptr<rtuwire::line_listener> tap_; ///< for frames that nobody judged
    std::uint64_t last_;
};

} // namespace

void play_capture(std::string const& file, line_setting how, take_frame const& take)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) {
        throw ended{exit_status::port, file + ": is a directory"};
    }
    std::ifstream in{file, std::ios::binary};
    if (not in) {
        throw ended{exit_status::port, file + ": " + std::strerror(errno)};
    }
    std::optional<player> frames;
    capture_reader reader;
    std::array<char, 65'536> piece;
    while (in.read(piece.data(), piece.size()), in.gcount() > 0) {
        reader.receive(std::as_bytes(std::span{piece.data(), static_cast<std::size_t>(in.gcount())}));
        while (auto const captured = reader.next()) {
            if (not frames) {
                std::uint32_t const rate = captured->bits_per_second != 0 ? captured->bits_per_second : how.baud;
                frames.emplace(rate, how.format, captured->unix_microseconds, take);
            }
            frames->play(*captured);
        }
    }
    reader.finish();
    if (frames) {
        frames->finish();
    }
    if (auto const wrong = reader.error(); wrong.why != capture_errc::none) {
        throw ended{exit_status::port, file + ": " + std::string{name(wrong.why)} + " at byte " +
                                           std::to_string(wrong.offset) + "; the frames before it were right"};
    }
}

bool is_capture(choices const& chosen)
{
    return std::holds_alternative<capture_file>(read_port_word(chosen.line.port).port);
}

std::string capture_in(choices const& chosen)
{
    if (not chosen.file.empty()) {
        return chosen.file;
    }
    port_choice const port = read_port_word(chosen.line.port);
    if (port.refused and not chosen.line.port.empty()) {
        refuse_word(port.refused->sentence);
    }
    if (auto const* const file = std::get_if<capture_file>(&port.port)) {
        return file->path;
    }
    refuse_word("which capture? say '" + chosen.command + " line.pcapng'");
}

} // namespace tool
