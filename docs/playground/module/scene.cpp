// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "scene.hpp"

#include <array>
#include <utility>

#include "catalog/value_text.hpp"
#include "frame/summary.hpp"

namespace playground {

namespace {

using rtuwire::altivar::stop_by;

struct way_to_stop {
    stop_by how;
    std::string_view name;
};
constexpr std::array ways_to_stop{
    way_to_stop{stop_by::ramp, "on the ramp"},          way_to_stop{stop_by::quick_stop, "quick stop"},
    way_to_stop{stop_by::freewheel, "freewheel"},       way_to_stop{stop_by::halt, "halt"},
    way_to_stop{stop_by::dc_injection, "DC injection"},
};

bool has(rtuwire::altivar::drive_layout const& drive, stop_by how)
{
    return (how != stop_by::dc_injection or drive.dc_injection != 0) and (how != stop_by::halt or drive.halt != 0);
}

std::string named(tool::drive_catalog const& drive, std::string_view code, std::uint16_t word)
{
    auto const* const entry = drive.by_code(code);
    return entry == nullptr ? std::string{} : tool::text_of(*entry, word);
}

std::string_view name_of(standing what)
{
    switch (what) {
    case standing::none: break;
    case standing::starting: return "starting";
    case standing::ordered: return "ordered";
    case standing::stopping: return "stopping";
    case standing::given_up: return "given up";
    }
    return "none";
}

constexpr rtuwire::duration longest_run = rtuwire::milliseconds(1'000);

} // namespace

scene::scene(std::unique_ptr<any_drive> drive)
    : drive_{std::move(drive)}, frames_{names_}, orders_{*drive_}, bench_{
                                                                       link{}, cabled_drive{*drive_},
                                                                       line_tap{line_speed, rtuwire::milliseconds(150)},
                                                                       typed_frames{}}
{
    tap().hand_to(*this);
}

void scene::run(rtuwire::duration length)
{
    constexpr std::uint32_t never = ~std::uint32_t{0};
    run_until(never, length < longest_run ? length : longest_run);
}

void scene::run_to_next_frame() { run_until(frames_.end() + 1, longest_run); }

void scene::run_until(std::uint32_t frames, rtuwire::duration longest)
{
    static_cast<void>(bench_.run_until([&] { return frames_.end() >= frames; }, longest,
                                       [this](rtuwire::instant now) { visit(now); }));
    keep_time(bench_.now());
}

void scene::switch_mains(bool on)
{
    bool const comes_on = on and not end().is_on();
    end().switch_mains(on, bench_.now());
    is_local_ = is_local_ and on and not comes_on;
    if (comes_on) {
        orders_.begin(now_us_);
        make_fault(has_cause_);
    }
}

void scene::cut(cable where)
{
    constexpr unsigned drive_as_sender = 1;
    bool const towards = where == cable::cut or where == cable::towards_drive;
    bool const from = where == cable::cut or where == cable::from_drive;
    end().cut(towards, from);
    bench_.wire().set_faults(drive_as_sender, {.is_cut = from});
    cable_ = where;
}

void scene::make_fault(bool present)
{
    constexpr std::uint16_t overcurrent = 9; // LFT
    has_cause_ = present;
    if (not present) {
        drive_->clear_cause();
    } else if (end().is_on()) {
        drive_->inject_fault(overcurrent);
    }
}

void scene::set_local(bool is_local)
{
    if (end().is_on()) {
        is_local_ = is_local;
        drive_->set_local(is_local);
    }
}

void scene::press_stop()
{
    if (end().is_on()) {
        drive_->press_stop();
    }
}

void scene::set_supervised(bool is_supervised)
{
    auto const& guards = layout().safeguards;
    bool const has_reaction = guards.sll != 0;
    constexpr std::uint16_t freewheel = 1; // SLL as delivered
    auto const others = static_cast<std::uint16_t>(drive_->word("CMI") & ~guards.nto);
    std::uint16_t const off = has_reaction ? std::uint16_t{0} : static_cast<std::uint16_t>(others | guards.nto);
    if (end().is_on() and is_supervised != this->is_supervised()) {
        drive_->write(has_reaction ? guards.sll : layout().cmi, not is_supervised ? off
                                                                : has_reaction    ? freewheel
                                                                                  : others);
    }
}

/// What the drive itself has, whoever wrote it.
bool scene::is_supervised() const noexcept
{
    auto const& guards = layout().safeguards;
    return guards.sll != 0 ? drive_->word("SLL") != 0 : (drive_->word("CMI") & guards.nto) == 0;
}

void scene::stop(stop_by how)
{
    for (way_to_stop const& each : ways_to_stop) {
        if (each.how == how and has(layout(), how)) {
            orders_.stop(how, std::string{each.name}, now_us_);
        }
    }
}

void scene::keep_time(rtuwire::instant now) noexcept
{
    turn_shaft((now - last_).microseconds);
    now_us_ += (now - last_).microseconds;
    last_ = now;
}

/// With power the motor follows the output; without, it coasts, here to rest from 50 Hz in ten seconds.
void scene::turn_shaft(std::uint32_t passed_us) noexcept
{
    constexpr std::uint32_t step_us = 200; // for each mHz
    auto const lost = static_cast<std::int32_t>((now_us_ + passed_us) / step_us - now_us_ / step_us);
    bool const has_power = end().is_on() and rtuwire::cia402::has_power(drive_->state());
    std::int32_t const forwards = shaft_ > lost ? shaft_ - lost : 0;
    std::int32_t const backwards = shaft_ < -lost ? shaft_ + lost : 0;
    shaft_ = has_power ? drive_->frequency() : shaft_ > 0 ? forwards : backwards;
}

/// A time of the line: a byte may have ended since the last pass.
std::uint64_t scene::us_of(rtuwire::instant at) const noexcept
{
    bool const is_past = reached(last_, at);
    return is_past ? now_us_ - (last_ - at).microseconds : now_us_ + (at - last_).microseconds;
}

/// One pass of everything that is no end of the line.
void scene::visit(rtuwire::instant now)
{
    keep_time(now);
    typed().note_line(tap().is_free(now));
    orders_.converse(bench_.link(), now);
    if (auto const bytes = end().take_unheard(); not bytes.empty()) {
        note_unheard(bytes, now);
    }
}

void scene::take(rtuwire::heard_frame const& heard)
{
    bool const is_request = heard.frame.role == rtuwire::frame_role::request;
    bool const is_typed = is_request and typed().take_sent(heard.frame.bytes);
    seen_frame seen{.begin_us = us_of(heard.first_byte),
                    .end_us = us_of(heard.frame.at),
                    .from = is_typed     ? sender::person
                            : is_request ? sender::client
                                         : sender::drive,
                    .is_damaged = heard.frame.verdict == rtuwire::frame_verdict::damaged,
                    .is_unanswered = heard.is_unanswered,
                    .is_lost = is_request and not end().hears(),
                    .is_exception = heard.is_exception(),
                    .bytes = {heard.frame.bytes.begin(), heard.frame.bytes.end()},
                    .request = {heard.request.begin(), heard.request.end()},
                    .summary = tool::summary_of(heard, &names_)};
    if (is_request) {
        last_request_ = seen.bytes;
    }
    frames_.add(std::move(seen));
}

/// A response that is sent into a cut cable from now on.
void scene::note_unheard(std::vector<std::byte> const& bytes, rtuwire::instant now)
{
    rtuwire::heard_frame heard{{bytes, now, rtuwire::frame_role::response}, now};
    heard.request = last_request_;
    frames_.add({.begin_us = us_of(now),
                 .end_us = us_of(now) + line_speed.characters(bytes.size()).microseconds,
                 .from = sender::drive,
                 .is_lost = true,
                 .is_exception = heard.is_exception(),
                 .bytes = bytes,
                 .request = last_request_,
                 .summary = tool::summary_of(heard, &names_)});
}

std::uint32_t scene::time_out_us() const noexcept
{
    constexpr std::uint32_t step = 100'000; // of TTO
    auto const& guards = layout().safeguards;
    return guards.tto != 0 ? drive_->word("TTO") * step : guards.fixed_timeout.microseconds;
}

std::string scene::state()
{
    json_text out;
    out.open_object();
    out.put("time", now_us_);
    out.put("cable", static_cast<unsigned>(cable_));
    put_drive(out);
    put_client(out);
    orders_.log().put(out);
    out.put("frames", frames_.end());
    out.close_object();
    return out.text();
}

void scene::put_drive(json_text& out)
{
    bool const is_on = end().is_on();
    out.open_object("drive");
    out.put("on", is_on);
    out.put("state", is_on ? std::string_view{name_of(drive_->state())} : std::string_view{});
    out.put("last", is_on ? std::string_view{name_of(drive_->last_transition())} : std::string_view{});
    out.put("frequency", is_on ? drive_->frequency() : 0);
    out.put("power", is_on and rtuwire::cia402::has_power(drive_->state()));
    out.put("halted", is_on and (drive_->word("CMD") & layout().halt) != 0);
    out.put("shaft", shaft_);
    out.put("reference", is_on ? static_cast<std::int16_t>(drive_->word("LFR")) : std::int16_t{0});
    out.put("command", tool::hex_word(drive_->word("CMD")));
    out.put("status", tool::hex_word(drive_->word("ETA")));
    out.put("statusText", tool::bits_text(*catalog().by_code("ETA"), drive_->word("ETA")));
    out.put("current", named(catalog(), "LCR", drive_->word("LCR")));
    out.put("fault", is_on and drive_->fault() != 0 ? named(catalog(), "LFT", drive_->fault()) : std::string{});
    out.put("lineFault", is_on and drive_->fault() == rtuwire::sim::link_fault);
    out.put("cause", has_cause_);
    out.put("local", is_local_);
    out.put("supervised", is_supervised());
    out.put("timeout", time_out_us());
    out.put("silence", is_on and end().has_heard() ? end().silence().microseconds : 0U);
    out.close_object();
}

void scene::put_client(json_text& out)
{
    client_sight const seen = drive_->sight();
    bool const is_well = seen.error == rtuwire::errc::none or seen.error == rtuwire::errc::busy;
    out.open_object("client");
    out.put("linked", seen.is_linked);
    out.put("rounds", seen.rounds);
    out.put("error", is_well ? std::string_view{} : name(seen.error));
    out.put("state", std::string_view{name_of(seen.state)});
    out.put("frequency", seen.frequency);
    out.put("order", name_of(orders_.standing()));
    out.close_object();
}

std::string scene::description() const
{
    json_text out;
    out.open_object();
    out.put("name", catalog().name);
    out.put("cmd", layout().cmd);
    out.put("eta", layout().eta);
    // Until its control words were read: `altivar::stop` sends it 0000 for any stop.
    out.put("coasts", rtuwire::altivar::may_have_io_profile(layout()));
    out.open_list("stops");
    for (way_to_stop const& each : ways_to_stop) {
        if (has(layout(), each.how)) {
            out.open_object();
            out.put("id", static_cast<unsigned>(each.how));
            out.put("name", each.name);
            out.close_object();
        }
    }
    out.close_list();
    out.close_object();
    return out.text();
}

} // namespace playground
