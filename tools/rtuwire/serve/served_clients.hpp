// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The clients of a line: their connections, taken, read and answered while the line is waited for, too. One thread; no
// connection keeps another, or the line, waiting, and none holds more than a few requests and answers.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <rtuwire/port.hpp>

#include "../support/platform.hpp"
#include "port/any_port.hpp"
#include "serve/client_requests.hpp"
#include "serve/request_queue.hpp"
#include "serve/serve_counts.hpp"
#include "serve/serve_events.hpp"
#include "serve/serve_settings.hpp"

namespace tool {

class served_clients : public port_attendant {
public:
    static constexpr std::size_t most_clients = 32;
    static constexpr std::size_t most_readers = 8;             ///< of the metrics
    static constexpr std::chrono::seconds longest_untaken{10}; ///< an answer, by its client
    static constexpr std::chrono::seconds longest_reader{5};
    /// Where the system has no room for a connection, it is not asked again at once.
    static constexpr std::chrono::milliseconds accept_pause{100};
    static constexpr std::size_t most_told = 256; ///< refusals in words: no client fills a log
    static constexpr std::size_t most_noted = 20; ///< as events, each second

    /// `grace`: how long the line is waited for once the end was asked for.
    served_clients(serve_settings const& settings, serve_counts& counts, serve_events const& events,
                   std::chrono::microseconds grace)
        : settings_{settings}, counts_{counts}, events_{events}, grace_{grace}
    {}

    /// Takes the addresses, and serves nobody yet. Ends where it cannot, and where --write would be anybody's.
    void listen();
    /// "mbap://127.0.0.1:1502": where it listens first.
    [[nodiscard]] std::string place() const { return place_of(listeners_.front()); }
    /// Says where it listens. From here on signals are noted, and seen at once.
    void begin();

    /// Serves the clients until the descriptor can be read.
    void wait(int descriptor, rtuwire::instant until) override;
    [[nodiscard]] bool is_over() const override;
    /// The same, or until then. Whether it can be read.
    bool wait_for_bytes(int descriptor, serve_time until);

    /// Serves the clients until one of them has a request whose turn it is, or then; `line`: whose end is noticed, -1 for none. False where
    /// that has ended.
    [[nodiscard]] bool wait_for_request(int line, serve_time until);

    /// Whether a signal or the time limit asks for the end.
    [[nodiscard]] bool is_ending() const { return ends_at_.has_value(); }

    [[nodiscard]] std::optional<served_request> take();
    /// It had no response, and is to be sent again: with the next turn of its client, so that others have theirs before.
    void put_back(served_request request);
    /// As in `request_queue`.
    void refuse_at_once(std::function<bool(std::uint8_t)> of_unit) { queue_.refuse_at_once(std::move(of_unit)); }
    void leave_alone(served_request const& unanswered, serve_time all, serve_time others)
    {
        queue_.leave_alone(unanswered, all, others);
    }
    void keep(std::uint8_t unit, serve_time until) { queue_.keep(unit, until); }
    void note_kept_done(std::uint8_t unit) { queue_.note_kept_done(unit); }
    [[nodiscard]] bool is_held(served_request const& request, serve_time at) const
    {
        return queue_.is_held(request, at);
    }
    /// Who sent it, by its address.
    [[nodiscard]] std::string client_of(served_request const& request);
    void answer(served_request const& to, rtuwire::byte_view pdu);
    void refuse(served_request const& to, rtuwire::errc exception);
    /// It was refused behind its queue.
    void note_refused(std::string const& kind, served_request const& request, std::string const& why);
    /// Nobody answers it.
    void finish(served_request const& request);

    /// Hands out the last answers, and hangs up.
    void end();

private:
    struct listener {
        client_protocol protocol;
        rtuwire::tcp_acceptor socket{};
    };
    struct client {
        std::uint64_t number;
        rtuwire::tcp_stream line;
        client_requests requests;
        serve_time heard;
        std::vector<std::byte> out{};          ///< that is to be taken
        std::optional<serve_time> out_since{}; ///< when it took none of it
        std::size_t waiting{0};                ///< requests that have no answer yet
        bool is_behind{false}; ///< a request was answered 06, and its client may have sent the next before it knew
        bool is_of_other_protocol{false}; ///< which was said
        std::string gone{};               ///< why it is hung up on
    };
    struct reader {
        rtuwire::tcp_stream line;
        serve_time ends;
        std::string in{};
        std::string out{};
        bool is_gone{false};
    };

    static std::string place_of(listener const& at)
    {
        return std::string{name_of(at.protocol)} + "://" + at.socket.device();
    }
    /// Waits once, and serves whom there is something of. Whether the descriptor has one of these events.
    bool pass(int descriptor, short events, serve_time until);
    serve_time next_deadline(serve_time until) const;
    /// Of RTU frames, which have no number, one request is taken at a time.
    static bool is_held(client const& one)
    {
        return not one.out.empty() or (one.requests.is_rtu() and one.waiting > 0);
    }
    /// When a client has asked nothing for too long; nothing while it waits for an answer.
    std::optional<serve_time> idle_ends(client const& one) const
    {
        return one.waiting > 0 ? std::nullopt : std::optional{one.heard + settings_.longest_idle};
    }
    void note_end(serve_time now);
    void take_clients(listener& at, serve_time now);
    void take_readers(serve_time now);
    void serve(client& one, short events, serve_time now);
    void take_requests(client& one, serve_time now);
    std::string words_of_other_protocol(client const& one) const;
    void take(client& one, served_request request);
    void send(client& one, serve_time now);
    /// A request that waited has its answer, or is to have none.
    static void finish(client& one, serve_time now);
    void answer(client& one, served_request const& to, rtuwire::byte_view pdu);
    void serve(reader& one, short events);
    void refuse_old(serve_time now);
    void hang_up();
    /// In words where `news` is new; without that the reason, or the kind where no request of one unit is refused.
    void note_refused(std::string const& kind, served_request const* request, std::string const& why,
                      std::string const& from, std::string const& news = {});
    client* find(std::uint64_t number);

    serve_settings const& settings_;
    serve_counts& counts_;
    serve_events const& events_;
    std::chrono::microseconds grace_;
    std::list<listener> listeners_{};
    rtuwire::tcp_acceptor metrics_{};
    std::list<client> clients_{};
    std::list<reader> readers_{};
    request_queue queue_{};
    std::set<std::string> told_{}; ///< what was refused before, in words
    serve_time noted_since_{};
    std::size_t noted_{0};
    std::uint64_t latest_number_{0};
    ending_seen_in_wait waiting_{};
    serve_time next_accept_{};
    std::optional<serve_time> last_{};    ///< when the time limit is over
    std::optional<serve_time> ends_at_{}; ///< when the line is waited for no more
};

} // namespace tool
