// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "chaos/disturbed_line.hpp"

#include <algorithm>
#include <optional>

namespace tool {

using rtuwire::byte_view;
using rtuwire::duration;
using rtuwire::frame_verdict;
using rtuwire::instant;
using rtuwire::milliseconds;
using rtuwire::sim::random_source;

namespace {

constexpr duration babble_pause = milliseconds(20);

std::vector<std::byte> copy_of(byte_view bytes) { return {bytes.begin(), bytes.end()}; }

duration drawn(random_source& random, duration most) { return duration{1 + random.below(most.microseconds)}; }

std::string in_ms(duration time) { return std::to_string(time.microseconds / 1'000) + " ms"; }

/// Other bits, a byte less or a byte more; in words.
std::string damage(std::vector<std::byte>& bytes, random_source random)
{
    constexpr std::uint32_t ways = 3;
    std::uint32_t const way = random.below(ways);
    if (way == 0 or bytes.size() < 2) {
        std::size_t flipped = 0;
        rtuwire::sim::disturb_bits(bytes.size() * 8, random, [&](std::size_t place) {
            if (place < bytes.size() * 8) {
                bytes[place / 8] ^= static_cast<std::byte>(1U << place % 8);
                ++flipped;
            }
        });
        return "damaged in " + std::to_string(flipped) + (flipped == 1 ? " bit" : " bits");
    }
    std::uint32_t const place = random.below(static_cast<std::uint32_t>(bytes.size()));
    auto const where = bytes.begin() + place;
    if (way == 1) {
        bytes.erase(where);
        return "damaged by loss of byte " + std::to_string(place);
    }
    bytes.insert(where, static_cast<std::byte>(random.next() & 0xFFU));
    return "damaged by a byte at " + std::to_string(place);
}

/// What a receiver makes of short glitches: a start bit, and lows that end inside of the byte.
std::vector<std::byte> noise(random_source& random)
{
    constexpr std::uint32_t most = 4, lows = 9;
    std::vector<std::byte> bytes(1 + random.below(most));
    for (std::byte& each : bytes) {
        each = static_cast<std::byte>(0xFFU << random.below(lows) & 0xFFU);
    }
    return bytes;
}

/// A part of a frame, and how much later than the first it comes.
struct piece {
    byte_view bytes;
    duration later;
};

/// As an adapter hands on what comes off its wire.
std::vector<piece> lumps_of(byte_view bytes, duration latency, duration character, random_source& random)
{
    rtuwire::sim::usb_adapter adapter{latency, rtuwire::sim::usb_timer::from_last_packet};
    instant const begin{random.below(latency.microseconds)};
    std::vector<piece> all;
    std::size_t given = 0;
    auto const give = [&](instant at) {
        std::size_t const size = adapter.give(at).size();
        if (size > 0) {
            all.push_back({bytes.subspan(given, size), at - begin});
            given += size;
        }
    };
    instant at = begin;
    for (std::byte const each : bytes) {
        at = at + character;
        if (auto const due = adapter.poll_deadline(); due and reached(at, *due)) {
            give(*due);
        }
        adapter.take(each, at);
        give(at);
    }
    if (auto const due = adapter.poll_deadline()) {
        give(*due);
    }
    return all;
}

std::vector<piece> pieces_of(byte_view bytes, duration longest, random_source& random)
{
    constexpr std::uint32_t most = 4; // cuts
    std::vector<piece> all;
    std::size_t begin = 0;
    duration later{};
    for (std::uint32_t left = 1 + random.below(most); left > 0 and bytes.size() - begin > left; --left) {
        auto const room = static_cast<std::uint32_t>(bytes.size() - begin - left);
        std::size_t const size = 1 + random.below(room);
        all.push_back({bytes.subspan(begin, size), later});
        begin += size;
        later = later + drawn(random, longest);
    }
    all.push_back({bytes.subspan(begin), later});
    return all;
}

/// Whether one of them, or several behind each other, but not all, would be taken for a frame.
bool has_frame_among(std::vector<piece> const& pieces)
{
    for (std::size_t first = 0; first < pieces.size(); ++first) {
        rtuwire::running_crc16<> crc;
        std::size_t size = 0;
        for (std::size_t last = first; last < pieces.size(); ++last) {
            for (std::byte const each : pieces[last].bytes) {
                crc.add(each);
            }
            size += pieces[last].bytes.size();
            bool const is_all = first == 0 and last + 1 == pieces.size();
            if (size >= rtuwire::min_adu_size and crc.value() == 0 and not is_all) {
                return true;
            }
        }
    }
    return false;
}

} // namespace

struct disturbed_line::passing_frame {
    frame_way way;
    std::uint32_t number;
    byte_view bytes;
    instant now;
    std::uint32_t seed;
    std::vector<line_fault const*> met{};

    std::string name() const { return (way == frame_way::request ? "request " : "answer ") + std::to_string(number); }
    std::string left() const { return name() + " left: "; }
    line_fault const* find(fault_kind kind) const
    {
        auto const found = std::ranges::find(met, kind, [](line_fault const* each) { return each->kind; });
        return found == met.end() ? nullptr : *found;
    }
    /// An echo of it is another frame.
    bool is_untouched() const { return met.empty() or (met.size() == 1 and met.front()->kind == fault_kind::echo); }
    random_source draws(line_fault const& fault) const { return draws_of(fault, seed, number); }
};

disturbed_line::disturbed_line(fault_plan plan, line_outlets outlets)
    : plan_{std::move(plan)}, outlets_{std::move(outlets)}, cutters_{frame_cutter{frame_way::request, plan_.silence},
                                                                     frame_cutter{frame_way::answer, plan_.silence}}
{}

void disturbed_line::receive(frame_way way, byte_view bytes, instant now)
{
    advance(now);
    if (not bytes.empty()) {
        at(cutters_, way).receive(bytes, now, [&](byte_view frame) {
            take(way, frame, now);
            release(way, now);
        });
    }
}

void disturbed_line::advance(instant now)
{
    for (frame_way const way : {frame_way::request, frame_way::answer}) {
        release(way, now);
        at(cutters_, way).advance(now, [&](byte_view frame) {
            take(way, frame, now);
            release(way, now);
        });
    }
}

rtuwire::deadline disturbed_line::poll_deadline() const
{
    rtuwire::deadline next;
    for (frame_way const way : {frame_way::request, frame_way::answer}) {
        next = rtuwire::earlier(next, at(cutters_, way).poll_deadline());
        auto const& queue = at(queues_, way);
        next = rtuwire::earlier(next, queue.empty() ? rtuwire::deadline{} : rtuwire::deadline{queue.front().at});
    }
    return next;
}

void disturbed_line::take(frame_way way, byte_view frame, instant now)
{
    fault_counts& counts = at(counts_, way);
    passing_frame it{way, ++counts.frames, frame, now, plan_.seed};
    if (at(waiting_, way) >= most_waiting) {
        std::string const lost = name_of(fault_kind::lost, way);
        ++counts.met[lost];
        tell(way, frame, now,
             {{},
              now,
              frame_verdict::good,
              true,
              false,
              it.name() + " came: " + lost + ", as " + std::to_string(at(waiting_, way)) + " bytes wait before it"});
        return;
    }
    std::string kinds;
    for (line_fault const& each : plan_.faults) {
        if (each.way == way and it.find(each.kind) == nullptr and meets(each, plan_.seed, it.number)) {
            it.met.push_back(&each);
            ++counts.met[name_of(each.kind, way)];
            kinds += (kinds.empty() ? "" : ", ") + name_of(each.kind, way);
        }
    }
    if (it.find(fault_kind::echo) != nullptr) {
        give_back(it);
    }
    counts.untouched += it.met.empty() ? 1U : 0U;
    if (it.is_untouched() and at(queues_, way).empty()) {
        put(way, {copy_of(frame), now, frame_verdict::good, true, false, it.name()});
        return;
    }
    std::string const what = it.is_untouched() ? "waits" : kinds;
    tell(way, frame, now, {{}, now, frame_verdict::good, true, false, it.name() + " came: " + what});
    if (it.find(fault_kind::lost) != nullptr or it.find(fault_kind::cut) != nullptr) {
        return;
    }
    if (line_fault const* const babble = it.find(fault_kind::babble)) {
        put_babble(it, *babble);
        return;
    }
    put_disturbed(it);
}

/// At once, whatever is on its way to the client.
void disturbed_line::give_back(passing_frame const& it)
{
    send(frame_way::answer,
         {copy_of(it.bytes), it.now, frame_verdict::echo, false, false, it.name() + " given back to the client"},
         it.now);
}

void disturbed_line::put_babble(passing_frame const& it, line_fault const& fault)
{
    std::uint32_t const count = 1 + fault.time_at(plan_.time_out).microseconds / babble_pause.microseconds;
    outgoing first{{}, it.now, frame_verdict::stray, false, true, {}};
    first.goes_on = babble_lumps{it.draws(fault), it.now, 0, count, it.left()};
    take_next(first);
    put(it.way, std::move(first));
}

void disturbed_line::take_next(outgoing& babble)
{
    constexpr std::size_t lump = 16;
    babble_lumps& all = *babble.goes_on;
    instant const due = all.began + duration{all.number * babble_pause.microseconds};
    babble.at = reached(babble.at, due) ? babble.at : due;
    babble.bytes.resize(lump);
    rtuwire::sim::fill_babble(babble.bytes, all.random);
    ++all.number;
    babble.told = all.told + "babble " + std::to_string(all.number) + " of " + std::to_string(all.count);
}

instant disturbed_line::outgoing::end() const
{
    if (not goes_on) {
        return at;
    }
    instant const last = goes_on->began + duration{(goes_on->count - 1) * babble_pause.microseconds};
    return reached(at, last) ? at : last;
}

/// Returns when the frame itself may follow.
instant disturbed_line::put_foreign(passing_frame const& it, line_fault const& fault)
{
    constexpr duration longest_pause = milliseconds(20);
    random_source random = it.draws(fault);
    std::vector<std::byte> room(std::max(it.bytes.size(), rtuwire::max_adu_size));
    byte_view const made_up = rtuwire::sim::foreign_answer(it.bytes, room, random);
    if (made_up.empty()) {
        return it.now;
    }
    put(it.way, {copy_of(made_up), it.now, frame_verdict::foreign, false, true,
                 it.left() + "foreign, an answer of unit " + std::to_string(std::to_integer<unsigned>(made_up[0]))});
    return it.now + drawn(random, longest_pause);
}

void disturbed_line::put_disturbed(passing_frame& it)
{
    outgoing whole{copy_of(it.bytes), it.now, frame_verdict::good, true, false, {}};
    auto const note = [&whole](std::string const& what) { whole.told += (whole.told.empty() ? "" : ", ") + what; };
    if (line_fault const* const fault = it.find(fault_kind::foreign)) {
        whole.at = put_foreign(it, *fault);
        note("behind a foreign one");
    }
    if (line_fault const* const fault = it.find(fault_kind::delay)) {
        random_source random = it.draws(*fault);
        duration const later = drawn(random, fault->time);
        whole.at = whole.at + later;
        note("delayed by " + in_ms(later));
    }
    if (line_fault const* const fault = it.find(fault_kind::late)) {
        random_source random = it.draws(*fault);
        duration const later{plan_.time_out.microseconds + drawn(random, fault->time).microseconds};
        whole.at = whole.at + later;
        whole.verdict = frame_verdict::late;
        note("late by " + in_ms(later));
    }
    if (line_fault const* const fault = it.find(fault_kind::damaged)) {
        note(damage(whole.bytes, it.draws(*fault)));
        whole.verdict = frame_verdict::damaged;
        whole.is_own = true;
    }
    line_fault const* const noisy = it.find(fault_kind::noise);
    std::optional<outgoing> behind;
    if (noisy != nullptr) {
        random_source random = it.draws(*noisy);
        bool const is_before = random.below(2) == 0;
        outgoing bytes{noise(random), whole.at, frame_verdict::stray, false, true, it.left() + "noise"};
        note(is_before ? "behind noise" : "before noise");
        if (is_before) {
            put(it.way, std::move(bytes));
        } else {
            behind = std::move(bytes);
        }
    }
    if (it.find(fault_kind::doubled) != nullptr) {
        // Right behind it, so that it cannot be taken for the answer to the next request: nobody could tell.
        std::vector<std::byte> const first = whole.bytes;
        whole.bytes.insert(whole.bytes.end(), first.begin(), first.end());
        whole.is_frame = false;
        note("twice");
    }
    if (it.is_untouched()) {
        note("behind another");
    }
    put_pieces(it, whole);
    if (behind) {
        put(it.way, std::move(*behind));
    }
}

/// As a whole, or cut as an adapter or a network does. No pieces are a frame that the data of this one hold: nobody sent it.
void disturbed_line::put_pieces(passing_frame const& it, outgoing whole)
{
    constexpr unsigned draws = 32;
    line_fault const* const lumps = it.find(fault_kind::lumps);
    line_fault const* const split = it.find(fault_kind::split);
    line_fault const* const cutting = split != nullptr ? split : lumps;
    std::vector<piece> pieces{{whole.bytes, {}}};
    if (cutting != nullptr) {
        random_source random = it.draws(*cutting);
        bool is_safe = false;
        for (unsigned i = 0; i < draws and not is_safe; ++i) {
            pieces = cutting == split ? pieces_of(whole.bytes, split->time, random)
                                      : lumps_of(whole.bytes, lumps->time, plan_.character, random);
            is_safe = not has_frame_among(pieces);
        }
        if (not is_safe) {
            pieces = {{whole.bytes, {}}};
            whole.told +=
                std::string{whole.told.empty() ? "" : ", "} + "whole, as pieces would be a frame of their own";
        }
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        std::string told = whole.told;
        if (pieces.size() > 1 or lumps != nullptr) {
            told += (told.empty() ? "" : ", ") + std::string{"piece "} + std::to_string(i + 1) + " of " +
                    std::to_string(pieces.size());
        }
        put(it.way, {copy_of(pieces[i].bytes), whole.at + pieces[i].later, whole.verdict,
                     whole.is_frame and pieces.size() == 1, whole.is_own, it.left() + told});
    }
}

/// Nothing overtakes what goes the same way.
void disturbed_line::put(frame_way way, outgoing piece)
{
    auto& queue = at(queues_, way);
    if (not queue.empty() and not reached(piece.at, queue.back().end())) {
        piece.at = queue.back().end();
    }
    at(waiting_, way) += piece.bytes.size();
    queue.push_back(std::move(piece));
}

void disturbed_line::release(frame_way way, instant now)
{
    auto& queue = at(queues_, way);
    while (not queue.empty() and reached(now, queue.front().at)) {
        outgoing next = std::move(queue.front());
        queue.pop_front();
        at(waiting_, way) -= next.bytes.size();
        send(way, next, now);
        if (next.goes_on and next.goes_on->number < next.goes_on->count) {
            take_next(next);
            at(waiting_, way) += next.bytes.size();
            queue.push_front(std::move(next));
        }
    }
}

void disturbed_line::send(frame_way way, outgoing const& piece, instant now)
{
    if (not at(guards_, way).lets_pass(piece.bytes, piece.is_own, now)) {
        ++at(counts_, way).kept_back;
        outgoing kept = piece;
        kept.told = piece.told.substr(0, piece.told.find(" left: ")) +
                    " came: kept back, as part of a request that nobody sent";
        tell(way, piece.bytes, now, kept);
        return;
    }
    outlets_.send(way, piece.bytes);
    tell(way, piece.bytes, now, piece);
}

void disturbed_line::tell(frame_way way, byte_view bytes, instant now, outgoing const& what) const
{
    using rtuwire::frame_role;
    frame_role const whole = way == frame_way::request ? frame_role::request : frame_role::response;
    outlets_.tell({bytes, now, what.is_frame ? whole : frame_role::unknown, what.verdict, way == frame_way::request},
                  what.told);
}

} // namespace tool
