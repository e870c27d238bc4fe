// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server of nanoMODBUS with all functions that have clauses, unit 1: nanomodbus_server DEVICE. 128 of each, from address 0.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include "nanomodbus_line.hpp"

namespace {

constexpr std::size_t size = 128;
std::array<std::uint16_t, size> holding, input;
std::array<bool, size> coils, contacts;

template <typename Bank>
nmbs_error read_bits(Bank const& bank, std::uint16_t first, std::uint16_t count, std::uint8_t* out)
{
    if (first + count > static_cast<int>(size)) {
        return NMBS_EXCEPTION_ILLEGAL_DATA_ADDRESS;
    }
    for (std::size_t i = 0; i < count; ++i) {
        nmbs_bitfield_write(out, i, (bank[first + i] ? 1 : 0));
    }
    return NMBS_ERROR_NONE;
}

template <typename Bank>
nmbs_error read_words(Bank const& bank, std::uint16_t first, std::uint16_t count, std::uint16_t* out)
{
    if (first + count > static_cast<int>(size)) {
        return NMBS_EXCEPTION_ILLEGAL_DATA_ADDRESS;
    }
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = bank[first + i];
    }
    return NMBS_ERROR_NONE;
}

nmbs_error write_words(std::uint16_t first, std::uint16_t count, std::uint16_t const* from, std::uint8_t, void*)
{
    if (first + count > static_cast<int>(size)) {
        return NMBS_EXCEPTION_ILLEGAL_DATA_ADDRESS;
    }
    for (std::size_t i = 0; i < count; ++i) {
        holding[first + i] = from[i];
    }
    return NMBS_ERROR_NONE;
}

nmbs_error write_bits(std::uint16_t first, std::uint16_t count, std::uint8_t const* from, std::uint8_t, void*)
{
    if (first + count > static_cast<int>(size)) {
        return NMBS_EXCEPTION_ILLEGAL_DATA_ADDRESS;
    }
    for (std::size_t i = 0; i < count; ++i) {
        coils[first + i] = nmbs_bitfield_read(from, i);
    }
    return NMBS_ERROR_NONE;
}

nmbs_callbacks all_callbacks()
{
    nmbs_callbacks all;
    nmbs_callbacks_create(&all);
    all.read_coils = [](std::uint16_t first, std::uint16_t count, std::uint8_t* out, std::uint8_t, void*) {
        return read_bits(coils, first, count, out);
    };
    all.read_discrete_inputs = [](std::uint16_t first, std::uint16_t count, std::uint8_t* out, std::uint8_t, void*) {
        return read_bits(contacts, first, count, out);
    };
    all.read_holding_registers = [](std::uint16_t first, std::uint16_t count, std::uint16_t* out, std::uint8_t, void*) {
        return read_words(holding, first, count, out);
    };
    all.read_input_registers = [](std::uint16_t first, std::uint16_t count, std::uint16_t* out, std::uint8_t, void*) {
        return read_words(input, first, count, out);
    };
    all.write_single_coil = [](std::uint16_t at, bool value, std::uint8_t unit, void* nothing) {
        std::uint8_t const bit = value ? 1 : 0;
        return write_bits(at, 1, &bit, unit, nothing);
    };
    all.write_single_register = [](std::uint16_t at, std::uint16_t value, std::uint8_t unit, void* nothing) {
        return write_words(at, 1, &value, unit, nothing);
    };
    all.write_multiple_coils = write_bits;
    all.write_multiple_registers = write_words;
    all.read_device_identification_map = [](std::uint8_t* map) {
        for (int object = 0; object < 7; ++object) {
            nmbs_bitfield_set(map, object);
        }
        return NMBS_ERROR_NONE;
    };
    all.read_device_identification = [](std::uint8_t object, char* text) {
        std::snprintf(text, NMBS_DEVICE_IDENTIFICATION_STRING_LENGTH, "object %u", static_cast<unsigned>(object));
        return NMBS_ERROR_NONE;
    };
    return all;
}

} // namespace

int main(int argc, char** argv)
{
    int device = argc == 2 ? open_serial_line(argv[1]) : -1;
    nmbs_platform_conf const platform = nanomodbus_line(device);
    nmbs_callbacks const callbacks = all_callbacks();
    nmbs_t node;
    if (device < 0 or nmbs_server_create(&node, 1, &platform, &callbacks) != NMBS_ERROR_NONE) {
        std::fprintf(stderr, "nanoMODBUS cannot serve on the device\n");
        return 2;
    }
    nmbs_set_read_timeout(&node, 1'000);
    nmbs_set_byte_timeout(&node, 100);
    std::puts("ready");
    std::fflush(stdout);
    for (;;) {
        nmbs_server_poll(&node);
    }
}
