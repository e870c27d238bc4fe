// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "client_orders.hpp"

#include <algorithm>

#include "catalog/value_text.hpp"

namespace playground {

namespace {

constexpr std::uint16_t short_time_out = 30; // TTO, 0.1 s

/// A decimal number, read digit by digit: digits, and a point with more of them behind it. Nothing is rounded into what
/// a register takes: the register itself refuses what it cannot hold, with its reason. Only "-0", which no register holds,
/// is the least frequency in reverse.
rtuwire::result<given_frequency> frequency_of(std::string_view text)
{
    constexpr std::int64_t step_of_reference = 100'000;      // LFR of every drive, in millionths
    constexpr std::int64_t farthest = 1'000'000'000'000'000; // no register's limit, in millionths
    bool const is_below = text.starts_with('-');
    bool has_digit = false, has_point = false;
    std::int64_t value = 0, place = 1'000'000;
    for (char const each : text.substr(is_below ? 1 : 0)) {
        if (each == '.' and has_digit and not has_point) {
            has_point = true;
            has_digit = false;
            continue;
        }
        if (each < '0' or each > '9') {
            return rtuwire::errc::malformed;
        }
        has_digit = true;
        int const digit = each - '0';
        if (not has_point) {
            value = std::min(value * 10 + digit * place, farthest);
            continue;
        }
        place /= 10;
        value = place == 0 and digit != 0 ? value | 1 : value + digit * place; // finer ones: an odd one is no step
    }
    if (not has_digit) {
        return rtuwire::errc::malformed;
    }
    return given_frequency{not is_below ? value : value == 0 ? -step_of_reference : -value};
}

/// The register that kept a drive from being ordered.
std::string finding_text(tool::drive_catalog const& drive, rtuwire::altivar::supervision_report const& found)
{
    auto const* const entry = drive.at(found.address);
    std::string const value = entry == nullptr ? std::to_string(found.word) : tool::text_of(*entry, found.word);
    std::string const label = entry == nullptr ? std::to_string(found.address) : std::string{entry->code};
    return found.address == 0 ? std::string{} : "; " + label + " is " + value;
}

ending ending_of(rtuwire::altivar::reason const& why)
{
    using rtuwire::altivar::outcome_kind;
    if (why.kind == outcome_kind::reference_limited) {
        return ending::done_otherwise;
    }
    ending const done = why.is_other_stop ? ending::done_otherwise : ending::done;
    return why.kind == outcome_kind::succeeded ? done : ending::not_done;
}

} // namespace

void client_orders::begin(std::uint64_t now_us)
{
    is_watching_ = true;
    if (std::uint16_t const address = drive_->catalog().layout.safeguards.tto; address != 0) {
        replace(set_time_out_, "set the drive's time-out to 3 s", now_us);
        set_time_out_.conversation.emplace(unit,
                                           rtuwire::write_single_register{.address = address, .value = short_time_out});
    }
}

void client_orders::start(std::string_view reference, std::uint64_t now_us)
{
    give(start_, "start at ", reference, now_us);
}

void client_orders::change(std::string_view reference, std::uint64_t now_us)
{
    give(change_, "change to ", reference, now_us);
}

void client_orders::reset_fault(std::uint64_t now_us)
{
    if (is_free(reset_, "reset the fault", now_us)) {
        drive_->make(reset_.conversation);
    }
}

void client_orders::stop(rtuwire::altivar::stop_by how, std::string const& what, std::uint64_t now_us)
{
    replace(stop_, "stop: " + what, now_us);
    drive_->make(stop_.conversation, how);
}

void client_orders::converse(link& line, rtuwire::instant now)
{
    std::size_t slot = 0;
    if (is_watching_) {
        drive_->watch(line, slot, now);
    }
    attend(line, ++slot, set_time_out_, now);
    attend(line, ++slot, start_, now);
    attend(line, ++slot, change_, now);
    attend(line, ++slot, reset_, now);
    attend(line, ++slot, stop_, now);
    note_standing(line, now);
}

/// What the watch says may be older than the end of a start, for two rounds at most, or until two have failed.
void client_orders::note_standing(link const& line, rtuwire::instant now) noexcept
{
    constexpr rtuwire::duration two_rounds = rtuwire::milliseconds(1'500);
    client_sight const seen = drive_->sight();
    if (start_.conversation) {
        rounds_of_start_ = seen.rounds;
        end_of_start_ = now;
        standing_ = standing::starting;
        return;
    }
    bool const is_older = seen.rounds - rounds_of_start_ < 2 and not reached(now, end_of_start_ + two_rounds);
    if (not line.is_ordered(unit)) {
        standing_ = standing::none;
    } else if (stop_.conversation or standing_ == standing::stopping) {
        standing_ = standing::stopping;
    } else if (standing_ != standing::starting or not is_older) {
        standing_ = seen.is_linked and standing_ != standing::given_up ? standing::ordered : standing::given_up;
    }
}

template <typename Order>
bool client_orders::is_free(given_order<Order>& order, std::string const& what, std::uint64_t now_us)
{
    std::uint32_t const number = log_.add(what, now_us);
    if (order.conversation) {
        log_.end(number, "not given: the one before has not ended", ending::not_done);
        return false;
    }
    order.number = number;
    return true;
}

/// A newer one takes the place of one that has not ended.
template <typename Order>
void client_orders::replace(given_order<Order>& order, std::string const& what, std::uint64_t now_us)
{
    if (order.conversation) {
        log_.end(order.number, "a later one took its place", ending::not_done);
    }
    order.number = log_.add(what, now_us);
}

template <typename Order>
void client_orders::give(given_order<Order>& order, std::string what, std::string_view reference, std::uint64_t now_us)
{
    what += reference;
    what += " Hz";
    if (is_free(order, what, now_us)) {
        auto const asked = frequency_of(reference);
        refuse(order.number, asked ? drive_->make(order.conversation, *asked) : asked.error());
    }
}

/// Tells why no reference is given, if anything is wrong with it.
void client_orders::refuse(std::uint32_t number, rtuwire::errc wrong)
{
    bool const is_number = wrong != rtuwire::errc::malformed;
    if (wrong != rtuwire::errc::none) {
        std::string outcome{"not given: "};
        outcome += is_number ? name(wrong) : "type a number first: digits and a point, no comma";
        log_.end(number, outcome, ending::not_done);
    }
}

template <typename Order>
void client_orders::attend(link& line, std::size_t slot, given_order<Order>& order, rtuwire::instant now)
{
    if (not order.conversation) {
        return;
    }
    line.converse(slot, *order.conversation, now);
    if (order.conversation->settled()) {
        end(*order.conversation, order.number);
        order.conversation.reset();
    }
}

void client_orders::end(request const& settled, std::uint32_t number)
{
    auto const outcome = settled.outcome();
    bool const is_done = outcome.has_value();
    log_.end(number, is_done ? "done" : std::string{name(outcome.error())}, is_done ? ending::done : ending::not_done);
}

template <typename Order> void client_orders::end(Order const& settled, std::uint32_t number)
{
    rtuwire::altivar::reason const why = settled.reason();
    auto const text = rtuwire::altivar::text_of(why);
    bool const is_limited = why.kind == rtuwire::altivar::outcome_kind::reference_limited;
    std::string outcome{is_limited ? "done, at the drive's limit: " : ""};
    outcome += std::string_view{text};
    if constexpr (requires { settled.supervision(); }) {
        auto const& found = settled.supervision();
        outcome += found.finding == why.kind ? finding_text(drive_->catalog(), found) : std::string{};
    }
    log_.end(number, outcome, ending_of(why));
}

} // namespace playground
