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

class map_log {
public:
    /// Reads what the file has of this unit; without a file's name nothing is kept. Refuses a file that is something else, or
    /// damaged, with the line, and leaves it as it is.
    map_log(std::string const& file, unsigned unit);

    [[nodiscard]] found_address at(register_space space, unsigned address) const;
    /// Addresses that were asked together, or one behind the other.
    void note(register_space space, unsigned first, unsigned last, found_address const& found);

private:
    void read(std::string const& text);
    [[nodiscard]] bool read_line(std::string const& line);
    void keep(register_space space, unsigned first, unsigned last, found_address const& found);
    void write(std::string const& line);

    static constexpr std::size_t spaces = 4;

    std::string file_;
    unsigned unit_;
    std::array<std::vector<std::uint16_t>, spaces> found_{}; ///< for each address which of `kinds_`
    std::vector<found_address> kinds_{{}};
    appended_file out_{};
};

} // namespace tool
