// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/exchange_log.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "exit_status.hpp"
#include "frame/hex_text.hpp"
#include "line/capture_output.hpp"
#include "line/open_line.hpp"
#include "line/time_text.hpp"
#include "output/passing_text.hpp"
#include "output/plain_text.hpp"

namespace tool {

namespace {

/// Of a run whose line could not be opened nothing stays.
class new_trace {
public:
    new_trace() = default;
    new_trace(new_trace const&) = delete;
    new_trace& operator=(new_trace const&) = delete;
    ~new_trace()
    {
        if (file_) {
            file_.reset(); // first: Windows removes none that is open
            std::remove(name_.c_str());
        }
    }

    void open(std::string const& name)
    {
        file_ = new_capture_file("--trace", name);
        name_ = name;
    }

    capture_output::stream take() { return std::move(file_); }
    explicit operator bool() const { return static_cast<bool>(file_); }

private:
    std::string name_{};
    capture_output::stream file_{nullptr, &std::fclose};
};

/// The file of this run, and the time by which both count.
struct kept_exchange {
    line_calendar calendar{unix_now()};
    new_trace opened{};
    bool was_opened{false};
    std::unique_ptr<capture_output> file{};
    std::optional<rtuwire::instant> latest{}; ///< of a frame
};

kept_exchange& exchange_kept()
{
    static kept_exchange all;
    return all;
}

/// Some frames matter more than their trace.
template <typename Action> void keep(line_choices const& chosen, Action&& action)
{
    try {
        action();
    } catch (ended const& why) {
        if (not chosen.is_trace_optional) {
            throw;
        }
        tell_at_once("rtuwire: " + plain_text(why.what()) + ": there is no trace\n");
    }
}

/// The end of a request is reckoned from the bit rate: where the line has no wire, its response comes before. No frame takes
/// longer than 5 s; what looks older comes behind a pause of an hour.
rtuwire::traced_frame in_order(rtuwire::traced_frame frame)
{
    constexpr rtuwire::duration longest = rtuwire::milliseconds(5'000);
    std::optional<rtuwire::instant>& latest = exchange_kept().latest;
    frame.at = latest and *latest - frame.at < longest ? *latest : frame.at;
    latest = frame.at;
    return frame;
}

/// "14.250 s  > 01 03 00 00 00 01 84 0A", "14.262 s  < 01 03 02 00 FF damaged".
void show_frame(rtuwire::traced_frame const& frame, rtuwire::byte_view passed)
{
    using rtuwire::frame_verdict;
    static std::uint64_t const begin = exchange_kept().calendar.of(frame.at);
    std::uint64_t const ms = (exchange_kept().calendar.of(frame.at) - begin) / 1'000U;
    std::string const text = hex_of(passed);
    rtuwire::literal const verdict = name(frame.verdict);
    std::array<char, 40> head{};
    std::snprintf(head.data(), head.size(), "%llu.%03u s  %c ", static_cast<unsigned long long>(ms / 1'000U),
                  static_cast<unsigned>(ms % 1'000U), frame.is_own ? '>' : '<');
    std::string const tail =
        frame.verdict == frame_verdict::good ? std::string{} : "  " + std::string{std::string_view{verdict}};
    tell_at_once(head.data() + text + tail + '\n');
}

} // namespace

void exchange_log::open_file(line_choices const& chosen)
{
    if (not chosen.trace_file.empty() and not std::exchange(exchange_kept().was_opened, true)) {
        keep(chosen, [&] { exchange_kept().opened.open(chosen.trace_file); });
    }
}

exchange_log exchange_log::of(line_choices const& chosen, line_setting const& how, any_port const& port)
{
    if (exchange_kept().opened) {
        keep(chosen, [&] {
            // The form is that of a serial line, whose frames have a CRC.
            bool const is_made_up = port.has_numbers();
            exchange_kept().file = std::make_unique<capture_output>(
                chosen.trace_file, exchange_kept().opened.take(),
                rtuwire::capture_options{.bits_per_second = is_made_up ? 0 : how.baud},
                (is_made_up ? "Modbus TCP, CRCs made up: " : "") + port.device(), exchange_kept().calendar);
        });
    }
    exchange_log log;
    log.port_ = &port;
    log.shown_ = chosen.is_verbose ? &port : nullptr;
    return log;
}

void exchange_log::take(rtuwire::traced_frame const& frame) noexcept
{
    constexpr auto write = static_cast<std::byte>(rtuwire::function_code::write_single_register);
    // What the port did not take is traced, too.
    sent_ += frame.is_own ? 1U : 0U;
    bool const has_passed = not frame.is_own or port_ == nullptr or port_->has_taken_last();
    if (has_passed and frame.verdict == rtuwire::frame_verdict::good and frame.bytes.size() > 1 and
        frame.bytes[1] == write) {
        written_ = std::max(written_, frame.is_own ? written_word::sent : written_word::confirmed);
    }
    try {
        owed_.note(frame);
        if (shown_ == nullptr and not exchange_kept().file) {
            return; // lines in threads of their own share nothing
        }
        rtuwire::traced_frame const next = in_order(frame);
        if (shown_ != nullptr) {
            show_frame(next, shown_->passed(next.bytes));
        }
        if (exchange_kept().file) {
            exchange_kept().file->put(next);
        }
    } catch (std::exception const& why) {
        exchange_kept().file.reset();
        tell_at_once("rtuwire: " + plain_text(why.what()) + ": the trace ends here\n");
    }
}

} // namespace tool
