// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the command line and the configuration file say; words are not looked at here.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "output/output.hpp"
#include "words/option_words.hpp"

namespace tool {

/// How the program was called, for a command that it shows: quoted for a shell.
struct typed_line {
    std::string program{"rtuwire"};
    std::string options{};                ///< those of the line, without the three below: " -p /dev/ttyUSB0"
    std::string rate{};                   ///< " -b 9600 -f 8N1"
    std::string unit{};                   ///< " -u 7"
    std::string drive{};                  ///< " -d atv320"
    std::string stray_port{};             ///< an operand that looks like a port
    std::string stop{"stop"};             ///< the command that stops a motor there
    option_form form{option_form::typed}; ///< of the options that a message names
};

/// The line, and who is on it.
struct line_choices {
    std::string port{};
    unsigned baud{19'200};
    std::string format{"8E1"};
    bool is_rate_named{false};                ///< bit rate or format, by the command line or the file
    std::string unit{"1"};                    ///< a number, or one of `names`
    bool is_unit_named{false};                ///< by the command line or the file: it is not the 1 of nobody's choice
    std::string drive{};                      ///< empty: recognised by asking
    std::string device{};                     ///< a register file; empty: none
    bool knows_registers{false};              ///< the command uses register files, of --device and of --name
    std::vector<std::string> names{};         ///< "fan=7:atv320"
    std::optional<double> response_timeout{}; ///< seconds; nothing: as the command thinks best
    double late_response{
        0.2}; ///< seconds behind that time, for what comes too late to be waited for; see client_options
    unsigned retries{1};
    unsigned pause{0};             ///< milliseconds of silence before a request, where that is more than the line's
    bool has_echo{false};          ///< the line gives back what is sent
    bool must_switch_rs485{false}; ///< the driver switches the transceiver
    unsigned noise{0};             ///< bytes in front of a response that are skipped
    bool may_be_any_unit{false};   ///< 0 and 248 to 255, too
    bool is_verbose{false};        ///< each frame is shown on the standard error
    std::string trace_file{};      ///< and kept here; empty: nowhere
    bool is_trace_optional{false}; ///< where that cannot be kept, the frames pass all the same
    double listen{1.0};            ///< seconds before the first frame
    bool must_not_listen{false};   ///< speaks at once, on a line in use, too
    typed_line typed{};
};

/// What changes something needs to be allowed.
struct permissions {
    bool may_write{false};
    bool may_run{false};
    bool knows_run{true};     ///< false: the command has no --allow-run, so that no message says it
    bool is_confirmed{false}; ///< asks nobody back

    /// What would allow it, behind a reason: "; to write it, say --allow-run besides".
    [[nodiscard]] std::string by_run(std::string const& act) const
    {
        return knows_run ? "; to " + act + " it, say --allow-run besides" : std::string{};
    }
};

struct scan_choices {
    std::string units{"1-247"};
    std::vector<unsigned> bauds{};
    std::vector<std::string> formats{};
    std::string resume_file{};
};

struct monitor_choices {
    std::vector<std::string> plots{};  ///< "RFR@fan"
    std::vector<std::string> alarms{}; ///< "LCR=..8.5A"
    bool has_bell{false};
};

struct motion_choices {
    std::string speed{};     ///< "1200rpm"
    std::string frequency{}; ///< "40Hz"
    bool is_reverse{false};
    std::string stop_by{"ramp"};
};

/// What a restore may write besides ordinary settings.
struct restore_choices {
    bool dry_run{false};
    bool with_channels{false};
    bool with_link{false};
    bool with_inferred{false};
    bool with_supervision{false};
    bool with_autorestart{false};
    bool has_open_inputs{false}; ///< its user says so of a drive whose inputs cannot be read
    bool save{false};
};

/// What the one who checks allows and knows.
struct check_choices {
    std::string scratch{};       ///< "100-107": registers that may be changed
    std::string scratch_coils{}; ///< "0-15"
    bool is_alone{false};        ///< no other unit is on the line
    bool may_disrupt{false};     ///< counters are lost, the unit is silenced, what is not there is written
    std::optional<std::uint16_t> readable{};
    std::string only{};    ///< "L01,F03,I"
    unsigned hostile{0};   ///< seconds of random frames; 0: none
    std::uint32_t seed{1}; ///< of them
    bool lists{false};
    std::string explained{};   ///< a clause
    std::string profile{};     ///< a file
    std::string junit{};       ///< a file
    bool is_client{false};     ///< a client is checked, whose command is `choices::words`
    std::string client_port{}; ///< what it is told to open; empty: as the port is called
};

/// A line between two ports that is disturbed.
struct chaos_choices {
    std::string from{}; ///< where the client is
    std::string to{};   ///< where the server is
    std::string faults{};
    std::uint32_t seed{1};
    bool is_dry{false};
};

/// A line that many clients ask.
struct serve_choices {
    std::vector<std::string> listen{}; ///< "mbap://127.0.0.1:1502"; empty: that
    std::string units{};               ///< "1-4,7"; empty: all but drives
    std::string functions{};           ///< "3,4,16"; empty: all
    std::vector<std::string> from{};   ///< "192.168.1.0/24"; empty: from anywhere
    bool may_broadcast{false};
    std::string metrics{};        ///< "127.0.0.1:9502"; empty: none
    std::optional<double> idle{}; ///< seconds until a client that asks nothing is hung up on; nothing: 10 minutes
};

struct choices {
    std::string command{};
    output_form form{output_form::table};
    line_choices line{};
    permissions allowed{};
    scan_choices scan{};
    monitor_choices monitor{};
    motion_choices motion{};
    restore_choices restore{};
    check_choices check{};
    chaos_choices chaos{};
    serve_choices serve{};

    std::vector<std::string> words{}; ///< registers, bytes, drives
    bool finds_setting{false};        ///< tries the usual bit rates and formats
    std::string search{};
    std::string group{};
    bool is_factory{false};               ///< compares with the factory values
    bool may_rewrite{false};              ///< a register as it was read, with some bits changed
    std::vector<std::string> then_read{}; ///< registers that are read by the request that writes
    std::string file{};
    std::optional<std::uint16_t> base{}; ///< where the registers of a file begin that counts from there
    std::string capture_form{"udp"};
    std::optional<double> every{}; ///< seconds; nothing: as the command thinks best
    std::optional<double> last{};  ///< seconds; nothing: until somebody ends the program
    std::string vendor{};
    std::string sunspec{};   ///< a folder of models; empty: none
    bool only_checks{false}; ///< what a file says, and opens nothing
};

} // namespace tool
