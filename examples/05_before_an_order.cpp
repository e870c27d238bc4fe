// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What comes before the first order: the channels are set, the drive is checked, a setting goes to all drives, and
// somebody else's drive is watched. An ATV28's link is released. The drives are simulated; wire and clock are variables.
#include <cstdio>

#include <rtuwire/rtuwire.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

/// A client and one simulated drive.
template <device_type Device> struct line_of_two {
    static constexpr line_timing timing{19'200, character_format::even_8_1};
    instant now{0};
    drive_client<> link{timing};
    sim::unit<Device> far{unit_id{7}, timing, now};

    template <conversation Conversation> void pass(Conversation& conversation)
    {
        link.advance(now);
        link.converse(conversation, now);
        if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
            now = now + timing.characters(frame.size());
            link.sent(now);
            far.receive(frame, now);
        }
        far.advance(now);
        if (byte_view const frame = far.poll_transmit(); not frame.empty()) {
            now = now + timing.characters(frame.size());
            far.sent(now);
            link.receive(frame, now);
        }
        now = now + microseconds(100);
    }
    template <conversation Conversation> Conversation& run(Conversation& conversation)
    {
        while (not conversation.settled()) {
            pass(conversation);
        }
        return conversation;
    }
};

void show(char const* what, literal how) { std::printf("%s: %.*s\n", what, static_cast<int>(how.size()), how.begin()); }

bool prepare_an_atv320()
{
    line_of_two<atv320::device> it;
    constexpr station<atv320::device> drive{unit_id{7}};

    set_channel by_line{drive, channel_settings<atv320::device>::by_modbus()};
    show("channels", name_of(it.run(by_line).reason().kind));

    auto everyone = broadcast_setting<atv320::device, atv320::tto>(3_s);
    it.run(everyone);

    // Thirty drives, 25 ms for each exchange, 400 ms for one that is off.
    duration const gap = longest_gap_of(30, milliseconds(25), milliseconds(400));
    check_supervision safe{drive, {.longest_gap = gap}};
    show("to be ordered", name_of(it.run(safe).reason().kind));
    supervision_report const& found = safe.report();
    std::printf("  register %u; time-out %u ms, needed %u ms\n", unsigned{found.address},
                static_cast<unsigned>(found.period.timeout.microseconds / 1'000),
                static_cast<unsigned>(found.period.shortest_timeout().microseconds / 1'000));

    auto longer = broadcast_setting<atv320::device, atv320::tto>(5_s);
    it.run(longer);
    check_supervision again{drive, {.longest_gap = gap}};
    show("to be ordered", name_of(it.run(again).reason().kind));

    watch eye{drive};
    while (eye.rounds() < 2) {
        it.pass(eye);
    }
    show("seen", cia402::name_of(eye.state()));
    return by_line.succeeded() and safe.reason().kind == outcome_kind::timeout_too_short and again.ready();
}

bool release_an_atv28()
{
    line_of_two<atv28::device> it;
    constexpr station<atv28::device> old{unit_id{7}};

    atv28::activate_link take{old};
    show("ATV28 by its link", name_of(it.run(take).reason().kind));
    atv28::direct_start go{old, -20_Hz};
    show("run directly", name_of(it.run(go).reason().kind));
    atv28::direct_stop rest{old, atv28::direct_stop_by::fast_stop};
    show("stopped directly", name_of(it.run(rest).reason().kind));
    recall_from_eeprom recall{old};
    show("recalled", name_of(it.run(recall).reason().kind));

    it.far.drive().set_input(1, true); // somebody asks to run at the terminals
    atv28::release_link give{old};
    show("released", name_of(it.run(give).reason().kind));
    it.far.drive().set_input(1, false);
    atv28::release_link once_more{old};
    show("released", name_of(it.run(once_more).reason().kind));
    return take.succeeded() and go.running() and rest.succeeded() and recall.succeeded() and
           give.reason().kind == outcome_kind::run_input_closed and once_more.succeeded();
}

} // namespace

int main() { return prepare_an_atv320() and release_an_atv28() ? 0 : 1; }
