// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A simulated drive of any type, and the orders of the library for it. Everything that depends on the type is behind
// this class, so that the rest is compiled once and not for each type.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <ratio>

#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>
#include <rtuwire/sim.hpp>

#include "catalog/catalog.hpp"

namespace playground {

inline constexpr rtuwire::unit_id unit{1};
inline constexpr rtuwire::line_timing line_speed{19'200, rtuwire::character_format::even_8_1};

inline constexpr rtuwire::client_needs<> needed{.timing = line_speed,
                                                .options = {.response_timeout = rtuwire::milliseconds(200),
                                                            .late_response = rtuwire::milliseconds(100),
                                                            .retries = 1}};
using link = rtuwire::bus<6, needed>;

/// A frequency as a person gives it, so fine that the register tells what lies between its own steps.
using given_frequency = rtuwire::quantity<rtuwire::frequency, std::int64_t, std::micro>;

/// What a client knows of a drive that it watches.
struct client_sight {
    bool is_linked;
    std::uint32_t rounds;
    rtuwire::errc error;
    rtuwire::cia402::state state;
    std::int16_t frequency; ///< 0.1 Hz, below zero in reverse
};

class any_drive {
public:
    any_drive() = default;
    any_drive(any_drive const&) = delete;
    any_drive& operator=(any_drive const&) = delete;
    virtual ~any_drive() = default;

    [[nodiscard]] virtual tool::drive_catalog const& catalog() const noexcept = 0;

    // As an end of a line.
    virtual void receive(rtuwire::byte_view bytes, rtuwire::instant now) noexcept = 0;
    virtual void receive_error(rtuwire::instant now) noexcept = 0;
    virtual void sent(rtuwire::instant now) noexcept = 0;
    virtual void advance(rtuwire::instant now) noexcept = 0;
    [[nodiscard]] virtual rtuwire::byte_view poll_transmit() noexcept = 0;
    [[nodiscard]] virtual rtuwire::deadline poll_deadline() const noexcept = 0;
    [[nodiscard]] virtual std::uint32_t requests() const noexcept = 0;

    // At the drive.
    virtual void power_cycle(rtuwire::instant now) noexcept = 0;
    virtual void inject_fault(std::uint16_t code) noexcept = 0;
    virtual void clear_cause() noexcept = 0;
    virtual void set_local(bool is_local) noexcept = 0;
    virtual void press_stop() noexcept = 0;
    virtual void write(std::uint16_t address, std::uint16_t word) noexcept = 0;
    [[nodiscard]] virtual std::uint16_t word(rtuwire::literal code) const noexcept = 0;
    [[nodiscard]] virtual rtuwire::cia402::state state() const noexcept = 0;
    [[nodiscard]] virtual rtuwire::cia402::transition last_transition() const noexcept = 0;
    [[nodiscard]] virtual std::int32_t frequency() const noexcept = 0; ///< mHz
    [[nodiscard]] virtual std::uint16_t fault() const noexcept = 0;

    // At its client.
    virtual void watch(link& line, std::size_t slot, rtuwire::instant now) noexcept = 0;
    [[nodiscard]] virtual client_sight sight() const noexcept = 0;
    /// Make an order; those with a reference tell why it is none for this drive.
    virtual rtuwire::errc make(std::optional<rtuwire::altivar::start>& order, given_frequency reference) const = 0;
    virtual rtuwire::errc make(std::optional<rtuwire::altivar::change_reference>& order,
                               given_frequency reference) const = 0;
    virtual void make(std::optional<rtuwire::altivar::stop>& order, rtuwire::altivar::stop_by how) const = 0;
    virtual void make(std::optional<rtuwire::altivar::reset_fault>& order) const = 0;
};

/// A drive by its place in `altivar::all_drives`, switched off; null behind the last.
[[nodiscard]] std::unique_ptr<any_drive> make_drive(std::size_t place);

} // namespace playground
