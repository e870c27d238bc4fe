// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which addresses of a unit were asked so far, and what each gave, in a file that survives however the program ends.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "files/regular_file.hpp"
#include "words/place.hpp"

namespace tool {

/// What an address gave.
struct found_address {
    enum class kind : std::uint8_t { unknown, here, none, other } what{kind::unknown};
    std::string why{}; ///< of another: what was answered instead

    friend bool operator==(found_address const&, found_address const&) = default;
};

/// Of what a map is, each as it is told: another device at the address has other rows.
struct map_head {
    std::string line{};   ///< "19200 8E1"
    std::string unit{};   ///< "61"
    std::string device{}; ///< what it says of itself, or why nothing is known
    std::string range{};  ///< "input:0-1999"
};

class map_log {
public:
    /// Reads what the file has; without a file's name nothing is kept. Refuses a file that is something else, or damaged, with
    /// the line, and leaves it as it is.
    map_log(std::string const& file, unsigned unit);

    /// Refuses to go on with the map of something else; the head is kept with the first row.
    void begin(map_head const& head);

    [[nodiscard]] found_address at(register_space space, unsigned address) const;
    /// Addresses that were asked together, or one behind the other.
    void note(register_space space, unsigned first, unsigned last, found_address const& found);

private:
    void read(std::string const& text);
    [[noreturn]] void refuse_no_map() const;
    [[nodiscard]] bool read_line(std::string const& line);
    void keep(register_space space, unsigned first, unsigned last, found_address const& found);
    void write(std::string const& line);

    static constexpr std::size_t spaces = 4;

    std::string file_;
    unsigned unit_;
    std::vector<std::string> kept_head_{}; ///< its lines, as they are in the file; none where it is new
    std::string new_head_{};               ///< to be written
    std::array<std::vector<std::uint16_t>, spaces> found_{}; ///< for each address which of `kinds_`
    std::vector<found_address> kinds_{{}};
    appended_file out_{};
};

} // namespace tool
