// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A request of each function beside those of holding registers, its good response, and ten and more frames that are none:
// what the specification makes of them, as the error that a client tells.
#pragma once

#include <vector>

#include <rtuwire/serial_line.hpp>
#include <rtuwire/wire/functions.hpp>

namespace rtuwire::test {

/// A frame in the place of a response, and what a client makes of it.
struct response_row {
    char const* frame;
    errc expected;
    char const* why;
};
using response_rows = std::vector<response_row>;

/// Calls `visit` with each request, the frame of its good response, and rows.
template <typename Visit> void for_each_request(Visit const& visit)
{
    visit(read_coils{0x13, 19}, "01 01 03 CD 6B 05 42 82",
          response_rows{
              {"01 01 03 CD 6B 05 43 82", errc::crc_mismatch, "its CRC is wrong"},
              {"01 01 00 21 90", errc::wrong_length, "no data"},
              {"01 01 02 CD 6B AC 83", errc::wrong_length, "a byte less than was asked"},
              {"01 01 04 CD 6B 05 00 B7 F1", errc::wrong_length, "a byte more than was asked"},
              {"01 01 03 CD 6B FD 43", errc::wrong_length, "a byte less than its byte count tells"},
              {"01 01 03 CD 6B 05 00 02 31", errc::wrong_length, "a byte more than its byte count tells"},
              {"01 01 13 CD 6B 05 46 42", errc::wrong_length, "the quantity in the place of the byte count"},
              {"01 02 03 CD 6B 05 06 82", errc::wrong_function, "of another function"},
              {"02 01 03 CD 6B 05 42 B1", errc::timed_out, "of another unit: the time runs on"},
              {"01 01 00 13 00 13 8C 02", errc::line_echo, "the request itself"},
              {"01 81 02 C1 91", errc::illegal_data_address, "an exception"},
              {"01 81 02 00 50 90", errc::wrong_length, "an exception with a byte behind its code"},
          });
    visit(read_discrete_inputs{0xC4, 22}, "01 02 03 AC DB 35 22 88",
          response_rows{
              {"01 02 03 AC DB 35 23 88", errc::crc_mismatch, "its CRC is wrong"},
              {"01 02 00 21 60", errc::wrong_length, "no data"},
              {"01 02 02 AC DB 84 E3", errc::wrong_length, "a byte less than was asked"},
              {"01 02 04 AC DB 35 00 BD D9", errc::wrong_length, "a byte more than was asked"},
              {"01 02 03 AC DB D5 23", errc::wrong_length, "a byte less than its byte count tells"},
              {"01 02 03 AC DB 35 00 08 19", errc::wrong_length, "a byte more than its byte count tells"},
              {"01 02 16 AC DB 35 26 84", errc::wrong_length, "the quantity in the place of the byte count"},
              {"01 01 03 AC DB 35 66 88", errc::wrong_function, "of another function"},
              {"02 02 03 AC DB 35 22 BB", errc::timed_out, "of another unit: the time runs on"},
              {"01 02 00 C4 00 16 B8 39", errc::line_echo, "the request itself"},
              {"01 82 02 C1 61", errc::illegal_data_address, "an exception"},
              {"01 82 02 00 A0 90", errc::wrong_length, "an exception with a byte behind its code"},
          });
    visit(read_input_registers{8, 2}, "01 04 04 00 0A 00 0B 9A 41",
          response_rows{
              {"01 04 04 00 0A 00 0B 9B 41", errc::crc_mismatch, "its CRC is wrong"},
              {"01 04 00 22 C0", errc::wrong_length, "no data"},
              {"01 04 03 00 0A 00 F6 EE", errc::wrong_length, "a byte less than was asked"},
              {"01 04 05 00 0A 00 0B 00 C0 BA", errc::wrong_length, "a byte more than was asked"},
              {"01 04 04 00 0A 00 F7 9A", errc::wrong_length, "a byte less than its byte count tells"},
              {"01 04 04 00 0A 00 0B 00 C1 6B", errc::wrong_length, "a byte more than its byte count tells"},
              {"01 04 02 00 0A 00 0B 12 41", errc::wrong_length, "the quantity in the place of the byte count"},
              {"01 03 04 00 0A 00 0B 9B F6", errc::wrong_function, "of another function"},
              {"02 04 04 00 0A 00 0B A9 41", errc::timed_out, "of another unit: the time runs on"},
              {"01 04 00 08 00 02 F0 09", errc::line_echo, "the request itself"},
              {"01 84 02 C2 C1", errc::illegal_data_address, "an exception"},
              {"01 84 02 00 40 91", errc::wrong_length, "an exception with a byte behind its code"},
          });
    visit(write_single_coil{0xAC, true}, "01 05 00 AC FF 00 4C 1B",
          response_rows{
              {"01 05 00 AC FF 00 4D 1B", errc::crc_mismatch, "its CRC is wrong"},
              {"01 05 00 AC FF 00 1B 4C", errc::crc_mismatch, "the bytes of its CRC are in the other order"},
              {"01 05 00 AC FF 24 4C", errc::wrong_length, "a byte less than the function has"},
              {"01 05 00 AC FF 00 00 1A F5", errc::wrong_length, "a byte more than the function has"},
              {"01 06 00 AC FF 00 08 1B", errc::wrong_function, "of another function"},
              {"02 05 00 AC FF 00 4C 28", errc::timed_out, "of another unit: the time runs on"},
              {"01 85 03 02 91", errc::illegal_data_value, "an exception"},
              {"01 85 00 42 90", errc::unlisted_exception, "an exception with code 0"},
              {"01 85 81 82 F0", errc::unlisted_exception, "an exception with a code past 7F"},
              {"01 85 C1 83", errc::wrong_length, "an exception without its code"},
              {"01 05 00 AC 00 00 0D EB", errc::response_mismatch, "the coil is off"},
              {"01 05 00 AD FF 00 1D DB", errc::response_mismatch, "another coil"},
              {"01 05 00 AC 00 FF 4D AB", errc::response_mismatch, "a value that is none"},
              {"01 05 00 AC FF 01 8D DB", errc::response_mismatch, "a value that is none"},
          });
    visit(read_exception_status{}, "01 07 6D E3 DD",
          response_rows{
              {"01 07 6D E2 DD", errc::crc_mismatch, "its CRC is wrong"},
              {"01 07 41 E2", errc::line_echo, "the request itself"},
              {"01 07 6D 00 9C 89", errc::wrong_length, "a byte more than the function has"},
              {"01 07 01 6D 70 64", errc::wrong_length, "a byte count before the outputs"},
              {"01 06 6D E2 4D", errc::wrong_function, "of another function"},
              {"02 07 6D 13 DD", errc::timed_out, "of another unit: the time runs on"},
              {"01 87 01 82 30", errc::illegal_function, "an exception"},
              {"01 87 FF 03 B0", errc::unlisted_exception, "an exception with a code past 7F"},
              {"01 87 01 00 B0 61", errc::wrong_length, "an exception with a byte behind its code"},
              {"01 87 40 42", errc::wrong_length, "an exception without its code"},
              {"00 07 6D B2 1D", errc::timed_out, "of unit 0, which no unit is: the time runs on"},
          });
    visit(diagnostics{subfunction::return_query_data, register_block{0xA537}}, "01 08 00 00 A5 37 DA 8D",
          response_rows{
              {"01 08 00 00 A5 37 DB 8D", errc::crc_mismatch, "its CRC is wrong"},
              {"01 08 00 00 A5 38 9A 89", errc::response_mismatch, "other data"},
              {"01 08 00 01 A5 37 8B 4D", errc::response_mismatch, "another sub-function"},
              {"01 08 00 00 A5 37 00 00 9B 05", errc::wrong_length, "a word more than was sent"},
              {"01 08 00 00 80 1A", errc::wrong_length, "no data"},
              {"01 08 00 00 A5 DB DB", errc::wrong_length, "half a word"},
              {"01 08 00 00 37 A5 36 40", errc::response_mismatch, "the bytes of the word in the other order"},
              {"01 07 00 00 A5 37 8E 8C", errc::wrong_function, "of another function"},
              {"02 08 00 00 A5 37 DA BE", errc::timed_out, "of another unit: the time runs on"},
              {"01 88 03 06 01", errc::illegal_data_value, "an exception"},
              {"01 88 03 00 81 02", errc::wrong_length, "an exception with a byte behind its code"},
          });
    visit(get_comm_event_counter{}, "01 0B FF FF 01 08 A4 79",
          response_rows{
              {"01 0B FF FF 01 08 A5 79", errc::crc_mismatch, "its CRC is wrong"},
              {"01 0B 41 E7", errc::line_echo, "the request itself"},
              {"01 0B FF FF 01 AB E4", errc::wrong_length, "a byte less than the function has"},
              {"01 0B FF FF 01 08 00 78 BB", errc::wrong_length, "a byte more than the function has"},
              {"01 0B 04 FF FF 01 08 FB 09", errc::wrong_length, "a byte count, as function 12 has"},
              {"01 0B 00 01 01 08 F5 9D", errc::malformed, "a status that is neither 0000 nor FFFF"},
              {"01 0B FF 00 01 08 94 49", errc::malformed, "a status that is neither 0000 nor FFFF"},
              {"01 0C FF FF 01 08 11 B9", errc::wrong_function, "of another function"},
              {"02 0B FF FF 01 08 A4 4A", errc::timed_out, "of another unit: the time runs on"},
              {"01 8B 04 47 33", errc::server_device_failure, "an exception"},
              {"01 8B 00 46 F0", errc::unlisted_exception, "an exception with code 0"},
          });
    visit(
        get_comm_event_log{}, "01 0C 08 00 00 01 08 01 21 20 00 0D C1",
        response_rows{
            {"01 0C 08 00 00 01 08 01 21 20 00 0C C1", errc::crc_mismatch, "its CRC is wrong"},
            {"01 0C 00 25", errc::line_echo, "the request itself"},
            {"01 0C 00 25 00", errc::wrong_length, "no data: begins with the whole request"},
            {"01 0C 05 00 00 01 08 01 DA 52", errc::wrong_length, "a byte less than status and counters"},
            {"01 0C 08 00 00 01 08 01 21 20 02 8C", errc::wrong_length, "a byte less than its byte count tells"},
            {"01 0C 08 00 00 01 08 01 21 20 00 00 00 C5", errc::wrong_length, "a byte more than its byte count tells"},
            {"01 0C 47 00 00 01 08 01 21 20*65 B3 2B", errc::wrong_length, "65 events: longer than a response can be"},
            {"01 0C 08 00 FF 01 08 01 21 20 00 02 CE", errc::malformed, "a status that is neither 0000 nor FFFF"},
            {"01 0B 08 00 00 01 08 01 21 20 00 BC 1B", errc::wrong_function, "of another function"},
            {"02 0C 08 00 00 01 08 01 21 20 00 02 85", errc::timed_out, "of another unit: the time runs on"},
            {"01 8C 04 45 03", errc::server_device_failure, "an exception"},
        });
    visit(write_multiple_coils{0x13, bit_block{true, false, true, true, false, false, true, true, true, false}},
          "01 0F 00 13 00 0A 24 09",
          response_rows{
              {"01 0F 00 13 00 0A 25 09", errc::crc_mismatch, "its CRC is wrong"},
              {"01 0F 00 13 00 0A 09 24", errc::crc_mismatch, "the bytes of its CRC are in the other order"},
              {"01 0F 00 13 00 17 E4", errc::wrong_length, "a byte less than the function has"},
              {"01 0F 00 13 00 0A 00 09 1B", errc::wrong_length, "a byte more than the function has"},
              {"01 10 00 13 00 0A B1 CB", errc::wrong_function, "of another function"},
              {"02 0F 00 13 00 0A 24 3A", errc::timed_out, "of another unit: the time runs on"},
              {"01 8F 03 04 31", errc::illegal_data_value, "an exception"},
              {"01 8F 00 44 30", errc::unlisted_exception, "an exception with code 0"},
              {"01 8F 81 84 50", errc::unlisted_exception, "an exception with a code past 7F"},
              {"01 8F 41 84", errc::wrong_length, "an exception without its code"},
              {"01 0F 00 13 00 09 64 08", errc::response_mismatch, "a coil less"},
              {"01 0F 00 14 00 0A 95 C8", errc::response_mismatch, "from another coil on"},
              {"01 0F 00 13 00 02 25 CF", errc::response_mismatch, "the byte count in the place of the quantity"},
              {"01 0F 00 13 00 0A 02 CD 01 72 CB", errc::line_echo, "the request itself"},
          });
    visit(report_server_id{}, "01 11 03 B4 FF 41 3C 6B",
          response_rows{
              {"01 11 03 B4 FF 41 3D 6B", errc::crc_mismatch, "its CRC is wrong"},
              {"01 11 C0 2C", errc::line_echo, "the request itself"},
              {"01 11 00 2C 50", errc::invalid_quantity, "neither an identifier nor a run indicator"},
              {"01 11 03 B4 FF DB BC", errc::wrong_length, "a byte less than its byte count tells"},
              {"01 11 03 B4 FF 41 00 6B 11", errc::wrong_length, "a byte more than its byte count tells"},
              {"01 11 B4 FF 41 DD 1A", errc::wrong_length, "no byte count"},
              {"01 11 FC 00*252 82 FE", errc::frame_too_long, "252 bytes, one more than a frame carries"},
              {"01 11 FF 00*200 9C DF", errc::wrong_length, "200 bytes of 255 that are told"},
              {"01 10 03 B4 FF 41 01 AB", errc::wrong_function, "of another function"},
              {"02 11 03 B4 FF 41 3C 58", errc::timed_out, "of another unit: the time runs on"},
              {"01 91 04 4C 53", errc::server_device_failure, "an exception"},
          });
    visit(
        read_file_record{file_run{4, 1, 2}, file_run{3, 9, 2}}, "01 14 0C 05 06 0D FE 00 20 05 06 33 CD 00 40 79 A1",
        response_rows{
            {"01 14 0C 05 06 0D FE 00 20 05 06 33 CD 00 40 78 A1", errc::crc_mismatch, "its CRC is wrong"},
            {"01 14 0E 06 00 04 00 01 00 02 06 00 03 00 09 00 02 F4 FD", errc::line_echo, "the request itself"},
            {"01 14 00 2F 00", errc::response_mismatch, "no run"},
            {"01 14 06 05 06 0D FE 00 20 8B 4E", errc::response_mismatch, "the first run only"},
            {"01 14 0C 03 06 0D FE 07 06 00 20 33 CD 00 40 7E 1F", errc::response_mismatch,
             "a record for two, then three for two"},
            {"01 14 0C 05 07 0D FE 00 20 05 06 33 CD 00 40 7D 5D", errc::response_mismatch, "another reference than 6"},
            {"01 14 0C 06 05 0D FE 00 20 06 05 33 CD 00 40 36 D2", errc::response_mismatch,
             "size and reference in the other order"},
            {"01 14 0C 04 06 0D FE 00 20 04 06 33 CD 00 40 85 B3", errc::response_mismatch,
             "sizes that do not count the reference"},
            {"01 14 0C 02 06 0D FE 00 20 02 06 33 CD 00 40 8D DD", errc::response_mismatch, "sizes in registers"},
            {"01 14 12 05 06 0D FE 00 20 05 06 33 CD 00 40 05 06 33 CD 00 40 0F 44", errc::wrong_length,
             "a third run, which was not asked"},
            {"01 14 0C 05 06 0D FE 00 20 05 06 33 CD 00 C3 38", errc::wrong_length,
             "a byte less than its byte count tells"},
            {"01 15 0C 05 06 0D FE 00 20 05 06 33 CD 00 40 79 60", errc::wrong_function, "of another function"},
            {"02 14 0C 05 06 0D FE 00 20 05 06 33 CD 00 40 3A A0", errc::timed_out,
             "of another unit: the time runs on"},
            {"01 94 08 4F 06", errc::memory_parity_error, "an exception"},
        });
    visit(write_file_record{4, 7, register_block{0x06AF, 0x04BE, 0x100D}},
          "01 15 0D 06 00 04 00 07 00 03 06 AF 04 BE 10 0D D6 0B",
          response_rows{
              {"01 15 0D 06 00 04 00 07 00 03 06 AF 04 BE 10 0D D7 0B", errc::crc_mismatch, "its CRC is wrong"},
              {"01 15 0D 06 00 04 00 07 00 03 06 AF 04 BE 10 0D 0B D6", errc::crc_mismatch,
               "the bytes of its CRC are in the other order"},
              {"01 15 0D 06 00 04 00 07 00 03 06 AF 04 BE 10 16 96", errc::wrong_length,
               "a byte less than the function has"},
              {"01 15 0D 06 00 04 00 07 00 03 06 AF 04 BE 10 0D 00 8A 9E", errc::wrong_length,
               "a byte more than the function has"},
              {"01 14 0D 06 00 04 00 07 00 03 06 AF 04 BE 10 0D 17 0B", errc::wrong_function, "of another function"},
              {"02 15 0D 06 00 04 00 07 00 03 06 AF 04 BE 10 0D 96 FA", errc::timed_out,
               "of another unit: the time runs on"},
              {"01 95 03 0F 51", errc::illegal_data_value, "an exception"},
              {"01 95 00 4F 50", errc::unlisted_exception, "an exception with code 0"},
              {"01 95 81 8F 30", errc::unlisted_exception, "an exception with a code past 7F"},
              {"01 95 C0 4F", errc::wrong_length, "an exception without its code"},
              {"01 15 0D 06 00 05 00 07 00 03 06 AF 04 BE 10 0D D2 F7", errc::response_mismatch, "another file"},
              {"01 15 0D 06 00 04 00 08 00 03 06 AF 04 BE 10 0D 97 FB", errc::response_mismatch, "another record"},
              {"01 15 0D 06 00 04 00 07 00 03 06 AF 04 BE 10 0C 17 CB", errc::response_mismatch, "another value"},
              {"01 15 0D 05 00 04 00 07 00 03 06 AF 04 BE 10 0D D3 C8", errc::response_mismatch,
               "another reference than 6"},
              {"01 15 0B 06 00 04 00 07 00 02 06 AF 04 BE ED DF", errc::wrong_length, "two records for three"},
              {"01 15 07 06 00 04 00 07 00 03 F4 B4", errc::wrong_length, "without its records"},
          });
    visit(mask_write_register{4, 0xF2, 0x25}, "01 16 00 04 00 F2 00 25 67 EE",
          response_rows{
              {"01 16 00 04 00 F2 00 25 66 EE", errc::crc_mismatch, "its CRC is wrong"},
              {"01 16 00 04 00 F2 00 25 EE 67", errc::crc_mismatch, "the bytes of its CRC are in the other order"},
              {"01 16 00 04 00 F2 00 4D 66", errc::wrong_length, "a byte less than the function has"},
              {"01 16 00 04 00 F2 00 25 00 AF EA", errc::wrong_length, "a byte more than the function has"},
              {"01 06 00 04 00 F2 00 25 76 2F", errc::wrong_function, "of another function"},
              {"02 16 00 04 00 F2 00 25 27 FB", errc::timed_out, "of another unit: the time runs on"},
              {"01 96 03 0F A1", errc::illegal_data_value, "an exception"},
              {"01 96 00 4F A0", errc::unlisted_exception, "an exception with code 0"},
              {"01 96 81 8F C0", errc::unlisted_exception, "an exception with a code past 7F"},
              {"01 96 80 4E", errc::wrong_length, "an exception without its code"},
              {"01 16 00 05 00 F2 00 25 5A 2E", errc::response_mismatch, "another register"},
              {"01 16 00 04 00 F3 00 25 36 2E", errc::response_mismatch, "another AND mask"},
              {"01 16 00 04 00 F2 00 24 A6 2E", errc::response_mismatch, "another OR mask"},
              {"01 16 00 04 00 25 00 F2 97 88", errc::response_mismatch, "the masks in the other order"},
          });
    visit(
        read_fifo_queue{0x04DE}, "01 18 00 06 00 02 01 B8 12 84 19 18",
        response_rows{
            {"01 18 00 06 00 02 01 B8 12 84 18 18", errc::crc_mismatch, "its CRC is wrong"},
            {"01 18 04 DE 03 47", errc::line_echo, "the request itself"},
            {"01 18 00 06 00 01 01 B8 12 84 5D 18", errc::wrong_length, "two registers, of which it counts one"},
            {"01 18 00 06 00 06 01 B8 12 84 E8 D8", errc::wrong_length, "the count in bytes"},
            {"01 18 00 04 00 02 01 B8 12 84 3A D8", errc::wrong_length, "a byte count that does not include the count"},
            {"01 18 00 06 00 02 01 B8 31 E4", errc::wrong_length, "a register less than its byte count tells"},
            {"01 18 00 00 81 DF", errc::wrong_length, "no count"},
            {"01 18 06 00 02 01 B8 12 84 95 10", errc::wrong_length, "a byte count of eight bits"},
            {"01 18 00 42 00 20 00*64 25 A1", errc::wrong_length, "32 registers: longer than a response can be"},
            {"01 18 01 06 00 02 01 B8 12 84 D8 D4", errc::wrong_length, "a byte count past the longest frame"},
            {"01 17 00 06 00 02 01 B8 12 84 58 E8", errc::wrong_function, "of another function"},
            {"02 18 00 06 00 02 01 B8 12 84 E9 17", errc::timed_out, "of another unit: the time runs on"},
            {"01 98 03 0B C1", errc::illegal_data_value, "an exception: the queue is longer than a response"},
        });
}

} // namespace rtuwire::test
