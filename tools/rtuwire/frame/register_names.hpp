// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the registers and bits of a frame are called, and what their values are: by a drive's table, or a register file.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "catalog/catalog.hpp"
#include "output/record.hpp"
#include "words/place.hpp"

namespace tool {

/// A value that passed; or a register or bit of which nobody knows what it is.
struct passed_value {
    unsigned address;         ///< the first, of those that passed
    std::size_t count{1};     ///< registers, or bits
    std::string name{};       ///< empty where it has none
    std::string text{};       ///< "230.1 V", as `read` has it
    std::string short_text{}; ///< the same, without the names of a word's bits
    cell value{};             ///< for programs, as `read` has it; nothing where it has no name, or no value
    std::string measure{};    ///< "V"
};

/// Of one device.
class register_names {
public:
    register_names() = default;
    register_names(register_names const&) = delete;
    register_names& operator=(register_names const&) = delete;
    virtual ~register_names() = default;

    /// "RFR"; of several that share a register all. Empty where nothing has a name.
    virtual std::string name_at(register_space space, unsigned address) const = 0;
    /// What the first of these words is, or is the first of; several where its bits have names. Empty where it has no name.
    virtual std::vector<passed_value> values_at(register_space space, unsigned address,
                                                std::span<std::uint16_t const> words) const = 0;
};

/// Those of a drive: holding registers of one word. The drive must outlive them.
class names_by_drive final : public register_names {
public:
    explicit names_by_drive(drive_catalog const& drive) : drive_{drive} {}

    std::string name_at(register_space space, unsigned address) const override;
    std::vector<passed_value> values_at(register_space space, unsigned address,
                                        std::span<std::uint16_t const> words) const override;

private:
    register_entry const* entry_at(register_space space, unsigned address) const;

    drive_catalog const& drive_;
};

/// All that these words are, one behind the other; of coils and discrete inputs each is 0 or 1. Null: nothing has a name.
std::vector<passed_value> values_in(register_names const* names, register_space space, unsigned first,
                                    std::span<std::uint16_t const> words);

} // namespace tool
