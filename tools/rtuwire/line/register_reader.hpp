// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Reads any registers of a unit by few requests: neighbours together, as many as its drive allows.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rtuwire/frames.hpp>

#include "catalog/catalog.hpp"
#include "line/open_line.hpp"
#include "words/register_words.hpp"
#include "words/value_words.hpp"

namespace tool {

class register_reader {
public:
    /// With the registers that set the steps of those that were chosen. Without a drive (null) up to 125 at once.
    register_reader(std::vector<chosen_register> const& chosen, drive_catalog const* drive);

    /// One round. What a unit refuses together is read in parts. Ends where the port fails.
    void read(open_line& line, rtuwire::unit_id unit);

    /// What the last round read at an address, or why not.
    rtuwire::result<std::uint16_t> at(std::uint16_t address) const;
    /// The same by mnemonic, as values and limits want it.
    known_words known() const;

    /// Why it could not be read, in words; of one that could, nothing.
    std::string why_not(std::uint16_t address) const;

    /// Why the last round lacks something; none where it is whole.
    rtuwire::errc first_error() const { return first_error_; }
    /// The same in words.
    std::string const& first_failure() const { return first_failure_; }

private:
    struct block {
        std::uint16_t start;
        std::uint16_t count;
    };

    void group(std::set<std::uint16_t> const& addresses);
    /// Whether a request over both addresses meets only registers that the drive has.
    bool may_reach(std::uint16_t from, std::uint16_t to) const;
    rtuwire::errc read(open_line& line, rtuwire::unit_id unit, block const& which);
    rtuwire::errc read_parts(open_line& line, rtuwire::unit_id unit, block const& which);

    drive_catalog const* drive_;
    unsigned limit_;
    std::vector<block> blocks_{};
    std::map<std::uint16_t, rtuwire::result<std::uint16_t>> words_{};
    std::map<std::uint16_t, std::string> failures_{}; ///< of those that could not be read
    rtuwire::errc first_error_{};
    std::string first_failure_{};
};

} // namespace tool
