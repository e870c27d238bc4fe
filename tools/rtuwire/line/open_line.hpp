// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line that is open, and a client on it.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <rtuwire/client.hpp>

#include "choices.hpp"
#include "exit_status.hpp"
#include "line/exchange_counts.hpp"
#include "line/exchange_log.hpp"
#include "line/raw_request.hpp"
#include "line/unit_address.hpp"
#include "port/any_port.hpp"

namespace tool {

/// What the client of a line may do: all, also read the only unit of a line at address 0. Each unit has a
/// place of its own for what it owes.
inline constexpr rtuwire::client_needs<> line_needs{.request_room = rtuwire::max_adu_size,
                                                    .quarantine_places = 247,
                                                    .motors = rtuwire::host_needs.motors,
                                                    .has_only_unit = true};

/// How a line is set.
struct line_setting {
    std::uint32_t baud;
    rtuwire::character_format format;
};

line_setting setting_in(line_choices const& line);

/// What a serial device is opened with.
rtuwire::serial_settings serial_settings_in(line_choices const& chosen, line_setting const& how);

/// The port is there, and its driver does not keep this bit rate or format.
class setting_refused : public ended {
public:
    using ended::ended;
};

/// The port that the choices name; refuses one that is none. Nothing is sent.
any_port open_port(line_choices const& chosen, line_setting const& how);

/// How far what asks a unit several things has come, in turns between those of others.
class earlier_turns {
public:
    /// The next turn begins it anew.
    void begin_anew() { *this = {}; }

private:
    friend class open_line;

    struct ending {
        std::vector<std::byte> request;
        rtuwire::errc why;
        std::vector<std::byte> response; ///< its PDU
    };

    std::vector<ending> endings_{}; ///< of what was asked, in its order
    std::size_t next_{0};           ///< that is told again in this turn
    std::size_t fresh_{0};          ///< none before is told again of a later request
    std::set<std::size_t> lost_{};  ///< of what was asked, what had no response the last time
    bool is_first_{true};           ///< turn
    bool has_asked_{false};         ///< in this turn
    bool is_slow_{false};           ///< some response did not come at once
};

/// Opens the port and listens before anything is sent, as the choices say: a line in use is refused, with who is
/// talking. Says what a request does to a drive's supervision.
class open_line {
public:
    open_line(line_choices const& chosen, line_setting const& how);
    /// With the setting of the choices.
    explicit open_line(line_choices const& chosen) : open_line{chosen, setting_in(chosen)} {}

    open_line(open_line const&) = delete;
    open_line& operator=(open_line const&) = delete;

    any_port& port() { return port_; }
    /// Of the options that a message names.
    option_form form() const { return form_; }
    /// For another client on its port.
    exchange_log& exchange() { return exchange_; }
    exchange_log const& exchange() const { return exchange_; }
    rtuwire::client_options const& options() const { return options_; }

    /// A conversation for this line.
    template <typename Conversation> in_step<Conversation> with(Conversation conversation)
    {
        return {exchange_.owed(), std::move(conversation)};
    }
    /// The same of one that others wait behind: it ends at the first silence, also of what is asked before it.
    template <typename Request> in_step<request_once<Request>> once(request_once<Request> asked)
    {
        return {exchange_.owed(), std::move(asked), 1};
    }
    /// Runs it to its end.
    template <typename Conversation> auto run(in_step<Conversation>& conversation) { return client_.run(conversation); }
    /// The same of one that commands a motor: it waits for nothing that its unit owes but as the library has it.
    template <typename Commander> auto command(Commander& commander) { return client_.run(commander); }

    /// Asks and waits for the outcome. The response is a view of this line's memory, valid until the next `ask`.
    template <typename Request>
    rtuwire::result<typename Request::response> ask(unit_address const& to, Request const& request)
    {
        return asked(to.byte(), request, [&] { return ask_at(to, request); });
    }
    /// The same of a unit of whom nobody expects a response: sent once, at once. What it says may be the answer to something before;
    /// it responds in any case.
    template <typename Request>
    rtuwire::result<typename Request::response> ask_once(rtuwire::unit_id to, Request const& request)
    {
        return asked(to.byte(), request, [&] { return answer_to<Request>(request_once<Request>{to, request}); });
    }

