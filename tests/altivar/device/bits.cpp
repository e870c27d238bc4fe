// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Where each named bit of the drives' words stands, as their tables print it.
#include <rtuwire/altivar/device/family.hpp>

#include "support/proof.hpp"

using namespace rtuwire::altivar;

namespace {

template <typename Bit> struct row {
    Bit bit;
    unsigned word;
};
template <typename Bit, std::size_t Rows> constexpr bool stand(row<Bit> const (&table)[Rows])
{
    bool ok = true;
    for (row<Bit> const& each : table) {
        ok = ok and rtuwire::flags<Bit>{}.with(each.bit).bits == each.word;
    }
    return ok;
}

constexpr bool status_bits()
{
    return stand<status_bit>({{status_bit::ready_to_switch_on, 0x0001},
                              {status_bit::switched_on, 0x0002},
                              {status_bit::operation_enabled, 0x0004},
                              {status_bit::fault, 0x0008},
                              {status_bit::voltage_enabled, 0x0010},
                              {status_bit::quick_stop, 0x0020},
                              {status_bit::switch_on_disabled, 0x0040},
                              {status_bit::warning, 0x0080},
                              {status_bit::remote, 0x0200},
                              {status_bit::reference_reached, 0x0400},
                              {status_bit::reference_out_of_limits, 0x0800},
                              {status_bit::stop_key, 0x4000},
                              {status_bit::reverse, 0x8000}});
}
PROOF("the bits of ETA", status_bits)

constexpr bool command_bits()
{
    return stand<command_bit>({{command_bit::switch_on, 0x0001},
                               {command_bit::enable_voltage, 0x0002},
                               {command_bit::quick_stop, 0x0004},
                               {command_bit::enable_operation, 0x0008},
                               {command_bit::fault_reset, 0x0080},
                               {command_bit::halt, 0x0100},
                               {command_bit::reverse, 0x0800}}) and
           stand<extended_command_bit>({{extended_command_bit::factory_settings, 0x0001},
                                        {extended_command_bit::save_to_eeprom, 0x0002},
                                        {extended_command_bit::standardized_frequency, 0x0200},
                                        {extended_command_bit::no_consistency_check, 0x8000}});
}
PROOF("the bits of CMD and CMI", command_bits)

constexpr bool extended_status_bits()
{
    using bit = extended_status_bit;
    return stand<bit>({{bit::eeprom_access, 0x0001},
                       {bit::consistency_check, 0x0002},
                       {bit::fault_is_gone, 0x0004},
                       {bit::speed_mode, 0x0010},
                       {bit::dc_injection, 0x0020},
                       {bit::transient, 0x0040},
                       {bit::motor_thermal_threshold, 0x0080},
                       {bit::excessive_braking, 0x0100},
                       {bit::accelerating, 0x0200},
                       {bit::decelerating, 0x0400},
                       {bit::current_limit, 0x0800},
                       {bit::fast_stop, 0x1000},
                       {bit::source_low, 0x2000},
                       {bit::source_high, 0x4000},
                       {bit::reverse_requested, 0x8000}});
}
PROOF("the bits of ETI", extended_status_bits)

constexpr bool other_bits()
{
    using fault = configuration_fault_bit;
    return stand<input_bit>({{input_bit::li1, 0x01},
                             {input_bit::li2, 0x02},
                             {input_bit::li3, 0x04},
                             {input_bit::li4, 0x08},
                             {input_bit::li5, 0x10},
                             {input_bit::li6, 0x20}}) and
           stand<fault>({{fault::rating_changed, 0x0001},
                         {fault::card_removed, 0x0004},
                         {fault::eeprom_inconsistent, 0x0008},
                         {fault::card_changed, 0x0010}});
}
PROOF("the bits of IL1R and CIC", other_bits)

} // namespace
