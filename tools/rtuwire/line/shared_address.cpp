// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/shared_address.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <rtuwire/serial_line.hpp>

#include "frame/frame_split.hpp"

namespace tool {

namespace {

constexpr std::size_t most_heard = 4 * rtuwire::max_adu_size;

/// What comes from now on: the first until then, until the line is silent for longer than units differ in their answers.
std::vector<std::byte> heard_on(any_port& port, rtuwire::instant until)
{
    constexpr rtuwire::duration quiet = rtuwire::milliseconds(150);
    std::array<std::byte, rtuwire::max_adu_size> place{};
    std::vector<std::byte> heard;
    while (heard.size() < most_heard) {
        auto const come = port.read(place, until);
        if (not come or come->empty()) {
            break;
        }
        heard.insert(heard.end(), come->begin(), come->end());
        until = port.now() + quiet;
    }
    return heard;
}

/// What comes behind a request.
std::vector<std::byte> heard_behind(open_line& line, rtuwire::byte_view request)
{
    any_port& port = line.port();
    rtuwire::duration const pause = port.timing().silence();
    rtuwire::duration const late = rtuwire::milliseconds(100);
    static_cast<void>(heard_on(port, port.now() + (pause < late ? late : pause))); // an answer to what was asked before
    if (not port.write(request, port.now() + rtuwire::milliseconds(1'000))) {
        return {};
    }
    std::vector<std::byte> heard = heard_on(port, port.now() + line.options().response_timeout);
    if (heard.size() >= request.size() and std::equal(request.begin(), request.end(), heard.begin())) { // its echo
        heard.erase(heard.begin(), heard.begin() + static_cast<std::ptrdiff_t>(request.size()));
    }
    return heard;
}

} // namespace

std::string why_shared(open_line& line, unit_address unit)
{
    if (line.port().is_simulated() or line.port().has_numbers()) { // a server of Modbus TCP answers once
        return {};
    }
    constexpr int tries = 3;
    rtuwire::read_device_identification const who{rtuwire::identification_access::basic, 0};
    std::array<std::byte, rtuwire::max_adu_size> place{};
    auto const request = rtuwire::encode_into(place, unit, who);
    auto const begins_right = [unit](rtuwire::byte_view frame) {
        return frame.size() >= 3 and frame[0] == std::byte{unit.byte()} and
               (frame[1] & std::byte{0x7F}) == std::byte{0x2B};
    };
    for (int damaged = 0; damaged < tries; ++damaged) {
        std::vector<std::byte> const heard = heard_behind(line, *request);
        rtuwire::byte_view const all{heard};
        auto const pieces = split_frames(all);
        auto const answers = std::ranges::count_if(pieces, [&](frame_piece const& each) {
            rtuwire::byte_view const frame = all.subspan(each.offset, each.size);
            return begins_right(frame) and rtuwire::check_frame(frame) == rtuwire::errc::none;
        });
        if (answers > 1) {
            return "several units answer at this address: switch all but one off, and give it another";
        }
        if (answers == 1 or not begins_right(all)) {
            return {};
        }
    }
    return "its answers begin right and are damaged, " + std::to_string(tries) + " of " + std::to_string(tries) +
           ": two units may have this address; switch one off, and ask again";
}

} // namespace tool
