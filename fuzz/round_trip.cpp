// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Any value of any kind of PDU: it is refused, or it encodes to a frame that decodes to the same value.
#include <concepts>

#include <rtuwire/rtuwire.hpp>

#include "input.hpp"

#include "../tests/support/pdus.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using fuzz::require;

namespace {

/// Whether a value is of a kind of PDU, perhaps one made of other words or runs: what it decodes to tells.
template <typename P, typename Value>
inline constexpr bool is_of_kind = std::same_as<decltype(P::decode({})), decltype(Value::decode({}))>;

template <typename P> void there_and_back(std::uint8_t unit, P const& value)
{
    std::array<std::byte, max_adu_size> place{};
    auto const frame = encode_adu(place, unit, value);
    if (value.check() != errc::none) {
        return require(not frame.has_value());
    }
    require(frame and frame->size() == value.size() + adu_overhead);
    auto const heard = decode_adu(*frame);
    require(heard and heard->unit() == unit);
    auto const again = P::decode(heard->pdu());
    require(again.has_value());
    std::array<std::byte, max_adu_size> other{};
    auto const second = encode_adu(other, unit, *again);
    require(second and same_bytes(*second, *frame));
    // No room for one byte less.
    auto const tight = encode_adu(byte_span{place}.first(frame->size() - 1), unit, value);
    require(tight == errc::buffer_too_small);
}

/// Tries all of them; every kind of PDU that there is has to be among them.
template <typename... Values> void all_there_and_back(std::uint8_t unit, Values const&... values)
{
    constexpr auto is_tried = []<typename P>() { return (is_of_kind<P, Values> or ...); };
    static_assert(test::all_pdus::all_of(is_tried), "a kind of PDU is not tried");
    (there_and_back(unit, values), ...);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    fuzz::input in{data, size};
    while (not in.is_empty()) {
        std::uint8_t const unit = in.u8();
        std::uint8_t const kind = in.u8();
        std::uint16_t const first = in.u16();
        std::uint16_t const second = in.u16();
        std::uint16_t const third = in.u16();
        register_view const words{in.some(kind)};
        byte_view const bytes = words.bytes();
        bit_view const bits{bytes, third};
        auto const function = static_cast<function_code>(first & 0xFFU);
        auto const access = static_cast<identification_access>(second & 0xFFU);
        auto const level = static_cast<std::uint8_t>(third);
        all_there_and_back(
            unit, read_coils{first, second}, read_coils_response{bits}, read_discrete_inputs{first, second},
            read_discrete_inputs_response{bits}, read_holding_registers{first, second},
            read_holding_registers_response{words}, read_input_registers{first, second},
            read_input_registers_response{words}, write_single_coil{first, second % 2 != 0},
            write_single_register{first, second}, read_exception_status{}, read_exception_status_response{kind},
            diagnostics{static_cast<subfunction>(first), words}, get_comm_event_counter{},
            get_comm_event_counter_response{first, second}, get_comm_event_log{},
            get_comm_event_log_response{first, second, third, bytes}, write_multiple_coils{first, bits},
            write_multiple_coils_response{first, second}, write_multiple_registers{first, words},
            write_multiple_registers_response{first, second}, report_server_id{}, report_server_id_response{bytes},
            read_file_record{file_run{first, second, third}}, read_file_record_response{bytes}, file_writes{bytes},
            write_file_record{first, second, words}, mask_write_register{first, second, third},
            read_write_multiple_registers{first, second, third, words}, read_write_multiple_registers_response{words},
            read_fifo_queue{first}, read_fifo_queue_response{words},
            read_device_identification{access, static_cast<std::uint8_t>(first)},
            device_identification{access, level, first % 2 != 0, level, kind, bytes},
            exception_response{function, static_cast<std::uint8_t>(second)}, raw_pdu{function, bytes});
    }
    return 0;
}