    /// Runs what asks a unit several things for one turn between those of others: up to the first response that does not come
    /// at once, and from there on each request is a turn. It runs from its begin each time, and what it asked in earlier turns
    /// ends as it did then, also where it asks the same again. Where a later turn has no response, and had one the last time,
    /// or was none yet, all is asked anew: another unit may be in the place of the one that answered before. Nothing where
    /// the rest is for later turns.
    template <typename Questions>
    auto ask_on(earlier_turns& so_far, Questions questions) -> std::optional<decltype(questions())>
    {
        begin_turn(&so_far);
        try {
            auto found = questions();
            begin_turn(nullptr);
            so_far.begin_anew();
            return found;
        } catch (turn_is_over const&) {
            begin_turn(nullptr);
            return std::nullopt;
        } catch (...) {
            begin_turn(nullptr);
            so_far.begin_anew();
            throw;
        }
    }
    /// Of what asks in turns: whether some of it may be of an earlier turn.
    bool asks_in_turns() const { return turns_ != nullptr and turns_->is_slow_; }
    /// From here on nothing ends as the same did that was asked before.
    void ask_anew()
    {
        if (turns_ != nullptr) {
            turns_->fresh_ = turns_->next_;
        }
    }
    /// From here on all is asked in one turn, and nothing from the begin again: in this one, or in the next where this one has
    /// asked what was slow.
    void ask_rest_at_once();

    /// What comes in so long a time, or earlier, answers nothing that is waited for; it may be owed. Ends where the port fails.
    void let_pass(std::chrono::microseconds time);

    /// From here on requests are counted there; null ends it.
    void count_in(exchange_counts* counts) { counts_ = counts; }

    /// Why the last request failed, with the frame that was refused: "right CRC, wrong length: the unit departs from the
    /// function's format: 6 bytes came, 5 are due: 01 83 02 00 F1 50"; as far as the bytes tell, with the cause and its
    /// remedy. Where the port has failed, its own words.
    std::string words_of_failure(rtuwire::errc why) const;
    /// That frame; empty where there is none.
    rtuwire::byte_view refused() const;

private:
    struct turn_is_over {};

    template <typename Request, typename Ask>
    rtuwire::result<typename Request::response> asked(std::uint8_t unit, Request const& request, Ask ask)
    {
        if (turns_ != nullptr) {
            std::array<std::byte, rtuwire::max_adu_size> memory;
            auto const frame = rtuwire::encode_into(memory, rtuwire::unit_id{1}, request);
            request_ = frame ? std::vector<std::byte>(frame->begin(), frame->end()) : std::vector<std::byte>{};
            request_.push_back(std::byte{unit}); // the frame is as of any unit, also where the only one is asked at 0
        }
        if (auto const* const before = asked_before()) {
            response_ = before->response;
            if (before->why != rtuwire::errc::none) {
                return before->why;
            }
            return rtuwire::response{response_}.template to<Request>();
        }
        auto const sent = exchange_.sent();
        auto const began = std::chrono::steady_clock::now();
        auto outcome = ask();
        std::chrono::duration<double, std::milli> const took = std::chrono::steady_clock::now() - began;
        note(outcome.error(), took);
        if (turns_ != nullptr) {
            keep_for_later_turns(outcome.error(), exchange_.sent() - sent, took);
        }
        return outcome;
    }
    /// Null ends it.
    void begin_turn(earlier_turns* of);
    /// How the next request ended in an earlier turn; null where it did not. Throws where it is one for a later turn.
    earlier_turns::ending const* asked_before();
    void keep_for_later_turns(rtuwire::errc outcome, unsigned long sendings,
                              std::chrono::duration<double, std::milli> took);
    template <typename Request>
    rtuwire::result<typename Request::response> ask_at(unit_address const& to, Request const& request)
    {
        if constexpr (not requires { requires Request::may_be_broadcast; }) {
            if (to.is_zero()) {
                return answer_to<Request>(with(rtuwire::single_request{rtuwire::only_unit, request}));
            }
        }
        return answer_to<Request>(with(rtuwire::single_request{rtuwire::unit_id{to}, request}));
    }
    /// Kept here: the response is a view of what the question has.
    template <typename Request, typename Question>
    rtuwire::result<typename Request::response> answer_to(Question question)
    {
        auto const outcome = client_.run(question);
        if (not outcome) {
            return outcome.error();
        }
        response_.assign(outcome->pdu().begin(), outcome->pdu().end());
        return rtuwire::response{response_}.template to<Request>();
    }
    void note(rtuwire::errc outcome, std::chrono::duration<double, std::milli> took);

    any_port port_;
    option_form form_;
    rtuwire::client_options options_;
    exchange_log exchange_;
    rtuwire::blocking_client<any_port, line_needs>::traced_by<exchange_log> client_;
    exchange_counts* counts_{nullptr};
    earlier_turns* turns_{nullptr};    ///< of what is asked now
    std::vector<std::byte> request_{}; ///< in turns, and its unit
    std::vector<std::byte> response_{};
};

/// What an error means for whoever called the program: silence is `no_answer`, a wrong answer is `differs`.
exit_status status_of(rtuwire::errc why);

/// Whether it is an exception of the unit itself; two are a gateway's, behind which the unit does not answer.
bool is_refusal_of_unit(rtuwire::errc why);

/// "no response in time": as the library says it; an exception with its code behind it.
std::string words_of(rtuwire::errc why);

} // namespace tool
