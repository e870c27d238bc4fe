// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Writes what passes on a line to a file that Wireshark reads, or to a pipe that it reads meanwhile.
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include "commands/commands.hpp"
#include "line/end_wish.hpp"
#include "line/tap.hpp"
#include "line/time_text.hpp"

namespace tool {

namespace {

rtuwire::capture_form form_of(std::string const& word)
{
    using rtuwire::capture_form;
    return word == "user0"       ? capture_form::user0
           : word == "rtac"      ? capture_form::rtac_serial
           : word == "upper-pdu" ? capture_form::upper_pdu
                                 : capture_form::udp;
}

/// A file, a pipe or standard output, that gets whole blocks.
class block_file {
public:
    explicit block_file(std::string const& name)
        : name_{name}, file_{name == "-" ? stdout : std::fopen(name.c_str(), "wb"), &std::fclose}
    {
        if (not file_) {
            fail();
        }
    }

    /// Each block leaves at once: somebody may be looking. A reader that went away ends the capture.
    void write(rtuwire::byte_view bytes)
    {
        if (is_open_ and (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size() or
                          std::fflush(file_.get()) != 0)) {
            if (errno != EPIPE) {
                fail();
            }
            is_open_ = false;
        }
    }
    bool is_open() const { return is_open_; }

private:
    [[noreturn]] void fail() const { throw ended{exit_status::port, name_ + ": " + std::strerror(errno)}; }

    std::string name_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    bool is_open_{true};
};

} // namespace

exit_status run_capture(choices const& chosen)
{
    note_signals();
    any_port port = open_to_listen(chosen);
    block_file file{chosen.file};
    rtuwire::pcapng_blocks blocks;
    std::size_t frames = 0;
    file.write(blocks.begin(
        {.form = form_of(chosen.capture_form), .interface_name = port.device(), .bits_per_second = chosen.line.baud},
        {.unix_microseconds = unix_now(), .at = port.now()}));
    listen(
        port, chosen.last,
        [&](tapped_frame const& it) {
            if (not it.heard.is_unanswered) {
                file.write(blocks.packet(it.heard.frame));
                ++frames;
            }
        },
        [&] {
            blocks.advance(port.now());
            return file.is_open();
        });
    std::fprintf(stderr, "%zu frames\n", frames);
    return exit_status::done;
}

} // namespace tool
