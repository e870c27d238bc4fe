// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "serve/served_clients.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "exit_status.hpp"
#include "frame/hex_text.hpp"
#include "line/end_wish.hpp"
#include "motion/raw_effect.hpp"
#include "serve/metrics_page.hpp"
#include "words/option_words.hpp"
#include "words/time_words.hpp"

namespace tool {

namespace {

using rtuwire::byte_view;
using rtuwire::errc;

#ifdef POLLRDHUP
constexpr short hung_up = POLLRDHUP;
#else
constexpr short hung_up = 0; // only where both directions have ended
#endif
constexpr short failed = POLLERR | POLLHUP | POLLNVAL;

serve_time now() { return std::chrono::steady_clock::now(); }

std::vector<std::byte> exception_to(served_request const& to, errc exception)
{
    return {to.pdu[0] | std::byte{0x80}, static_cast<std::byte>(exception)};
}

} // namespace

void served_clients::listen()
{
    for (listen_place const& each : settings_.listen) {
        listener made{each.protocol, {}};
        if (not made.socket.open(each.at.host, each.at.port, static_cast<int>(most_clients))) {
            throw ended{exit_status::port, std::string{name_of(each.protocol)} + "://" + made.socket.failure()};
        }
        if (settings_.gate.may_write and settings_.is_for_anybody() and
            not is_loopback(host_of(made.socket.device()))) {
            refuse_for_safety("--write with --listen " + place_of(made) +
                              ": whoever reaches that address could write; say --from with the clients that may");
        }
        listeners_.push_back(std::move(made));
    }
    if (settings_.metrics) {
        auto const& at = *settings_.metrics;
        if (not metrics_.open(at.host, at.port, static_cast<int>(most_readers))) {
            throw ended{exit_status::port, "--metrics: " + metrics_.failure()};
        }
    }
}

void served_clients::begin()
{
    note_signals();
    waiting_.begin();
    if (settings_.last) {
        last_ =
            now() + std::chrono::duration_cast<serve_time::duration>(std::chrono::duration<double>{*settings_.last});
    }
    for (listener const& each : listeners_) {
        std::string const where = place_of(each);
        events_.begin({{"listen", where}}, where + " listening");
    }
    if (metrics_.descriptor_number() >= 0) {
        std::string const where = "http://" + metrics_.device() + "/metrics";
        events_.begin({{"listen", where}}, where + " listening");
    }
}

void served_clients::wait(int descriptor, rtuwire::instant until)
{
    rtuwire::host_deadline const end{until};
    wait_for_bytes(descriptor, now() + rtuwire::to_chrono(end.left()));
}

bool served_clients::wait_for_bytes(int descriptor, serve_time until)
{
    for (;;) {
        bool const is_last = now() >= until;
        if (pass(descriptor, POLLIN, until)) {
            return true;
        }
        if (is_last or is_over()) {
            return false;
        }
    }
}

bool served_clients::is_over() const { return ends_at_ and now() >= *ends_at_; }

bool served_clients::wait_for_request(int line, serve_time until)
{
    for (client& each : clients_) { // what came behind a request that has its answer now
        take_requests(each, now());
    }
    for (;;) {
        serve_time const end = std::min(until, queue_.next_turn().value_or(until));
        bool const is_last = now() >= end;
        if (pass(line, hung_up, end)) {
            return false;
        }
        if (is_last or is_ending()) {
            return true;
        }
    }
}

std::optional<served_request> served_clients::take()
{
    auto request = queue_.take(now());
    counts_.queue = queue_.size();
    return request;
}

void served_clients::put_back(served_request request)
{
    if (find(request.client) != nullptr) {
        queue_.put_back(std::move(request));
    }
}

void served_clients::answer(served_request const& to, byte_view pdu)
{
    if (client* const one = find(to.client)) {
        finish(*one, now());
        answer(*one, to, pdu);
    }
}

void served_clients::refuse(served_request const& to, errc exception) { answer(to, exception_to(to, exception)); }

void served_clients::note_refused(std::string const& kind, served_request const& request, std::string const& why)
{
    note_refused(kind, &request, why, client_of(request));
}

std::string served_clients::client_of(served_request const& request)
{
    client const* const one = find(request.client);
    return one != nullptr ? one->line.device() : "a client that has left";
}

void served_clients::finish(served_request const& request)
{
    if (client* const one = find(request.client)) {
        finish(*one, now());
    }
}

void served_clients::finish(client& one, serve_time when)
{
    --one.waiting;
    one.heard = when; // from here on it may ask
}

void served_clients::end()
{
    rtuwire::instant const until = rtuwire::steady_now() + rtuwire::milliseconds(200);
    for (client& each : clients_) {
        static_cast<void>(each.line.write(each.out, until));
        each.gone = "serve ends";
    }
    hang_up();
    listeners_.clear();
    readers_.clear();
    metrics_.close();
}

void served_clients::note_end(serve_time at)
{
    if (not ends_at_ and (noted_signal() != 0 or (last_ and at >= *last_))) {
        ends_at_ = at + grace_;
    }
}

serve_time served_clients::next_deadline(serve_time until) const
{
    auto const sooner = [&until](std::optional<serve_time> at) { until = at ? std::min(until, *at) : until; };
    sooner(queue_.next_old());
    sooner(ends_at_ ? ends_at_ : last_);
    sooner(next_accept_ > now() ? std::optional{next_accept_} : std::nullopt);
    for (client const& each : clients_) {
        sooner(idle_ends(each));
        sooner(each.out_since ? std::optional{*each.out_since + longest_untaken} : std::nullopt);
        if (not is_held(each)) {
            sooner(each.requests.part_ends());
            sooner(each.requests.silence_ends());
        }
    }
    for (reader const& each : readers_) {
        sooner(each.ends);
    }
    return until;
}

bool served_clients::pass(int descriptor, short events, serve_time until)
{
    note_end(now());
    bool const can_accept = now() >= next_accept_;
    std::vector<pollfd> watched{watched_port(descriptor, events),
                                watched_port(can_accept ? metrics_.descriptor_number() : -1, POLLIN)};
    for (listener const& each : listeners_) {
        watched.push_back(watched_port(can_accept ? each.socket.descriptor_number() : -1, POLLIN));
    }
    for (client& each : clients_) {
        bool const can_take = not is_held(each) and not each.requests.room().empty();
        watched.push_back(
            watched_port(each.line.descriptor_number(),
                         static_cast<short>((can_take ? POLLIN : hung_up) | (each.out.empty() ? 0 : POLLOUT))));
    }
    for (reader const& each : readers_) {
        watched.push_back(watched_port(each.line.descriptor_number(), each.out.empty() ? POLLIN : POLLOUT));
    }
    auto const left = std::max(next_deadline(until) - now(), serve_time::duration{});
    int const ready = waiting_.wait(watched, left);
    serve_time const at = now();
    note_end(at);
    auto found = watched.begin();
    auto const next = [&found, ready] { return static_cast<short>(ready > 0 ? (found++)->revents : 0); };
    bool const is_line = next() != 0;
    bool const has_readers = next() != 0;
    std::vector<listener*> asked;
    for (listener& each : listeners_) {
        if (next() != 0) {
            asked.push_back(&each);
        }
    }
    for (client& each : clients_) {
        serve(each, next(), at);
    }
    for (reader& each : readers_) {
        serve(each, next());
    }
    for (listener* const each : asked) { // last: what is new here was not watched
        take_clients(*each, at);
    }
    if (has_readers) {
        take_readers(at);
    }
    refuse_old(at);
    hang_up();
    counts_.queue = queue_.size();
    return is_line;
}

void served_clients::take_clients(listener& at, serve_time when)
{
    auto line = at.socket.accept();
    if (not line) {
        next_accept_ = when + accept_pause;
        return;
    }
    std::string const name = line->device();
    bool const is_known =
        settings_.from.empty() or std::ranges::any_of(settings_.from, [host = host_of(name)](client_range const& each) {
            return each.has(host);
        });
    if (not is_known) {
        note_refused("from", nullptr,
                     name + " is none of " + option_words(settings_.gate.form, line_option::from) +
                         ", and was hung up on",
                     name);
    } else if (clients_.size() >= most_clients) {
        note_refused("clients", nullptr,
                     name + " was hung up on: " + std::to_string(most_clients) + " clients are connected", name);
    } else {
        clients_.push_back({++latest_number_, std::move(*line), client_requests{at.protocol}, when});
        ++counts_.connections;
        counts_.clients = clients_.size();
        events_.note("connect", {{"client", name}, {"listen", std::string{name_of(at.protocol)}}},
                     name + " is connected");
    }
}

void served_clients::take_readers(serve_time when)
{
    auto line = metrics_.accept();
    next_accept_ = line ? next_accept_ : when + accept_pause;
    if (line and readers_.size() < most_readers) {
        readers_.push_back({std::move(*line), when + longest_reader});
    }
}

void served_clients::serve(client& one, short events, serve_time when)
{
    bool const was_held = is_held(one);
    if ((events & failed) != 0 or (hung_up != 0 and (events & hung_up) != 0)) {
        one.gone = "it left";
        return;
    }
    if ((events & POLLOUT) != 0) {
        send(one, when);
    }
    bool has_read_all = not was_held and not one.requests.room().empty();
    if ((events & POLLIN) != 0 and not was_held) {
        rtuwire::byte_span const room = one.requests.room();
        auto const count = receive_at_once(one.line.descriptor_number(), room);
        if (not count) {
            one.gone = "it left";
            return;
        }
        if (*count > 0) {
            one.requests.add(*count, when);
            one.heard = when;
        }
        has_read_all = count < static_cast<ssize_t>(room.size());
    }
    take_requests(one, when);
    one.is_behind = one.is_behind and not(has_read_all and not one.requests.part_ends() and not queue_.has(one.number));
    bool const has_part = not is_held(one) and one.requests.part_ends() and *one.requests.part_ends() <= when;
    auto const idle_end = idle_ends(one);
    one.gone = not one.gone.empty()                                         ? one.gone
               : has_part                                                   ? "its request did not become whole in 10 s"
               : one.out_since and when >= *one.out_since + longest_untaken ? "it took no answer for 10 s"
               : idle_end and when >= *idle_end
                   ? "it asked nothing for " +
                         seconds_text(std::chrono::duration_cast<std::chrono::microseconds>(settings_.longest_idle))
                   : "";
    if (has_part) {
        note_refused("part", nullptr, one.line.device() + " was hung up on: " + one.gone, one.line.device());
    }
}

void served_clients::take_requests(client& one, serve_time when)
{
    while (not is_held(one) and one.gone.empty()) {
        auto request = one.requests.take(when);
        if (not request) {
            break;
        }
        take(one, std::move(*request));
    }
    if (one.requests.is_other_protocol() and not one.is_of_other_protocol) {
        one.is_of_other_protocol = true;
        note_refused("protocol", nullptr, words_of_other_protocol(one), one.line.device(),
                     host_of(one.line.device()) + (one.requests.is_rtu() ? " mbap" : " rtu"));
    }
    if (one.gone.empty() and one.requests.is_broken()) {
        constexpr std::size_t most = 24;
        rtuwire::byte_view const rest = one.requests.rest();
        one.gone = "what it sent is no Modbus TCP: " + hex_of(rest.first(std::min(rest.size(), most)));
        if (not one.is_of_other_protocol) {
            note_refused("protocol", nullptr, one.line.device() + " was hung up on: " + one.gone, one.line.device());
        }
    }
    if (std::size_t const dropped = one.requests.take_dropped(); dropped > 0) {
        note_refused("damaged", nullptr, std::to_string(dropped) + " bytes of " + one.line.device() + " were no frame",
                     one.line.device());
    }
}

std::string served_clients::words_of_other_protocol(client const& one) const
{
    auto const place_of = [this](client_protocol which) {
        auto const found = std::ranges::find(listeners_, which, &listener::protocol);
        return std::string{name_of(which)} + "://" +
               (found != listeners_.end() ? found->socket.device() : std::string{"ADDRESS:PORT"});
    };
    bool const is_rtu = one.requests.is_rtu();
    std::string const other = place_of(is_rtu ? client_protocol::mbap : client_protocol::rtu);
    return one.line.device() + (is_rtu ? " sends Modbus TCP" : " sends RTU frames") + " to " +
           place_of(is_rtu ? client_protocol::rtu : client_protocol::mbap) + ", which takes " +
           (is_rtu ? "RTU frames over TCP" : "Modbus TCP") + "; what it sends is for " +
           option_words(settings_.gate.form, line_option::listen, other);
}

void served_clients::take(client& one, served_request request)
{
    request.client = one.number;
    gate_verdict const verdict = judge_request(settings_.gate, request.unit, request.pdu);
    if (verdict.refused != errc::none) {
        note_refused(verdict.kind, &request, verdict.why, one.line.device());
        answer(one, request, exception_to(request, verdict.refused));
        return;
    }
    if (one.is_behind and not verdict.only_reads and not is_word_that_stops(request.pdu)) {
        note_refused("order", &request, "a write came behind a request that was answered 06", one.line.device());
        answer(one, request, exception_to(request, errc::server_device_busy));
        return;
    }
    counts_.note_request(request.unit, std::to_integer<std::uint8_t>(request.pdu[0]));
    served_request const kept = request;
    if (queue_.add(std::move(request))) {
        ++one.waiting;
        return;
    }
    one.is_behind = true;
    note_refused("queue", &kept, "too many requests wait", one.line.device());
    answer(one, kept, exception_to(kept, errc::server_device_busy));
}

void served_clients::answer(client& one, served_request const& to, byte_view pdu)
{
    if ((pdu[0] & std::byte{0x80}) != std::byte{0}) {
        counts_.note_exception(to.unit, std::to_integer<std::uint8_t>(pdu[1]));
    }
    if (to.unit == 0 and one.requests.is_rtu()) {
        return; // as on a line
    }
    std::vector<std::byte> const bytes = one.requests.answer(to, pdu);
    one.out.insert(one.out.end(), bytes.begin(), bytes.end());
    send(one, now());
}

void served_clients::send(client& one, serve_time when)
{
    auto const sent = send_at_once(one.line.descriptor_number(), std::as_bytes(std::span{one.out}));
    if (not sent) {
        one.gone = "it left";
        return;
    }
    one.out.erase(one.out.begin(), one.out.begin() + static_cast<std::ptrdiff_t>(*sent));
    if (one.out.empty()) {
        one.out_since.reset();
        one.requests.resume(when);
    } else if (*sent > 0 or not one.out_since) {
        one.out_since = when;
    }
}

void served_clients::serve(reader& one, short events)
{
    one.is_gone = now() >= one.ends or (events & failed) != 0;
    if ((events & POLLIN) != 0) {
        std::array<char, 1'024> bytes;
        auto const count = receive_at_once(one.line.descriptor_number(), std::as_writable_bytes(std::span{bytes}));
        one.is_gone = one.is_gone or not count;
        one.in.append(bytes.data(), count.value_or(0));
        one.out = http_response(one.in, [this] { return counts_.text(); }).value_or("");
    }
    if (not one.out.empty() and not one.is_gone) {
        auto const sent = send_at_once(one.line.descriptor_number(), std::as_bytes(std::span{one.out}));
        one.out.erase(0, sent.value_or(0));
        one.is_gone = not sent or one.out.empty();
    }
}

void served_clients::refuse_old(serve_time when)
{
    for (served_request const& each : queue_.take_old(when)) {
        if (client* const one = find(each.client)) {
            one->is_behind = true;
            note_refused("age", &each, "a request waited for " + std::to_string(request_queue::oldest.count()) + " s",
                         one->line.device());
            finish(*one, when);
            answer(
                *one, each,
                exception_to(each, each.sent > 0 ? errc::gateway_target_failed_to_respond : errc::server_device_busy));
        }
    }
}

void served_clients::hang_up()
{
    for (auto one = clients_.begin(); one != clients_.end();) {
        if (one->gone.empty()) {
            ++one;
            continue;
        }
        queue_.drop(one->number);
        events_.note("disconnect", {{"client", one->line.device()}, {"why", one->gone}},
                     one->line.device() + " is disconnected: " + one->gone);
        one = clients_.erase(one);
    }
    counts_.clients = clients_.size();
    std::erase_if(readers_, [](reader const& each) { return each.is_gone; });
}

void served_clients::note_refused(std::string const& kind, served_request const* request, std::string const& why,
                                  std::string const& from, std::string const& news)
{
    counts_.note_refused(kind);
    if (auto const at = now(); at - noted_since_ >= std::chrono::seconds{1}) {
        noted_since_ = at;
        noted_ = 0;
    }
    if (++noted_ > most_noted) {
        return; // counted all the same
    }
    record more{{"client", from}, {"kind", kind}};
    if (request != nullptr) {
        more.add("unit", std::uint64_t{request->unit});
        more.add("function", std::to_integer<std::uint64_t>(request->pdu[0]));
    }
    std::string const key = not news.empty() ? news : request != nullptr and request->unit != 0 ? why : kind;
    bool const is_news = told_.size() < most_told and told_.insert(key).second;
    is_news ? events_.tell("refused", more, why) : events_.note("refused", more, why);
}

served_clients::client* served_clients::find(std::uint64_t number)
{
    auto const found = std::ranges::find(clients_, number, &client::number);
    return found == clients_.end() ? nullptr : &*found;
}

} // namespace tool
