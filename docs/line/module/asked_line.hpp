// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The line, as the page has it: the library's client, which is asked for values and nothing else; the listener, which hears
// everything; and the rules by which something may be sent at all. Bytes and times come in, events go out as JSON.
#pragma once

#include <array>
#include <coroutine>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <rtuwire/client.hpp>
#include <rtuwire/maintenance.hpp>
#include <rtuwire/trace.hpp>

#include "../../playground/module/frame_log.hpp"
#include "../../playground/module/json.hpp"
#include "steps.hpp"

namespace line_page {

using playground::json_text;

/// Microseconds by the clock of the page; the library's instants are their last 32 bits.
using microseconds = std::uint64_t;
[[nodiscard]] inline rtuwire::instant instant_of(microseconds at) noexcept
{
    return rtuwire::instant{static_cast<std::uint32_t>(at)};
}

struct line_setting {
    std::uint32_t baud;
    rtuwire::character_format format;
};

/// All that this page can ask: there is no request here that writes.
using any_read = std::variant<std::monostate, rtuwire::single_request<rtuwire::read_coils>,
                              rtuwire::single_request<rtuwire::read_discrete_inputs>,
                              rtuwire::single_request<rtuwire::read_holding_registers>,
                              rtuwire::single_request<rtuwire::read_input_registers>,
                              rtuwire::single_request<rtuwire::read_device_identification>>;

/// What came of a request.
struct answer {
    rtuwire::errc why{rtuwire::errc::none};
    std::vector<std::uint16_t> words{}; ///< registers; of coils and inputs 0 or 1 each
    std::vector<std::byte> pdu{};
    std::string bytes{}; ///< what came in its place, in hexadecimal
    std::string cause{}; ///< what these bytes tell of it

    [[nodiscard]] bool is_there() const noexcept { return why == rtuwire::errc::none or rtuwire::is_exception(why); }
};

/// What tells a response from others, as RTU has no numbers.
struct response_form {
    std::uint8_t unit{0};
    std::uint8_t function{0};
    std::uint8_t size{0}; ///< bytes of values; 0 of an identification

    bool operator==(response_form const&) const = default;
};

/// Why nothing is sent.
enum class phase : std::uint8_t {
    listening, ///< for the first second, or again
    quiet,     ///< nobody else was heard: it may ask
    others,    ///< frames that this page did not send
    noise,     ///< bytes that are no frames
};

class asked_line {
public:
    asked_line(line_setting how, microseconds now, microseconds unix_time);
    asked_line(asked_line const&) = delete;
    asked_line& operator=(asked_line const&) = delete;
    ~asked_line() = default;

    /// Another bit rate and format of the same port. Where it had listened already and heard nobody, it does not again. No unit is
    /// known any more, and no consent is left.
    void set(line_setting how, microseconds now);

    // The line.
    void receive(rtuwire::byte_view bytes, microseconds now);
    void receive_error(microseconds now);
    /// The port has taken the bytes of the last pass.
    void sent(microseconds now);
    /// One pass. The bytes to send now, valid until the next; empty for none.
    rtuwire::byte_view pass(microseconds now);
    /// How long the next pass has time, at most a quarter of a second.
    [[nodiscard]] microseconds time_left() const noexcept;

    /// Listens again for a second; what is under way ends.
    void listen();
    [[nodiscard]] line_page::phase phase() const noexcept { return phase_; }

    // What is done: one thing at a time.
    void run(std::string_view name, steps what);
    void stop(std::string_view why);
    [[nodiscard]] bool is_busy() const noexcept { return not job_.is_over(); }

    void set_timeout(rtuwire::duration timeout) noexcept { timeout_ = timeout; }

    /// A unit that is a drive, or may be one, is asked for its values only with somebody's consent.
    void note_drive(std::uint8_t unit, bool may_be_drive) noexcept { is_drive_[unit] = may_be_drive; }
    [[nodiscard]] bool is_drive(std::uint8_t unit) const noexcept { return is_drive_[unit]; }
    void consent(std::uint8_t unit) noexcept { has_consent_[unit] = true; }
    [[nodiscard]] bool may_poll(std::uint8_t unit) const noexcept { return not is_drive_[unit] or has_consent_[unit]; }

