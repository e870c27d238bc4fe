// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A capture that is being written: a file, a pipe or standard output, that gets whole blocks of pcapng. Each leaves at
// once, so that whatever ends the program leaves a file that can be read.
#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>

#include <rtuwire/trace.hpp>

#include "line/line_calendar.hpp"

namespace tool {

class capture_output {
public:
    using stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

    /// Opens the file ("-": standard output) and says which line it is of. The bit rate is in `options`. Ends where the
    /// file cannot be written, as do all others. The calendar must outlive it.
    capture_output(std::string const& file, rtuwire::capture_options options, std::string const& line,
                   line_calendar const& calendar);
    /// The same with a file that is open.
    capture_output(std::string const& name, stream file, rtuwire::capture_options options, std::string const& line,
                   line_calendar const& calendar);

    void put(rtuwire::traced_frame const& frame);
    /// With a sentence of its own, which Wireshark shows as the comment of the packet.
    void put(rtuwire::traced_frame const& frame, std::string const& comment);
    /// The line was silent until then, now.
    void advance(rtuwire::instant now) { blocks_.advance(now, calendar_.of(now)); }

    /// False once the reader of a pipe has gone.
    bool is_open() const { return is_open_; }
    std::size_t frames() const { return frames_; }

private:
    void write(rtuwire::byte_view bytes);
    [[noreturn]] void fail() const;

    std::string name_;
    stream file_;
    line_calendar const& calendar_;
    rtuwire::pcapng_blocks blocks_{};
    std::size_t frames_{0};
    bool is_open_{true};
};

/// A new file. Ends where there is one of this name, which stays as it is; `option` says it in a message: "--trace".
capture_output::stream new_capture_file(std::string const& option, std::string const& name);

/// "udp", "user0", "rtac", "upper-pdu".
rtuwire::capture_form capture_form_in(std::string const& word);

} // namespace tool
