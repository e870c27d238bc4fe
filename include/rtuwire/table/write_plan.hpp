// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Any settings of a device, written with the fewest requests that it allows: neighbours go into one request,
// and only registers that were named are written. A register of several words is written by one request. Apart from
// table/read_plan.hpp, because most programs only read, and the settings of wide registers belong to writing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/form/form_setting.hpp>
#include <rtuwire/table/read_plan.hpp>
#include <rtuwire/table/setting.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// The requests that write `Registers` of `Device`, and the words of their settings.
template <device_type Device, auto const&... Registers> class write_plan {
    static_assert(sizeof...(Registers) > 0, "a plan writes at least one register");
    static_assert((has_register<Device, Registers> and ...), "a plan writes registers of one device only");
    static_assert((has_own_steps<Registers> and ...),
                  "another register sets this register's steps: name them with restepped");
    static_assert(((Registers.space == register_space::holding) and ...), "a plan writes holding registers");
    static_assert(((Registers.mode != access::read_only) and ...), "this register is read-only");
    static_assert(first_duplicate(std::array{Registers.address...}).second == 0, "a plan writes each register once");

    static constexpr auto keys = rising_words<Registers...>();
    static constexpr std::size_t word_count = keys.count;
    static constexpr auto addresses = [] {
        std::array<std::uint16_t, word_count> all{};
        for (std::size_t i = 0; i < word_count; ++i) {
            all[i] = static_cast<std::uint16_t>(keys.keys[i] & 0xFFFFU);
        }
        return all;
    }();
    static constexpr auto is_joined = [](std::size_t index) {
        auto const cuts = [](std::uint16_t first, std::uint16_t words, std::uint16_t address) {
            return address > first and address < std::uint32_t{first} + words;
        };
        return (cuts(Registers.address, Registers.word_count, addresses[index]) or ...);
    };
    static constexpr auto plan = plan_blocks<word_count>(
        addresses, Device::limits.write, [](std::uint16_t lower, std::uint16_t upper) { return upper - lower == 1; },
        is_joined);
    static_assert(plan.count > 0, "this register has more words than this device takes in one write");

public:
    using device = Device;
    static constexpr std::size_t register_count = word_count; ///< wide ones with all their words
    static constexpr std::size_t request_count = plan.count;

    explicit constexpr write_plan(setting<Registers>... values) noexcept
    {
        (put(Registers.address, setting_words<Registers>(values)), ...);
    }

    /// Of values of which some are known only at run time: each is `checked(...)`. Where one does not fit, nothing is
    /// written, and the outcome says why.
    explicit constexpr write_plan(result<setting<Registers>>... values) noexcept requires(sizeof...(Registers) > 0)
    {
        ((error_ = error_ == errc::none ? values.error() : error_), ...);
        if (error_ == errc::none) {
            (put(Registers.address, setting_words<Registers>(*values)), ...);
        }
    }

    /// Why nothing of it is written; `none` where all values fit.
    [[nodiscard]] constexpr errc error() const noexcept { return error_; }

    /// The requests, in the order of their addresses.
    static constexpr std::span<address_block const> requests() noexcept { return plan.view(); }

    /// The words of one request, in address order.
    [[nodiscard]] constexpr std::span<std::uint16_t const> words(std::size_t request) const noexcept
    {
        std::size_t first = 0;
        while (addresses[first] != plan.blocks[request].start) {
            ++first;
        }
        return std::span{words_}.subspan(first, plan.blocks[request].count);
    }

private:
    template <typename Words> constexpr void put(std::uint16_t address, Words const& words) noexcept
    {
        for (std::size_t i = 0; i < addresses.size(); ++i) {
            if (addresses[i] >= address and std::uint32_t{addresses[i]} - address < words.size()) {
                words_[i] = words[std::uint32_t{addresses[i]} - address];
            }
        }
    }

    std::array<std::uint16_t, word_count> words_{};
    errc error_{errc::none};
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