    // For what waits.
    struct waiting_for_answer {
        asked_line& line;
        any_read read;
        response_form form;

        static bool await_ready() noexcept { return false; }
        void await_suspend(std::coroutine_handle<> who) { line.begin(std::move(read), form, who); }
        answer await_resume() { return std::move(line.answer_); }
    };
    /// 1 to 4, and which; `invalid_function` is the answer of any other.
    [[nodiscard]] waiting_for_answer ask(std::uint8_t unit, std::uint8_t function, std::uint16_t start,
                                         std::uint16_t count);
    [[nodiscard]] waiting_for_answer ask_identity(std::uint8_t unit, std::uint8_t object);

    struct waiting_for_time {
        asked_line& line;
        microseconds until;

        static bool await_ready() noexcept { return false; }
        void await_suspend(std::coroutine_handle<> who)
        {
            line.waiting_ = who;
            line.wakes_at_ = until;
        }
        static void await_resume() noexcept {}
    };
    [[nodiscard]] waiting_for_time wait_until(microseconds until) { return {*this, until}; }
    [[nodiscard]] microseconds now() const noexcept { return now_; }

    // What there is to tell.
    template <typename Fill> void tell(std::string_view event, Fill const& fill)
    {
        json_text out = begin_event(event);
        fill(out);
        end_event(out);
    }
    void tell_failure(std::uint8_t unit, std::string_view what, answer const& failed);
    [[nodiscard]] std::string take_events();
    [[nodiscard]] playground::frame_log const& frames() const noexcept { return frames_; }
    [[nodiscard]] std::vector<std::byte> const& capture() const noexcept { return capture_; }
    /// By whose names the frames of a unit are explained; null for none. They must outlive this line.
    void explain_by(std::uint8_t unit, tool::register_names const* names) noexcept { names_[unit] = names; }
    [[nodiscard]] std::string explain(std::uint32_t frame) const
    {
        return frames_.explain(frame, names_[frames_.unit_of(frame)]);
    }

private:
    using client = rtuwire::host_client;

    [[nodiscard]] json_text begin_event(std::string_view event) const;
    void end_event(json_text& out);
    static rtuwire::client_options options() noexcept;
    void begin(any_read read, response_form form, std::coroutine_handle<> who);
    void note_owed();
    void keep_listening();
    void take(rtuwire::heard_frame const& heard);
    void note_others();
    void visit();
    void settle(rtuwire::result<rtuwire::response> const& outcome);
    void resume();
    void note_end();
    [[nodiscard]] bool may_leave(rtuwire::byte_view frame) const noexcept;
    void change_phase(line_page::phase to);

    client client_;
    rtuwire::line_listener listener_;
    rtuwire::pcapng_blocks blocks_{};
    std::vector<std::byte> capture_{};
    playground::frame_log frames_{};
    std::array<tool::register_names const*, 256> names_{};
    line_setting how_;

    microseconds now_;
    microseconds calendar_ahead_;
    microseconds listens_until_{0};
    microseconds wakes_at_{0};
    microseconds left_at_{0};
    line_page::phase phase_{line_page::phase::listening};
    std::size_t heard_bytes_{0}; ///< while it listens, or has heard others
    std::size_t heard_frames_{0};
    bool is_capture_full_{false};
    bool is_answer_ready_{false};

    steps job_{};
    std::string job_name_{};
    bool is_told_ended_{true};
    std::coroutine_handle<> waiting_{};
    any_read read_{};
    answer answer_{};
    response_form form_{};
    bool is_sent_{false};
    struct owed_response {
        response_form form;
        microseconds until;
    };
    std::vector<owed_response> owed_{}; ///< may still come
    rtuwire::duration timeout_{rtuwire::milliseconds(1'000)};
    std::vector<std::byte> received_{}; ///< since the request began
    std::vector<std::byte> leaving_{};
    std::vector<std::byte> last_sent_{};
    std::array<bool, 256> is_drive_{};
    std::array<bool, 256> has_consent_{};
    std::string events_{};
};

} // namespace line_page
