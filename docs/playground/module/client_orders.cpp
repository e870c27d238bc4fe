// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "client_orders.hpp"

#include "catalog/value_text.hpp"

namespace playground {

namespace {

constexpr std::uint16_t short_time_out = 30; // TTO, 0.1 s

std::string hertz(std::int16_t count) { return tool::amount_text(count, {1, 10}, "Hz"); }

std::string fault_text(tool::drive_catalog const& drive, std::uint16_t code)
{
    auto const* const entry = drive.by_code("LFT");
    return code == 0 or entry == nullptr ? std::string{} : "; " + tool::text_of(*entry, code);
}

/// The register that kept a drive from being ordered.
std::string finding_text(tool::drive_catalog const& drive, rtuwire::altivar::supervision_report const& found)
{
    auto const* const entry = drive.at(found.address);
    std::string const value = entry == nullptr ? std::to_string(found.word) : tool::text_of(*entry, found.word);
    std::string const label = entry == nullptr ? std::to_string(found.address) : std::string{entry->code};
    return found.address == 0 ? std::string{} : "; " + label + " is " + value;
}

} // namespace

void client_orders::begin(std::uint64_t now_us)
{
    is_watching_ = true;
    if (std::uint16_t const address = drive_->catalog().layout.safeguards.tto; address != 0) {
        set_time_out_.number = log_.add("set the drive's time-out to 3 s", now_us);
        set_time_out_.conversation.emplace(unit,
                                           rtuwire::write_single_register{.address = address, .value = short_time_out});
    }
}

void client_orders::start(std::int16_t decihertz, std::uint64_t now_us)
{
    if (is_free(start_, "start at " + hertz(decihertz), now_us)) {
        give(start_, decihertz, now_us);
    }
}

void client_orders::change(std::int16_t decihertz, std::uint64_t now_us)
{
    if (is_free(change_, "change to " + hertz(decihertz), now_us)) {
        give(change_, decihertz, now_us);
    }
}

void client_orders::reset_fault(std::uint64_t now_us)
{
    if (is_free(reset_, "reset the fault", now_us)) {
        drive_->make(reset_.conversation);
    }
}

void client_orders::stop(rtuwire::altivar::stop_by how, std::string const& what, std::uint64_t now_us)
{
    if (stop_.conversation) {
        log_.end(stop_.number, "a later stop took its place", false, now_us);
    }
    stop_.number = log_.add("stop: " + what, now_us);
    drive_->make(stop_.conversation, how);
}

void client_orders::converse(link& line, rtuwire::instant now, std::uint64_t now_us)
{
    std::size_t slot = 0;
    if (is_watching_) {
        drive_->watch(line, slot, now);
    }
    attend(line, ++slot, set_time_out_, now, now_us);
    attend(line, ++slot, start_, now, now_us);
    attend(line, ++slot, change_, now, now_us);
    attend(line, ++slot, reset_, now, now_us);
    attend(line, ++slot, stop_, now, now_us);
}

template <typename Order>
bool client_orders::is_free(given_order<Order>& order, std::string const& what, std::uint64_t now_us)
{
    std::uint32_t const number = log_.add(what, now_us);
    if (order.conversation) {
        log_.end(number, "not given: the one before has not ended", false, now_us);
        return false;
    }
    order.number = number;
    return true;
}

template <typename Order>
void client_orders::give(given_order<Order>& order, std::int16_t decihertz, std::uint64_t now_us)
{
    if (auto const wrong = drive_->make(order.conversation, decihertz); wrong != rtuwire::errc::none) {
        log_.end(order.number, "not given: " + std::string{name(wrong)}, false, now_us);
    }
}

template <typename Order>
void client_orders::attend(link& line, std::size_t slot, given_order<Order>& order, rtuwire::instant now,
                           std::uint64_t now_us)
{
    if (not order.conversation) {
        return;
    }
    line.converse(slot, *order.conversation, now);
    if (order.conversation->settled()) {
        end(*order.conversation, order.number, now_us);
        order.conversation.reset();
    }
}

void client_orders::end(request const& settled, std::uint32_t number, std::uint64_t now_us)
{
    auto const outcome = settled.outcome();
    bool const is_done = outcome.has_value();
    log_.end(number, is_done ? "done" : std::string{name(outcome.error())}, is_done, now_us);
}

template <typename Order> void client_orders::end(Order const& settled, std::uint32_t number, std::uint64_t now_us)
{
    rtuwire::altivar::reason const why = settled.reason();
    auto const text = rtuwire::altivar::text_of(why);
    std::string outcome{std::string_view{text}};
    outcome += fault_text(drive_->catalog(), why.fault);
    if constexpr (requires { settled.supervision(); }) {
        auto const& found = settled.supervision();
        outcome += found.finding == why.kind ? finding_text(drive_->catalog(), found) : std::string{};
    }
    log_.end(number, outcome, why.kind == rtuwire::altivar::outcome_kind::succeeded, now_us);
}

} // namespace playground
