// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The fields of a frame, one after the other: where, how long, which and what they say.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rtuwire/frames.hpp>

#include "frame/register_names.hpp"

namespace tool {

/// One field, for a printer.
struct frame_field {
    std::size_t offset; ///< from the start of the frame
    std::size_t length; ///< in bytes
    std::string name;
    std::string value; ///< for people
    /// Of a register or bit that has a name: that, its value for programs, and the unit of that.
    std::string label{};
    cell holds{};
    std::string measure{};

    /// The rest follows from these.
    friend bool operator==(frame_field const& left, frame_field const& right)
    {
        return left.offset == right.offset and left.length == right.length and left.name == right.name and
               left.value == right.value;
    }
};

/// What the request asked for that a response answers.
struct asked_run {
    unsigned first;
    unsigned count; ///< registers, or bits
};

/// Reads the fields of a PDU. Where the bytes end early, the rest is left out and `is_short()`.
class field_reader {
public:
    /// Names: null where none are known.
    field_reader(rtuwire::byte_view pdu, register_names const* names) : pdu_{pdu}, names_{names} {}

    /// A number of 1 or 2 bytes, as it is; 0 where it is missing.
    unsigned number(std::size_t length, std::string_view name);
    /// One with a text of its own.
    unsigned number(std::size_t length, std::string_view name, std::string (*text_of)(unsigned));

    /// An address, with what is called so.
    unsigned address(std::string_view name, register_space space);
    /// So many registers. Without a first address they are counted from 1.
    void registers(std::size_t count, std::optional<unsigned> first, register_space space);
    /// So many bits in so many bytes, the lowest first; `one` is "coil" or "output". Behind each byte its bits that have
    /// names.
    void bits(std::size_t bytes, std::size_t count, std::optional<unsigned> first, std::string_view one,
              register_space space);
    /// The last two bytes as a coil that is on or off, where it has a name.
    void named_coil(unsigned address, bool is_on);
    /// Bytes that are not looked into, in rows.
    void raw(std::size_t length, std::string_view name);
    /// Characters, as they are where they are printable.
    void text(std::size_t length, std::string const& name);

    std::size_t left() const { return pdu_.size() - at_; }
    bool is_short() const { return is_short_; }
    /// How many bytes the fields so far have, with the first that is missing.
    std::size_t size() const { return size_; }
    std::vector<frame_field> take_fields() { return std::move(fields_); }

private:
    std::optional<unsigned> take(std::size_t length);
    bool has(std::size_t length);
    void add(std::size_t length, std::string name, std::string value);
    void add(std::size_t length, std::string const& where, passed_value const& what);
    /// Of the bits in the last bytes those that have names.
    void add_named_bits(std::size_t bytes, unsigned first, std::span<std::uint16_t const> values, std::string_view one,
                        register_space space);

    rtuwire::byte_view pdu_;
    register_names const* names_;
    std::size_t at_{0};
    std::size_t size_{0};
    bool is_short_{false};
    std::vector<frame_field> fields_{};
};

} // namespace tool
