// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/capture_output.hpp"

#include <cerrno>
#include <cstring>
#include <utility>

#include <rtuwire/port.hpp>

#include "../support/platform.hpp"
#include "capture/commented_block.hpp"
#include "exit_status.hpp"

namespace tool {

capture_output::capture_output(std::string const& file, rtuwire::capture_options options, std::string const& line,
                               line_calendar const& calendar)
    : capture_output{file, stream{file == "-" ? stdout : open_stream(file, "wb"), &std::fclose}, options, line,
                     calendar}
{}

capture_output::capture_output(std::string const& name, stream file, rtuwire::capture_options options,
                               std::string const& line, line_calendar const& calendar)
    : name_{name}, file_{std::move(file)}, calendar_{calendar}
{
    if (not file_) {
        fail();
    }
    options.interface_name = line;
    rtuwire::instant const now = rtuwire::steady_now();
    write(blocks_.begin(options, {.unix_microseconds = calendar.of(now), .at = now}));
}

void capture_output::put(rtuwire::traced_frame const& frame)
{
    write(blocks_.packet(frame));
    ++frames_;
}

void capture_output::put(rtuwire::traced_frame const& frame, std::string const& comment)
{
    write(commented(blocks_.packet(frame), comment));
    ++frames_;
}

void capture_output::write(rtuwire::byte_view bytes)
{
    if (is_open_ and
        (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size() or std::fflush(file_.get()) != 0)) {
        if (not is_reader_gone()) {
            fail();
        }
        is_open_ = false;
    }
}

void capture_output::fail() const { throw ended{exit_status::port, name_ + ": " + std::strerror(errno)}; }

capture_output::stream new_capture_file(std::string const& option, std::string const& name)
{
    capture_output::stream file{new_stream(name), &std::fclose};
    if (not file) {
        throw ended{exit_status::port,
                    option + ' ' + name + ": " + (errno == EEXIST ? "is there already" : std::strerror(errno))};
    }
    return file;
}

rtuwire::capture_form capture_form_in(std::string const& word)
{
    using rtuwire::capture_form;
    return word == "user0"       ? capture_form::user0
           : word == "rtac"      ? capture_form::rtac_serial
           : word == "upper-pdu" ? capture_form::upper_pdu
                                 : capture_form::udp;
}

} // namespace tool
