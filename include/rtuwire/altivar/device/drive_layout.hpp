// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a controller needs to know of a drive beyond its registers: where its words are and how its state machine
// differs; and what a simulated drive does besides. Each device carries it as data, so that no conversation depends on
// a model's name. How the table of a drive is read:
//
//     reg<deciseconds> tto{"TTO", 6005, is::cfg, 1, 300, {}, "Communication time-out", is::inferred};
//     what it holds: mnemonic, address, who may write it, least, most, as delivered, name, where that is from
//
// `is::rw` is written at any time, `is::cfg` only at rest, `is::ro` never. Limits and the value as delivered are counts of
// its step; `{}` is none, or not known. A limit may be another register: "TFR". What is documented does not say so.
#pragma once

#include <array>
#include <cstdint>

#include <rtuwire/cia402/transition.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/register.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The words of two columns in the table of a drive.
/// Internal.
namespace is {

inline constexpr access ro = access::read_only, rw = access::read_write, cfg = access::configuration;
inline constexpr provenance documented = provenance::documented, inferred = provenance::inferred,
                            doubtful = provenance::doubtful;

} // namespace is

/// Status bits that all Altivars share, beside those of the state.
/// Internal.
inline constexpr std::uint16_t remote_bit = 0x0200; ///< 0 in local control
inline constexpr std::uint16_t reference_reached_bit = 0x0400;
inline constexpr std::uint16_t reference_limited_bit = 0x0800; ///< below LSP or above HSP
/// Internal.
inline constexpr std::uint16_t stop_key_bit = 0x4000;
inline constexpr std::uint16_t runs_backwards_bit = 0x8000;

/// Control bits that all Altivars share.
/// Internal.
inline constexpr std::uint16_t reverse_bit = 0x0800;
/// Internal.
inline constexpr std::uint16_t save_bit = 0x0002; ///< of CMI

/// The registers with a drive's reaction to a lost link, its channels of command and reference, and its automatic
/// restart. Address 0: the drive has no such register.
struct safeguard_layout {
    std::uint16_t sll{0};             ///< reaction to a lost link
    std::uint16_t tto{0};             ///< time-out, 0.1 s
    std::uint16_t nto{0};             ///< the bit of CMI that switches a fixed time-out off
    duration fixed_timeout{};         ///< where there is no TTO
    std::uint16_t chcf{0};            ///< whether command and reference have one channel
    std::uint16_t cd1{0};             ///< channel of the command
    std::uint16_t fr1{0};             ///< channel of the reference
    std::uint16_t flo{0};             ///< the input that forces local control
    std::uint16_t atr{0};             ///< automatic restart
    std::uint16_t dotd{0};            ///< how "disable operation" stops; 0: on the ramp
    std::uint16_t inputs{0};          ///< image of the logic inputs, LI1 in bit 0
    std::uint16_t tcc{0};             ///< two-wire or three-wire control by the terminals
    bool is_local_at_power_up{false}; ///< terminals command until the link does: only then a start reads the two above;
                                      ///< `set_channel`, a restore and the like read them of every drive
};

