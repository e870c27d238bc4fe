// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive as a list of registers: words, limits, refusals. It knows nothing of the library's tables; what it holds and
// what came to it can be looked at.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include <rtuwire/server/identification.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/wire/views.hpp>

namespace rtuwire::test {

/// A register on paper.
struct paper_register {
    std::uint16_t word{0};
    std::uint16_t lowest{0};
    std::uint16_t highest{0xFFFF};
    errc refuses_read{errc::none};
    errc refuses_write{errc::none};
};

/// The registers of a drive, by their addresses. A power cycle brings back what was saved.
class paper_drive {
public:
    static constexpr std::uint16_t status = 3201, speed = 3202, command = 8501, extended_command = 8504;
    static constexpr std::uint16_t tfr = 3103, hsp = 3104, lsp = 3105;

    std::map<std::uint16_t, paper_register> registers;
    std::vector<std::pair<std::uint16_t, std::uint16_t>> writes; ///< each that was executed, but those to CMD and CMI
    std::vector<std::pair<std::uint16_t, std::size_t>> reads;
    std::vector<std::uint16_t> commands;
    unsigned saves{0};
    errc refuses_all{errc::none};
    bool is_lenient{false}; ///< takes TFR, HSP and LSP in any order
    /// Called before each request is executed, with the number of those before it.
    std::function<void(unsigned)> before;
    /// Called after each write.
    std::function<void(std::uint16_t, std::uint16_t)> after_write;

    [[nodiscard]] std::uint16_t word(std::uint16_t address) const { return registers.at(address).word; }
    void set(std::uint16_t address, std::uint16_t word) { registers[address].word = word; }

    /// Its motor runs, or stands without a command.
    void run() { set(status, 0x0237), set(speed, 400); }
    void stand() { set(status, 0x0250), set(speed, 0), set(command, 0); }

    void cycle_power()
    {
        for (auto const& [address, word] : saved_) {
            registers[address].word = word;
        }
        stand();
    }

    /// What a power cycle brings back from now on.
    void save()
    {
        saved_.clear();
        for (auto const& [address, one] : registers) {
            saved_[address] = one.word;
        }
    }

    [[nodiscard]] unsigned requests() const { return requests_; }

    [[nodiscard]] errc check_read(std::uint16_t start, std::size_t count) const
    {
        note_request();
        if (refuses_all != errc::none) {
            return refuses_all;
        }
        for (std::size_t i = 0; i < count; ++i) {
            auto const found = registers.find(static_cast<std::uint16_t>(start + i));
            if (found == registers.end()) {
                return errc::illegal_data_address;
            }
            if (found->second.refuses_read != errc::none) {
                return found->second.refuses_read;
            }
        }
        return errc::none;
    }

    [[nodiscard]] errc check_write(std::uint16_t start, register_view values) const
    {
        note_request();
        if (refuses_all != errc::none) {
            return refuses_all;
        }
        auto const found = registers.find(start);
        if (found == registers.end() or values.size() != 1) {
            return errc::illegal_data_address;
        }
        if (found->second.refuses_write != errc::none) {
            return found->second.refuses_write;
        }
        bool const fits = values[0] >= found->second.lowest and values[0] <= found->second.highest;
        return fits and keeps_order(start, values[0]) ? errc::none : errc::illegal_data_value;
    }

    errc read(std::uint16_t start, std::size_t count, byte_writer& out)
    {
        reads.emplace_back(start, count);
        for (std::size_t i = 0; i < count; ++i) {
            out.u16(word(static_cast<std::uint16_t>(start + i)));
        }
        return errc::none;
    }

    errc write(std::uint16_t start, register_view values)
    {
        set(start, values[0]);
        if (start == command) {
            commands.push_back(values[0]);
        } else if (start == extended_command) {
            saves += (values[0] & 2U) != 0 ? 1U : 0U;
            if ((values[0] & 2U) != 0) {
                save();
            }
        } else {
            writes.emplace_back(start, values[0]);
        }
        if (after_write) {
            after_write(start, values[0]);
        }
        return errc::none;
    }

private:
    void note_request() const
    {
        unsigned const number = requests_++;
        if (before) {
            before(number);
        }
    }

    /// LSP <= HSP <= TFR, where it has all three.
    [[nodiscard]] bool keeps_order(std::uint16_t address, std::uint16_t next) const
    {
        if (is_lenient or registers.count(tfr) == 0 or registers.count(hsp) == 0 or registers.count(lsp) == 0) {
            return true;
        }
        auto const held = [&](std::uint16_t which) { return which == address ? next : word(which); };
        return held(lsp) <= held(hsp) and held(hsp) <= held(tfr);
    }

    std::map<std::uint16_t, std::uint16_t> saved_;
    mutable unsigned requests_{0};
};

/// How it names itself.
template <std::size_t Number> struct paper_identity;
template <> struct paper_identity<320> {
    static constexpr std::array<device_object, 3> objects{
        {{0, "Schneider Electric"}, {1, "ATV320U11N4B"}, {2, "0201"}}};
    static constexpr server_profile profile{.limits = {63, 61, 4, 4}, .identity = identity_of<objects>};
};
template <> struct paper_identity<12> {
    static constexpr std::array<device_object, 3> objects{{{0, "Schneider Electric"}, {1, "ATV12H018M2"}, {2, "0201"}}};
    static constexpr server_profile profile{.limits = {63, 61, 4, 4}, .identity = identity_of<objects>};
};
/// One without function 43/14.
template <> struct paper_identity<0> {
    static constexpr server_profile profile{.limits = {63, 61, 4, 4}};
};

} // namespace rtuwire::test
