// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/value_sender.hpp"

#include "line/raw_request.hpp"
#include "line/register_reader.hpp"
#include "motion/raw_effect.hpp"

namespace tool {

std::vector<std::byte> bytes_of(value_list const& values)
{
    std::vector<std::byte> bytes;
    if (values[0].where.is_single_bit()) {
        bytes.resize((values.size() + 7) / 8);
        for (std::size_t i = 0; i < values.size(); ++i) {
            bytes[i / 8] |= static_cast<std::byte>((values[i].words[0] != 0 ? 1U : 0U) << (i % 8U));
        }
        return bytes;
    }
    for (value_to_write const& each : values) {
        for (std::uint16_t const word : each.words) {
            bytes.push_back(static_cast<std::byte>(word >> 8U));
            bytes.push_back(static_cast<std::byte>(word & 0xFFU));
        }
    }
    return bytes;
}

void refuse_frame_within(unit_address unit, value_list const& values)
{
    std::array<std::byte, rtuwire::max_adu_size> memory{};
    auto const frame =
        by_one_request(values, [&](auto const& request) { return rtuwire::encode_into(memory, unit, request); });
    if (frame) {
        refuse_frame_within(*frame, functions_within::public_ones);
    }
}

bool is_refusal_to_write(rtuwire::errc why) { return is_refusal_of_unit(why) and why != rtuwire::errc::acknowledge; }

template <typename Request> rtuwire::errc value_sender::sent(Request const& request)
{
    if (may_repeat) {
        return line.ask(unit, request).error();
    }
    auto once = line.with(request_once<Request>{rtuwire::unit_id{unit}, request});
    return line.run(once).error();
}

rtuwire::errc value_sender::send(value_list const& values, std::string& note)
{
    value_to_write const& value = values[0];
    std::uint16_t const address = value.where.address;
    bool const is_coil = value.where.is_single_bit();
    if (values.size() > 1 or value.words.size() > 1) {
        return send_all(values);
    }
    if (value.where.bit >= 0) {
        return send_bits(value, note);
    }
    rtuwire::errc const why = is_coil ? sent(rtuwire::write_single_coil{address, value.words[0] != 0})
                                      : sent(rtuwire::write_single_register{address, value.words[0]});
    if (why != rtuwire::errc::illegal_function or is_drive) {
        return why;
    }
    note = is_coil ? "the unit has no function 05: written by 15" : "the unit has no function 06: written by 16";
    return send_all(values);
}

rtuwire::errc value_sender::send_all(value_list const& values)
{
    return by_one_request(values, [this](auto const& request) { return sent(request); });
}

/// Where the unit lacks function 22, and somebody said so, all of the register as it was just read.
rtuwire::errc value_sender::send_bits(value_to_write const& value, std::string& note)
{
    std::uint16_t const mask = value.where.mask();
    auto const others = static_cast<std::uint16_t>(~mask);
    rtuwire::errc const why = sent(rtuwire::mask_write_register{value.where.address, others, value.words[0]});
    if (why != rtuwire::errc::illegal_function or not may_rewrite) {
        return why;
    }
    held_words const held = read_place(line, unit, value.where);
    if (held.why != rtuwire::errc::none) {
        return held.why;
    }
    value_to_write whole = value;
    whole.where.bit = -1;
    whole.words[0] = static_cast<std::uint16_t>((held.words[0] & others) | value.words[0]);
    std::string how;
    rtuwire::errc const outcome = send({whole}, how);
    note = "the unit has no function 22: read, and written as a whole" + (how.empty() ? "" : "; " + how);
    return outcome;
}

} // namespace tool
