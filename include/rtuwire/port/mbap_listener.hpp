// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The other end of Modbus TCP as a port of RTU frames: what is read is a request, what is written the response to it. Servers so
// answer as the units behind a gateway.
#pragma once

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/port/chrono.hpp>
#include <rtuwire/port/mbap.hpp>
#include <rtuwire/port/platform.hpp>
#include <rtuwire/port/tcp_acceptor.hpp>
#include <rtuwire/port/tcp_stream.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Serves up to 8 clients, one request at a time, in turn. One more takes the place of the one whose last whole request is the
/// longest ago, 10 s at least; where all have asked since, it is hung up on. A request to a unit that is not there, or does not answer within
/// 0.5 s, is answered by exception 0B; nobody answers one to unit 0. Who sends what is no Modbus TCP is hung up on.
class mbap_listener {
public:
    /// Listens at an address of this machine, for these units. A client that has asked nothing whole for `idle` may lose its place.
    /// Errors, with a `failure()`: `device_not_found` (no such
    /// address here), `device_in_use`, `device_access_denied`, `timed_out`, `device_failed`.
    result<void> open(std::string const& host, std::uint16_t port, std::vector<std::uint8_t> units,
                      duration idle = milliseconds(10'000))
    {
        idle_ = to_chrono(idle);
        device_ = "mbap://" + (host.find(':') != host.npos ? "[" + host + "]" : host) + ":" + std::to_string(port);
        units_ = std::move(units);
        if (auto const opened = listening_.open(host, port, static_cast<int>(most_clients)); not opened) {
            failure_ = "mbap://" + listening_.failure();
            return opened;
        }
        return {};
    }

    /// "mbap://127.0.0.1:1502".
    [[nodiscard]] std::string const& device() const noexcept { return device_; }

    /// Why it does not listen, in words; empty before.
    [[nodiscard]] std::string const& failure() const noexcept { return failure_; }

    /// The response of a unit. What is none to the request under way goes nowhere, as does what its client does not take.
    result<void> write(byte_view frame, instant)
    {
        bool const is_response = asked_ and frame.size() >= min_adu_size and frame[0] == asked_->unit and
                                 (frame[1] & std::byte{0x7F}) == (asked_->function & std::byte{0x7F});
        if (is_response) {
            answer(*std::exchange(asked_, std::nullopt), frame.first(frame.size() - 2));
        }
        return {};
    }

    /// Waits until the deadline for a request, and gives it as a frame, for which `place` has 256 bytes; empty where none came.
    result<byte_span> read(byte_span place, instant until)
    {
        for (;;) {
            if (asked_ and reached(now(), asked_->give_up)) {
                refuse(*std::exchange(asked_, std::nullopt));
            }
            if (std::size_t const size = asked_ ? 0 : next_request(place); size > 0) {
                return place.first(size);
            }
            bool const is_limited = asked_ and reached(until, asked_->give_up);
            if (not wait(is_limited ? asked_->give_up : until) and not is_limited) {
                return place.first(0);
            }
        }
    }

    /// Now, on the clock of the deadlines.
    [[nodiscard]] static instant now() noexcept { return steady_now(); }

private:
    static constexpr std::size_t most_clients = 8;
    static constexpr duration longest_answer = milliseconds(500);

    struct client {
        tcp_stream line{};
        mbap_cutter came{};
        std::chrono::steady_clock::time_point asked{
            std::chrono::steady_clock::now()}; ///< last; a client may hang here for hours
    };
    /// The request that is with a unit.
    struct request {
        int client;
        std::uint16_t number;
        std::byte unit;
        std::byte function;
        instant give_up;
    };

    /// A whole message of one of the clients, as a frame; its size, 0 where there is none.
    std::size_t next_request(byte_span place)
    {
        for (std::size_t i = 0; i < clients_.size(); ++i) {
            client& from = clients_[(turn_ + i) % clients_.size()];
            while (auto const message = from.came.first()) {
                request const asked{from.line.descriptor_number(), message->number, message->body[0], message->body[1],
                                    now() + longest_answer};
                std::size_t const size = rtu_frame_of(*message, place).size();
                from.came.drop_first();
                from.asked = std::chrono::steady_clock::now();
                bool const is_to_all = asked.unit == std::byte{0};
                if (is_to_all or std::ranges::count(units_, detail::to_u8(asked.unit)) > 0) {
                    asked_ = is_to_all ? std::nullopt : std::optional{asked};
                    turn_ = (turn_ + i + 1) % clients_.size();
                    return size;
                }
                refuse(asked);
            }
        }
        return 0;
    }

    /// Whether anything came before then.
    bool wait(instant until)
    {
        std::vector<pollfd> watched{detail::watched(listening_.descriptor_number(), POLLIN)};
        for (client& each : clients_) { // what has no room is read once the requests before it have gone
            watched.push_back(detail::watched(each.came.room().empty() ? -1 : each.line.descriptor_number(), POLLIN));
        }
        instant const begin = now();
        duration const left = reached(begin, until) ? duration{} : until - begin;
        int const ready = detail::poll_for(watched.data(), static_cast<unsigned>(watched.size()), left);
        if (ready <= 0) {
            return ready < 0 and errno == EINTR;
        }
        for (std::size_t i = clients_.size(); i-- > 0;) {
            client& each = clients_[i];
            if (watched[i + 1].revents == 0) {
                continue;
            }
            std::ptrdiff_t const count = detail::read_some(each.line.descriptor_number(), each.came.room());
            each.came.add(count > 0 ? static_cast<std::size_t>(count) : 0);
            bool const is_gone = count == 0 or (count < 0 and errno != EAGAIN and errno != EINTR);
            if (is_gone or each.came.fault() != mbap_fault::none) {
                hang_up(i);
            }
        }
        if (watched[0].revents != 0) {
            take_client();
        }
        return true;
    }

    void hang_up(std::size_t index)
    {
        if (asked_ and asked_->client == clients_[index].line.descriptor_number()) {
            asked_.reset(); // its number may be the next client's
        }
        clients_.erase(clients_.begin() + static_cast<std::ptrdiff_t>(index));
        turn_ = 0;
    }

    /// Where all places are taken, that of who has asked nothing for longest.
    void make_place()
    {
        auto const idlest = std::ranges::min_element(clients_, {}, &client::asked);
        if (clients_.size() >= most_clients and std::chrono::steady_clock::now() - idlest->asked >= idle_) {
            hang_up(static_cast<std::size_t>(idlest - clients_.begin()));
        }
    }

    /// One more than there is room for is hung up on.
    void take_client()
    {
        make_place();
        auto line = listening_.accept();
        if (line and clients_.size() < most_clients) {
            clients_.push_back({std::move(*line), {}});
        }
    }

    void refuse(request const& asked)
    {
        std::byte const body[]{asked.unit, asked.function | std::byte{0x80},
                               static_cast<std::byte>(errc::gateway_target_failed_to_respond)};
        answer(asked, body);
    }

    /// A client that takes nothing any more loses this.
    void answer(request const& asked, byte_view body)
    {
        std::array<std::byte, max_mbap_size> place{};
        if (auto const message = write_mbap(place, {asked.number, body})) {
            static_cast<void>(detail::send_some(asked.client, *message));
        }
    }

    tcp_acceptor listening_{};
    std::vector<client> clients_{};
    std::chrono::microseconds idle_{};
    std::size_t turn_{0}; ///< the client whose request is next
    std::vector<std::uint8_t> units_{};
    std::optional<request> asked_{};
    std::string device_{};
    std::string failure_{};
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
