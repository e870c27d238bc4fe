// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The module's interface to the page: functions of numbers, and texts in JSON. A text that the page gives is put into
// `playground_input()` first; one that it gets is valid until the next call.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "explained.hpp"
#include "scene.hpp"
#include "transitions.hpp"

#if defined(__wasm__)
#define PLAYGROUND_EXPORT(name) extern "C" __attribute__((export_name(#name)))
#else
#define PLAYGROUND_EXPORT(name) extern "C"
#endif

namespace {

constexpr std::size_t input_size = 2048;
char input[input_size];

struct everything {
    std::unique_ptr<playground::scene> scene{std::make_unique<playground::scene>(playground::make_drive(0))};
    std::string output{};
};

everything& all()
{
    static everything it;
    return it;
}

playground::scene& scene() { return *all().scene; }

char const* give(std::string text)
{
    all().output = std::move(text);
    return all().output.c_str();
}

std::string_view typed(std::uint32_t length) { return {input, length < input_size ? length : input_size}; }

} // namespace

PLAYGROUND_EXPORT(playground_input) char* playground_input() { return input; }
PLAYGROUND_EXPORT(playground_input_size) std::uint32_t playground_input_size() { return input_size; }

/// The drives by name, in the order of their numbers.
PLAYGROUND_EXPORT(playground_drives) char const* playground_drives()
{
    playground::json_text out;
    out.open_list();
    for (auto const* const each : tool::all_catalogs()) {
        out.put("", each->name);
    }
    out.close_list();
    return give(out.text());
}

/// Begins anew with a drive that is switched off; 0 where there is none of this number.
PLAYGROUND_EXPORT(playground_open) std::uint32_t playground_open(std::uint32_t drive)
{
    auto made = playground::make_drive(drive);
    bool const is_known = made != nullptr;
    if (is_known) {
        all().scene = std::make_unique<playground::scene>(std::move(made));
    }
    return is_known ? 1 : 0;
}

PLAYGROUND_EXPORT(playground_describe) char const* playground_describe() { return give(scene().description()); }
PLAYGROUND_EXPORT(playground_machine) char const* playground_machine()
{
    return give(playground::describe_machine(scene().catalog().layout.state_machine));
}

PLAYGROUND_EXPORT(playground_run) void playground_run(std::uint32_t microseconds)
{
    scene().run(rtuwire::microseconds(microseconds));
}
PLAYGROUND_EXPORT(playground_next_frame) void playground_next_frame() { scene().run_to_next_frame(); }

PLAYGROUND_EXPORT(playground_state) char const* playground_state() { return give(scene().state()); }
PLAYGROUND_EXPORT(playground_frames) char const* playground_frames(std::uint32_t from)
{
    return give(scene().frames().list(from));
}
PLAYGROUND_EXPORT(playground_explain) char const* playground_explain(std::uint32_t frame)
{
    return give(scene().frames().explain(frame));
}

PLAYGROUND_EXPORT(playground_mains) void playground_mains(std::uint32_t on) { scene().switch_mains(on != 0); }
PLAYGROUND_EXPORT(playground_cable) void playground_cable(std::uint32_t where)
{
    scene().cut(static_cast<playground::cable>(where & 3U));
}
PLAYGROUND_EXPORT(playground_fault) void playground_fault(std::uint32_t present) { scene().make_fault(present != 0); }
PLAYGROUND_EXPORT(playground_local) void playground_local(std::uint32_t is_local) { scene().set_local(is_local != 0); }
PLAYGROUND_EXPORT(playground_stop_key) void playground_stop_key() { scene().press_stop(); }
PLAYGROUND_EXPORT(playground_supervised) void playground_supervised(std::uint32_t is_supervised)
{
    scene().set_supervised(is_supervised != 0);
}

/// With any text: what is no number, and what the drive cannot take, is refused with its reason in the list of orders,
/// which shows the text as it stands in the input.
PLAYGROUND_EXPORT(playground_start) void playground_start(std::uint32_t length) { scene().start(typed(length)); }
PLAYGROUND_EXPORT(playground_change) void playground_change(std::uint32_t length) { scene().change(typed(length)); }
PLAYGROUND_EXPORT(playground_stop) void playground_stop(std::uint32_t how)
{
    scene().stop(static_cast<rtuwire::altivar::stop_by>(how));
}
PLAYGROUND_EXPORT(playground_reset) void playground_reset() { scene().reset_fault(); }

/// What was typed into the input, explained.
PLAYGROUND_EXPORT(playground_decode) char const* playground_decode(std::uint32_t length)
{
    return give(playground::explain_typed(typed(length), scene().catalog()));
}

/// Puts what was typed on the line; 0 where it is no bytes, or where those before it have not left yet.
PLAYGROUND_EXPORT(playground_send) std::uint32_t playground_send(std::uint32_t length)
{
    auto const read = playground::read_typed(typed(length));
    return not read.bytes.empty() and scene().send(read.bytes) ? 1 : 0;
}
