// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/traffic.hpp"

#include <array>
#include <chrono>
#include <set>
#include <string>

#include <rtuwire/trace.hpp>

#include "exit_status.hpp"

namespace tool {

namespace {

/// Who was heard.
class talkers {
public:
    void note(rtuwire::heard_frame const& it)
    {
        bool const is_frame = it.frame.role != rtuwire::frame_role::unknown and not it.is_unanswered;
        frames_ += is_frame ? 1U : 0U;
        bytes_ += it.frame.bytes.size();
        if (is_frame) {
            units_.insert(it.unit());
        }
    }
    void note_damage() { is_damaged_ = true; }

    bool is_silent() const { return bytes_ == 0 and not is_damaged_; }

    std::string words(option_form form) const
    {
        if (frames_ == 0) {
            return std::to_string(bytes_) + " bytes that are no frame at this bit rate and format" +
                   advice(" (", option_words(form, line_option::find), " finds the right ones)");
        }
        std::string units;
        for (unsigned const each : units_) {
            units += (units.empty() ? "" : ", ") + std::to_string(each);
        }
        return std::to_string(frames_) + " frames of a client and of unit " + units;
    }

private:
    std::set<unsigned> units_{};
    std::size_t frames_{0};
    std::size_t bytes_{0};
    bool is_damaged_{false};
};

} // namespace

void refuse_traffic(any_port& port, rtuwire::duration time, option_form form)
{
    using clock = std::chrono::steady_clock;
    auto const end = clock::now() + rtuwire::to_chrono(time);
    rtuwire::line_listener tap{port.timing()};
    talkers heard;
    auto const note = [&heard](rtuwire::heard_frame const& it) { heard.note(it); };
    std::array<std::byte, 512> place;
    while (clock::now() < end) {
        auto const bytes = port.read(place, port.now() + rtuwire::to_duration(end - clock::now()));
        if (not bytes) {
            throw ended{exit_status::port, port.failure()};
        }
        tap.receive(*bytes, port.now(), note);
        if (port.take_receive_error()) {
            heard.note_damage();
        }
    }
    tap.advance(port.now() + rtuwire::milliseconds(2'000), note);
    if (not heard.is_silent()) {
        refuse_for_safety(port.device() + ": somebody is talking on this line: " + heard.words(form) +
                          ". A second client disturbs the first, and keeps a drive running that its own has left. To "
                          "speak all the same, say " +
                          option_words(form, line_option::no_listen));
    }
}

} // namespace tool
