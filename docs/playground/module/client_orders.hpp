// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What the client does: it watches the drive all the time, and carries out the orders of a person, each as a
// conversation of the library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>

#include "any_drive.hpp"
#include "order_log.hpp"

namespace playground {

/// What the client has to do with a motor that turns, or does not.
enum class standing : std::uint8_t {
    none,
    starting,
    ordered,
    stopping, ///< it was told to stop; after a halt it still has power
    given_up, ///< it got no answers, and has not read since that the motor has no power
};

/// A conversation that is under way, and the number of its order.
template <typename Conversation> struct given_order {
    std::optional<Conversation> conversation{};
    std::uint32_t number{0};
};

class client_orders {
public:
    explicit client_orders(any_drive& drive) : drive_{&drive} {}

    /// From now on the drive is watched; its time-out is made short enough to wait for, where it can be set.
    void begin(std::uint64_t now_us);

    /// The reference as a person typed it, in Hz: any text.
    void start(std::string_view reference, std::uint64_t now_us);
    void change(std::string_view reference, std::uint64_t now_us);
    void reset_fault(std::uint64_t now_us);
    /// A newer stop takes the place of one that has not ended.
    void stop(rtuwire::altivar::stop_by how, std::string const& what, std::uint64_t now_us);

    /// One pass.
    void converse(link& line, rtuwire::instant now);

    [[nodiscard]] order_log const& log() const noexcept { return log_; }
    [[nodiscard]] playground::standing standing() const noexcept { return standing_; }

private:
    using request = rtuwire::single_request<rtuwire::write_single_register>;

    template <typename Order> bool is_free(given_order<Order>& order, std::string const& what, std::uint64_t now_us);
    template <typename Order> void replace(given_order<Order>& order, std::string const& what, std::uint64_t now_us);
    template <typename Order>
    void give(given_order<Order>& order, std::string what, std::string_view reference, std::uint64_t now_us);
    void refuse(std::uint32_t number, rtuwire::errc wrong);
    template <typename Order>
    void attend(link& line, std::size_t slot, given_order<Order>& order, rtuwire::instant now);

    void note_standing(link const& line, rtuwire::instant now) noexcept;

    void end(request const& settled, std::uint32_t number);
    template <typename Order> void end(Order const& settled, std::uint32_t number);

    any_drive* drive_;
    given_order<request> set_time_out_{};
    given_order<rtuwire::altivar::start> start_{};
    given_order<rtuwire::altivar::change_reference> change_{};
    given_order<rtuwire::altivar::reset_fault> reset_{};
    given_order<rtuwire::altivar::stop> stop_{};
    order_log log_{};
    std::uint32_t rounds_of_start_{0}; ///< of the watch, when the last start ended
    rtuwire::instant end_of_start_{0};
    playground::standing standing_{playground::standing::none};
    bool is_watching_{false};
};

} // namespace playground