/// Addresses and behaviour of one drive, as a controller has to know them. Its scanner and its cycle are in
/// altivar/device/cycle_registers.hpp.
struct drive_layout {
    std::uint16_t cmd;    ///< control word
    std::uint16_t eta;    ///< status word
    std::uint16_t lft;    ///< last fault
    std::uint16_t cmi;    ///< extended control word
    std::uint16_t eti;    ///< extended status word
    std::uint16_t rfr;    ///< output frequency, signed, 0.1 Hz
    std::uint16_t lsp{0}; ///< the motor's lowest frequency, 0.1 Hz; 0: its register is not known
    std::uint16_t hsp{0}; ///< its highest one
    std::uint16_t frs{0}; ///< its rated frequency, 0.1 Hz
    std::uint16_t nsp{0}; ///< its rated speed, rpm; with FRS, the pairs of poles
    std::uint16_t sds{0}; ///< what 1 Hz is in rpm, where the drive does not count poles
    cia402::state_machine_options state_machine{};
    bool mains_bit_is_inverted{false};              ///< status bit 4 is 1 without mains
    bool refuses_commands_in_local{false};          ///< with an exception, instead of ignoring them
    bool shows_forced_local_only{false};            ///< status bit 9 stays 1 for another channel in command
    bool falls_back_when_configured{true};          ///< from "switched on", by transition 10
    bool shows_eeprom_access{true};                 ///< ETI bit 0 is 1 while it saves
    std::uint16_t halt{detail::halt_bit};           ///< or-ed to the control word; 0: has no halt
    std::uint16_t dc_injection{0};                  ///< the control word for it; 0: has none
    std::uint16_t direct_control{0};                ///< the bit of its direct control words; 0: has none
    duration longest_silence{milliseconds(30'000)}; ///< without a request until it trips; the most that can be set
    bool fails_when_cut_short{false};       ///< trips where a second request comes before its response to the first
    duration eeprom_time{milliseconds(50)}; ///< without communication while it saves
    std::uint16_t cmi_orders{0x0003};       ///< the bits of CMI that do something: factory settings, save
    std::uint16_t other_cmd{0};             ///< where the other family has its control word, which this one refuses
    safeguard_layout safeguards{};
    /// What a check reads before an order, in the order of `safeguard`; 0: the drive has none. It follows from the rest.
    std::array<std::uint16_t, 15> checked{checked_of(*this)};

    [[nodiscard]] static constexpr std::array<std::uint16_t, 15> checked_of(drive_layout const& all) noexcept
    {
        safeguard_layout const& at = all.safeguards;
        bool const is_local_first = at.is_local_at_power_up;
        return {all.hsp,
                all.lsp,
                all.frs,
                all.nsp != 0 ? all.nsp : all.sds,
                at.nto != 0 ? all.cmi : at.sll,
                at.tto,
                at.chcf,
                at.cd1,
                at.fr1,
                at.flo,
                at.atr,
                at.dotd,
                is_local_first ? at.tcc : std::uint16_t{0},
                is_local_first ? at.inputs : std::uint16_t{0},
                all.eta};
    }
};

/// What a simulated drive does besides, which no controller has to know: a drive that differs from an ATV320 here has
/// `static constexpr simulated_behaviour behaviour{...}`.
struct simulated_behaviour {
    duration eeprom_work{milliseconds(100)};    ///< the time that an order in CMI takes
    bool is_silent_while_saving{false};         ///< it receives nothing in this time
    bool clears_eeprom_orders{false};           ///< their bits in CMI are 0 after it
    bool forgets_orders_on_loss{false};         ///< even where it restarts by itself
    bool sets_line_at_power_up{false};          ///< a new bit rate or format waits for that
    std::uint16_t extended_status_bits{0xFFFF}; ///< the bits of ETI that it has
    std::uint16_t input_bits{0xFFFF};           ///< the bits of `safeguards.inputs` that are inputs
    std::uint16_t fast_stop{1};                 ///< STT, the normal stop: by the fast ramp
    std::uint16_t freewheel{2};                 ///< without power
    std::uint16_t dc_injection{3};              ///< by DC injection; another value: on the ramp
};

/// CHCF of a drive whose control word runs and reverses by single bits.
/// Internal.
inline constexpr std::uint16_t io_profile = 3;

/// How a drive interprets its control word. An ATV320 in its I/O profile (CHCF) may run on the words that stop all other
/// drives.
enum class word_meaning : std::uint8_t { unknown, cia402 };

/// Whether a CHCF, as read, is the drive profile: command and reference together, or apart.
/// Internal.
[[nodiscard]] constexpr bool is_drive_profile(std::uint16_t chcf) noexcept { return chcf == 1 or chcf == 2; }

/// The control word of the later family. Each of the two families refuses the address of the other.
/// Internal.
inline constexpr std::uint16_t later_control_word = 8501;

/// Whether an ATV320 may be where a drive of this type is said to be, so that only 0000 is known to stop it.
/// Internal.
[[nodiscard]] constexpr bool may_have_io_profile(drive_layout const& layout) noexcept
{
    return layout.cmd == later_control_word;
}

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
