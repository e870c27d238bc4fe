// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Any value of any kind of PDU: it is refused, or it encodes to a frame that decodes to the same value.
#include <rtuwire/rtuwire.hpp>

#include "input.hpp"

using namespace rtuwire;
using fuzz::require;

namespace {

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
        there_and_back(unit, read_holding_registers{first, second});
        there_and_back(unit, read_holding_registers_response{words});
        there_and_back(unit, write_single_register{first, second});
        there_and_back(unit, write_multiple_registers{first, words});
        there_and_back(unit, write_multiple_registers_response{first, second});
        there_and_back(unit, read_write_multiple_registers{first, second, third, words});
        there_and_back(unit, read_write_multiple_registers_response{words});
        there_and_back(unit, diagnostics{static_cast<subfunction>(first), words});
        bit_view const bits{words.bytes(), third};
        there_and_back(unit, read_coils{first, second});
        there_and_back(unit, read_discrete_inputs{first, second});
        there_and_back(unit, read_input_registers{first, second});
        there_and_back(unit, read_input_registers_response{words});
        there_and_back(unit, read_coils_response{bits});
        there_and_back(unit, read_discrete_inputs_response{bits});
        there_and_back(unit, write_single_coil{first, second % 2 != 0});
        there_and_back(unit, write_multiple_coils{first, bits});
        there_and_back(unit, write_multiple_coils_response{first, second});
        there_and_back(unit, read_exception_status_response{kind});
        there_and_back(unit, get_comm_event_counter_response{first, second});
        there_and_back(unit, get_comm_event_log_response{first, second, third, words.bytes()});
        there_and_back(unit, report_server_id_response{words.bytes()});
        there_and_back(unit, read_file_record_response{words.bytes()});
        there_and_back(unit, read_file_record{file_run{first, second, third}});
        there_and_back(unit, file_writes{words.bytes()});
        there_and_back(unit, write_file_record{first, second, words});
        there_and_back(unit, mask_write_register{first, second, third});
        there_and_back(unit, read_fifo_queue{first});
        there_and_back(unit, read_fifo_queue_response{words});
        there_and_back(
            unit, exception_response{static_cast<function_code>(first & 0xFFU), static_cast<std::uint8_t>(second)});
    }
    return 0;
}
