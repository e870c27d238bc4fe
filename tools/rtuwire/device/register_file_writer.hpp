// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Writes register files, of registers that another program's file or a drive's table describes. What cannot be said there is
// lost, and told with its place.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/text_place.hpp"
#include "words/named_places.hpp"

namespace tool {

/// One register, in the words of a register file.
struct written_register {
    text_place place{};
    std::string name{};
    std::string space{"holding"};
    std::int64_t address{0};
    std::string bits{};
    std::string type{};
    std::string order{};
    std::string unit{};
    double scale{1};
    double offset{0};
    bool is_writable{false};
    bool is_setting{false};
    bool is_stored{false};
    bool moves{false};
    std::optional<double> lowest{};
    std::optional<double> highest{};
    std::vector<std::pair<std::string, std::int64_t>> choices{};
    std::vector<std::uint64_t> invalid{};
    std::string comment{};       ///< what stands above it, instead of the name where that became another
    std::string not_the_value{}; ///< why its registers are not what its name says: by a formula of the other program
    std::optional<std::int64_t> unit_id{}; ///< whose it is, where the file says so
    std::string line{};                    ///< by which of the file's lines that unit is reached, where it says so
};

class register_file_writer {
public:
    /// `unit`: whose registers are meant, where the file has several.
    register_file_writer(std::string file, std::optional<std::int64_t> unit) : file_{std::move(file)}, wanted_{unit} {}

    /// What could not be carried over.
    void lose(text_place place, std::string const& what);
    /// What was, and otherwise than in the file.
    void note(text_place place, std::string const& what);
    void add(written_register one);
    void add_comment(std::string_view text);
    void limit_requests(text_place place, std::int64_t registers);
    void pause(text_place place, double milliseconds);

    [[nodiscard]] std::string const& file() const noexcept { return file_; }
    [[nodiscard]] std::vector<std::string> const& told() const noexcept { return told_; }
    [[nodiscard]] std::size_t lost() const noexcept { return lost_; }
    [[nodiscard]] std::size_t registers() const noexcept { return known_.places.size(); }
    /// The register file.
    [[nodiscard]] std::string text() const;

private:
    std::string name_of(written_register& one);
    std::string own_name(std::string name, text_place place);
    void mend_unit(written_register& one);
    void mend_choices(written_register& one);
    void check_scale(written_register& one) const;
    bool is_of_unit(written_register const& one);
    std::string drop_what_is_wrong(written_register& one, std::string const& name);
    std::string device_part() const;

    std::string file_;
    std::optional<std::int64_t> wanted_;
    std::string line_{}; ///< that of the first register of the unit
    std::vector<std::string> told_{};
    std::size_t lost_{0};
    std::string comments_{};
    std::optional<std::int64_t> max_registers_{};
    std::optional<std::int64_t> pause_{};
    named_places known_{};
    std::map<std::string, unsigned> last_of_name_{}; ///< the last number behind a name that was wished several times
    std::string tables_{};
};

} // namespace tool
