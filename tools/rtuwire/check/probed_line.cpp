// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "check/probed_line.hpp"

#include <algorithm>
#include <thread>

#include "exit_status.hpp"
#include "port/own_terminal.hpp"

namespace tool {

namespace {

constexpr line_time end_of_answer{45'000}; ///< of silence, where its size is not known
constexpr std::size_t shortest_answer = 5;

/// Objects of function 43/14, from the seventh byte of its PDU on: the size of the whole frame.
std::optional<std::size_t> identification_size(rtuwire::byte_view came)
{
    constexpr std::size_t head = 8;
    if (came.size() < head) {
        return std::nullopt;
    }
    std::size_t at = head;
    for (std::size_t left = std::to_integer<std::size_t>(came[7]); left > 0; --left) {
        if (came.size() < at + 2) {
            return std::nullopt;
        }
        at += 2 + std::to_integer<std::size_t>(came[at + 1]);
    }
    return at + 2;
}

} // namespace

std::optional<std::size_t> stated_size(rtuwire::byte_view came, rtuwire::byte_view asked)
{
    if (came.size() < 3) {
        return std::nullopt;
    }
    unsigned const function = std::to_integer<unsigned>(came[1]);
    std::size_t const third = std::to_integer<std::size_t>(came[2]);
    if (function >= 0x80U) {
        return 5;
    }
    switch (function) {
    case 0x01:
    case 0x02:
    case 0x03:
    case 0x04:
    case 0x0C:
    case 0x11:
    case 0x14:
    case 0x15:
    case 0x17: return 5 + third;
    case 0x05:
    case 0x06:
    case 0x0B:
    case 0x0F:
    case 0x10: return 8;
    case 0x07: return 5;
    case 0x08: return asked.size();
    case 0x16: return 10;
    case 0x18:
        return came.size() < 4 ? std::nullopt
                               : std::optional{6 + (third << 8U | std::to_integer<std::size_t>(came[3]))};
    case 0x2B: return third == 0x0E ? identification_size(came) : std::nullopt;
    default: return std::nullopt;
    }
}

bool is_normal(line_bytes const& came, line_bytes const& asked)
{
    return has_right_crc(came) and has_right_crc(asked) and came[0] == asked[0] and came[1] == asked[1];
}

probed_line::probed_line(any_port& port, exchange_log& log, rtuwire::line_timing const& wire, line_time longest_wait,
                         std::uint8_t unit)
    : port_{port}, log_{log}, wire_{wire}, longest_wait_{longest_wait}, unit_{unit},
      has_wire_{port.timing().has_wire() and not is_pseudo_terminal(port.device())}
{}

line_time probed_line::silence() const { return rtuwire::to_chrono(std::max(wire_.t3_5(), port_.timing().silence())); }

line_time probed_line::time_without_answer(std::vector<sent_piece> const& pieces, line_time wait) const
{
    line_time all = silence() + wait;
    for (sent_piece const& each : pieces) {
        all += line_time{1'000 * std::int64_t{each.ms} +
                         static_cast<std::int64_t>(each.characters * wire_.characters(1).microseconds)} +
               rtuwire::to_chrono(wire_.characters(each.bytes.size()));
    }
    return all;
}

line_time probed_line::since_answered() const
{
    return std::chrono::duration_cast<line_time>(clock::now() - answered_);
}

void probed_line::note(bool is_sent, line_bytes const& bytes)
{
    last_byte_ = clock::now();
    passed_.push_back({last_byte_, is_sent, bytes});
    log_.take({.bytes = bytes,
               .at = any_port::now(),
               .role = is_sent ? rtuwire::frame_role::request : rtuwire::frame_role::response,
               .is_own = is_sent});
}

line_bytes probed_line::read_until(clock::time_point end)
{
    std::array<std::byte, 1'024> place;
    line_time const left = std::chrono::duration_cast<line_time>(end - clock::now());
    auto const came = port_.read(place, any_port::now() + rtuwire::to_duration(std::max(left, line_time{0})));
    if (not came) {
        throw ended{exit_status::port, port_.failure()};
    }
    static_cast<void>(port_.take_receive_error()); // a damaged byte is judged by its frame's CRC
    return {came->begin(), came->end()};
}

void probed_line::wait_for_quiet(line_time silence)
{
    auto const give_up = clock::now() + 10 * silence;
    line_bytes dropped;
    for (auto end = clock::now() + silence; clock::now() < end and clock::now() < give_up;) {
        line_bytes const bytes = read_until(end);
        if (not bytes.empty()) {
            dropped.insert(dropped.end(), bytes.begin(), bytes.end());
            end = clock::now() + silence;
        }
    }
    if (not dropped.empty()) {
        note(false, dropped);
        bool const is_frame = dropped.size() >= 5 and rtuwire::crc16(dropped) == 0; // over its own CRC, too
        late_answer_ = is_frame and is_unanswered_ and late_answer_.empty() ? dropped : late_answer_;
    }
}

void probed_line::send(std::vector<sent_piece> const& pieces)
{
    has_kept_silences_ = true;
    early_.clear();
    double const character = std::max<double>(wire_.characters(1).microseconds, 1);
    auto left = clock::now();
    for (sent_piece const& each : pieces) {
        line_time const gap{static_cast<std::int64_t>(each.characters * character) + 1'000 * std::int64_t{each.ms}};
        if (gap > line_time{0}) {
            // An answer to a part of it stands before all that comes later.
            for (auto const end = left + gap - line_time{2'000}; gap > line_time{50'000} and clock::now() < end;) {
                line_bytes const bytes = read_until(end);
                early_.insert(early_.end(), bytes.begin(), bytes.end());
            }
            std::this_thread::sleep_until(left + gap);
            double const kept = std::chrono::duration<double, std::micro>(clock::now() - left).count() / character;
            // Without a wire nobody counts in characters: what is below 2 ms is no silence there.
            double const least = has_wire_ ? 0.0 : 2'000 / character;
            double const most = each.characters > 3.5 ? kept : std::max(least, each.characters < 1.5 ? 1.5 : 3.5);
            has_kept_silences_ = has_kept_silences_ and (each.ms > 0 or kept <= most);
        }
        // Bytes are on their way as long as they take on the wire.
        auto const wait = rtuwire::milliseconds(1'000) + wire_.characters(each.bytes.size() + 16);
        if (not port_.write(each.bytes, any_port::now() + wait)) {
            throw ended{exit_status::port, port_.failure()};
        }
        // The system takes them at once, and the wire by its bit rate.
        left =
            std::max(clock::now(), has_wire() ? left + rtuwire::to_chrono(wire_.characters(each.bytes.size())) : left);
    }
    note(true, bytes_of(pieces));
    last_byte_ = std::max(last_byte_, left);
}

line_answer probed_line::ask(std::vector<sent_piece> const& pieces, line_time wait)
{
    std::this_thread::sleep_until(last_byte_ + silence());
    send(pieces);
    line_bytes const asked = bytes_of(pieces);
    auto const sent = last_byte_;
    auto last = sent;
    line_answer answer;
    for (auto end = sent + wait; clock::now() < end;) {
        line_bytes const bytes = read_until(end);
        if (bytes.empty()) {
            continue;
        }
        auto const now = clock::now();
        line_time const since = std::chrono::duration_cast<line_time>(now - last);
        (answer.bytes.empty() ? answer.took : answer.largest_gap) =
            answer.bytes.empty() ? since : std::max(answer.largest_gap, since);
        last = now;
        answer.bytes.insert(answer.bytes.end(), bytes.begin(), bytes.end());
        // What says how long it is has ended there; what comes right behind it is seen all the same.
        auto const size = stated_size(answer.bytes, asked);
        bool const is_whole = answer.bytes.size() >= size.value_or(answer.bytes.size() + 1);
        // The rest of it, but of an exception without its high bit.
        bool const is_due = (size and not has_right_crc(answer.bytes)) or answer.bytes.size() < shortest_answer;
        end = now + (is_whole ? std::max(silence(), line_time{2'000})
                     : is_due ? std::max(wait, end_of_answer)
                              : end_of_answer);
    }
    answer.bytes.insert(answer.bytes.begin(), early_.begin(), early_.end());
    is_unanswered_ = answer.bytes.empty();
    if (is_normal(answer.bytes, asked) and asked[0] == unit_) {
        answered_ = sent;
    }
    if (not is_unanswered_) {
        note(false, answer.bytes);
    }
    return answer;
}

} // namespace tool
