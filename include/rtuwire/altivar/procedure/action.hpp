// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What goes into a procedure, and what comes out of it: events and actions. An action is one number: a 32-bit processor
// returns that in two registers, and a class of the same size through memory.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/ask/commander.hpp>
#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// What happened. Two words, which go in two registers.
class event {
public:
    enum class kind : std::uint8_t {
        begun,      ///< `word` is not 0 where this client has ordered the motor to run
        word_read,  ///< `word` is what was read
        written,    ///< the drive confirmed the write
        failed,     ///< a read or write failed; `error` tells why
        pause_over, ///< the pause that was requested has passed
        late,       ///< the time limit has passed; the last request was not sent, and one more is allowed
    };

    /// `second` is the word behind it, where two were to be read.
    constexpr event(kind what = kind::begun, std::uint16_t word = 0, errc error = errc::none,
                    std::uint16_t second = 0) noexcept
        : bits_{static_cast<std::uint64_t>(what) | static_cast<std::uint64_t>(word) << 16U |
                static_cast<std::uint64_t>(error) << 32U | static_cast<std::uint64_t>(second) << 48U}
    {}

    [[nodiscard]] constexpr kind what() const noexcept { return static_cast<kind>(bits_ & 0xFFU); }
    [[nodiscard]] constexpr std::uint16_t word() const noexcept { return static_cast<std::uint16_t>(bits_ >> 16U); }
    [[nodiscard]] constexpr errc error() const noexcept { return static_cast<errc>(bits_ >> 32U & 0xFFU); }
    [[nodiscard]] constexpr std::uint16_t second() const noexcept { return static_cast<std::uint16_t>(bits_ >> 48U); }

private:
    std::uint64_t bits_;
};

enum class action_kind : std::uint8_t { read, write, pause, end };

/// What to do next.
///
/// | bits   | what                                                        | of              |
/// |--------|-------------------------------------------------------------|-----------------|
/// | 0..1   | `action_kind`                                               | all             |
/// | 2      | two neighbouring words are read, not one                    | a read          |
/// | 3      | it is sent once                                             | a request       |
/// | 4..6   | `effect`                                                    | a write         |
/// | 7      | it fails if it cannot be sent for `longest_gap_in_presence` | a write         |
/// | 16..31 | address                                                     | a request       |
/// | 32..47 | word                                                        | a write         |
/// | 32..63 | length in microseconds; a read fails if it cannot be sent for so long, unless that is 0 | a pause, a read |
enum class action : std::uint64_t {};

[[nodiscard]] constexpr action_kind what_of(action of) noexcept
{
    return static_cast<action_kind>(static_cast<unsigned>(of) & 3U);
}
[[nodiscard]] constexpr std::uint8_t count_of(action of) noexcept
{
    return (static_cast<unsigned>(of) & 4U) == 0 ? 1 : 2;
}
[[nodiscard]] constexpr repetition repetition_of(action of) noexcept
{
    return (static_cast<unsigned>(of) & 8U) == 0 ? repetition::allowed : repetition::never;
}
[[nodiscard]] constexpr detail::effect effect_of(action of) noexcept
{
    return static_cast<detail::effect>(static_cast<unsigned>(of) >> 4U & 7U);
}
[[nodiscard]] constexpr std::uint16_t address_of(action of) noexcept
{
    return static_cast<std::uint16_t>(static_cast<std::uint32_t>(of) >> 16U);
}
[[nodiscard]] constexpr std::uint16_t word_of(action of) noexcept
{
    return static_cast<std::uint16_t>(static_cast<std::uint64_t>(of) >> 32U);
}
[[nodiscard]] constexpr duration length_of(action of) noexcept
{
    if (what_of(of) == action_kind::write) {
        return (static_cast<unsigned>(of) & 0x80U) == 0 ? duration{} : detail::longest_gap_in_presence;
    }
    return duration{static_cast<std::uint32_t>(static_cast<std::uint64_t>(of) >> 32U)};
}

} // namespace altivar

namespace detail {

constexpr altivar::action with(altivar::action what, std::uint64_t bits, unsigned at) noexcept
{
    return altivar::action{static_cast<std::uint64_t>(what) | bits << at};
}

constexpr altivar::action to_write(std::uint16_t address, std::uint16_t word, effect does) noexcept
{
    constexpr altivar::action write{static_cast<std::uint64_t>(altivar::action_kind::write)};
    return with(with(with(write, static_cast<std::uint64_t>(does), 4), address, 16), word, 32);
}

} // namespace detail

namespace altivar {

[[nodiscard]] constexpr action to_read(std::uint16_t address) noexcept
{
    return detail::with(action{static_cast<std::uint64_t>(action_kind::read)}, address, 16);
}
/// Two neighbouring words, by one request.
[[nodiscard]] constexpr action to_read_two(std::uint16_t address) noexcept
{
    return detail::with(to_read(address), 1, 2);
}
[[nodiscard]] constexpr action to_write(std::uint16_t address, std::uint16_t word) noexcept
{
    return detail::to_write(address, word, detail::effect::none);
}
[[nodiscard]] constexpr action to_pause(duration length) noexcept
{
    return detail::with(action{static_cast<std::uint64_t>(action_kind::pause)}, length.microseconds, 32);
}
inline constexpr action to_end{static_cast<std::uint64_t>(action_kind::end)};

/// A write after which a motor at rest may turn, or a turning one may turn differently.
[[nodiscard]] constexpr action to_enable(std::uint16_t address, std::uint16_t word) noexcept
{
    return detail::to_write(address, word, detail::effect::enabling);
}
/// The same for a drive in fault.
[[nodiscard]] constexpr action to_reset(std::uint16_t address, std::uint16_t word) noexcept
{
    return detail::to_write(address, word, detail::effect::resetting);
}
/// A write after which another source may command the motor, or words have another meaning.
[[nodiscard]] constexpr action to_rearrange(std::uint16_t address, std::uint16_t word) noexcept
{
    return detail::to_write(address, word, detail::effect::rearranging);
}
/// A control word that takes the motor's power or its speed away.
[[nodiscard]] constexpr action to_stop(std::uint16_t address, std::uint16_t word) noexcept
{
    return detail::to_write(address, word, detail::effect::stopping);
}
/// The same action, sent once: where no response comes, the procedure gets the failure.
[[nodiscard]] constexpr action once(action what) noexcept { return detail::with(what, 1, 3); }
/// The same read, which fails if it cannot be sent for so long.
[[nodiscard]] constexpr action within(action read, duration length) noexcept
{
    return detail::with(read, length.microseconds, 32);
}
/// The same write, which fails if it cannot be sent before its drive may have lost its power unnoticed.
[[nodiscard]] constexpr action in_presence(action write) noexcept { return detail::with(write, 1, 7); }

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
