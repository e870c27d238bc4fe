// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A simulated drive in a process of its own, on a pseudo-terminal. It outlives whoever made it until
// its motor stands.
#pragma once

#include <csignal>
#include <cstdlib>
#include <string>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <rtuwire/port.hpp>

#include "../../tools/rtuwire/port/simulated_line.hpp"
#include "../../tools/support/line_reader.hpp"

namespace examples {

using namespace tool;

class simulated_process {
public:
    simulated_process() = default;
    simulated_process(simulated_process const&) = delete;
    simulated_process& operator=(simulated_process const&) = delete;

    ~simulated_process()
    {
        if (child_ > 0) {
            ::close(orders_);
            ::waitpid(child_, nullptr, 0);
        }
    }

    /// Starts it; false where the system has no pseudo-terminal or process to give.
    bool start(std::string const& name, std::uint32_t unit, rtuwire::line_timing const& timing)
    {
        rtuwire::pseudo_terminal port;
        int ends[2];
        if (not port.open() or ::pipe(ends) != 0) {
            return false;
        }
        child_ = ::fork();
        if (child_ == 0) {
            ::close(ends[1]);
            stand_apart();
            serve(port, name, unit, timing, ends[0]);
        }
        ::close(ends[0]);
        orders_ = ends[1];
        path_ = port.path();
        return child_ > 0;
    }

    std::string const& path() const { return path_; }

    /// Lets something happen to the drive: fault, clear, cut, join...
    bool suffer(std::string const& what) const
    {
        std::string const line = what + "\n";
        return ::write(orders_, line.data(), line.size()) == ssize_t(line.size());
    }

private:
    /// A drive hears nothing of the terminal that its controller is started from: whoever presses Ctrl-C or Ctrl-Z
    /// there, or closes it, needs a drive that can still be stopped. It does not hold the terminal or a pipe either.
    static void stand_apart() noexcept
    {
        ::setsid();
        for (int const each : {SIGTERM, SIGINT, SIGHUP, SIGQUIT}) {
            std::signal(each, SIG_DFL);
        }
        int const nowhere = ::open("/dev/null", O_RDWR);
        for (int const place : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
            ::dup2(nowhere, place);
        }
    }

    [[noreturn]] static void serve(rtuwire::pseudo_terminal& port, std::string const& name, std::uint32_t unit,
                                   rtuwire::line_timing const& timing, int from) noexcept
    {
        tool::simulated_line line{port, timing};
        line_reader input{from};
        line.add(name, unit);
        bool is_good = true;
        while (is_good and not(input.has_ended() and line.is_at_rest())) {
            is_good = line.pass(rtuwire::milliseconds(10)).has_value();
            while (auto const order = input.next()) {
                line.find(unit)->suffer(*order, line.now());
            }
        }
        std::_Exit(is_good ? 0 : 1);
    }

    pid_t child_{-1};
    int orders_{-1};
    std::string path_{};
};

} // namespace examples
