// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "port/simulated_drives.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <future>
#include <system_error>
#include <thread>
#include <utility>

#include <rtuwire/port.hpp>

#include "../support/platform.hpp"
#include "port/inner_line.hpp"
#include "port/simulated_device.hpp"
#include "port/simulated_line.hpp"

namespace tool {

namespace {

/// Nothing delays the bytes of a pseudo-terminal inside a frame.
rtuwire::line_timing timing() noexcept { return rtuwire::line_timing::without_wire(rtuwire::milliseconds(5)); }

/// How long the drives wait for bytes before they look whether they shall end.
constexpr rtuwire::duration longest_pass = rtuwire::milliseconds(10);

} // namespace

class simulated_drives::running_line {
public:
    running_line(drives_end port, simulated_drives_choice const& choice)
        : port_{std::move(port)}, line_{port_, timing()}
    {
        for (simulated_drive_choice const& each : choice.drives) {
            add_to(line_, each, timing());
        }
        auto ready = is_ready_.get_future();
        {
            without_signals const kept;
            thread_ = std::thread{[this] { run(); }};
        }
        ready.wait();
    }
    running_line(running_line const&) = delete;
    running_line& operator=(running_line const&) = delete;
    ~running_line()
    {
        shall_end_ = true;
        thread_.join();
    }

private:
    void run()
    {
        // Nothing is heard before the line was silent once, and its silence is counted from the first pass on.
        rtuwire::result<void> passed = line_.pass({});
        rtuwire::instant const listening = port_.now() + timing().frame_end() + rtuwire::milliseconds(1);
        while (passed and not rtuwire::reached(port_.now(), listening)) {
            passed = line_.pass(rtuwire::milliseconds(1));
        }
        is_ready_.set_value();
        while (passed and not shall_end_) {
            passed = line_.pass(longest_pass);
        }
    }

    drives_end port_;
    simulated_line<drives_end> line_;
    std::promise<void> is_ready_{};
    std::atomic<bool> shall_end_{false};
    std::thread thread_{};
};

simulated_drives::simulated_drives() noexcept = default;
simulated_drives::simulated_drives(simulated_drives&& other) noexcept = default;
simulated_drives& simulated_drives::operator=(simulated_drives&& other) noexcept = default;
simulated_drives::~simulated_drives() = default;

bool simulated_drives::start(simulated_drives_choice const& choice)
{
    stop();
    drives_end port;
    if (not port.open()) {
        failure_ = "cannot allocate a pseudo-terminal";
        return false;
    }
    device_ = port.path();
    units_.clear();
    for (simulated_drive_choice const& each : choice.drives) {
        units_.push_back(each.unit);
    }
    std::ranges::sort(units_);
    try {
        line_ = std::make_unique<running_line>(std::move(port), choice);
    } catch (std::exception const& error) {
        failure_ = error.what();
        return false;
    }
    return true;
}

void simulated_drives::stop() noexcept { line_.reset(); }

} // namespace tool
