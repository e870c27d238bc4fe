// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Frames that were explained, in the forms in which a person and a program want them: a row a field.
#pragma once

#include <cstdint>
#include <string>

#include "frame/decode.hpp"
#include "output/output.hpp"

namespace tool {

/// A table for people leaves out what is as in the row above.
class frame_printer {
public:
    explicit frame_printer(output_form form) : is_table_{form == output_form::table}, results_{form, false} {}

    /// From here on a reader that went away ends the command, too.
    void need_reader() { results_.need_reader(); }

    /// Where `whole` has a name, the first row is of all bytes.
    void put(decoded_frame const& frame, std::string const& whole = {}, std::string const& value = {});
    /// Shows what has waited: a run of frames in columns as wide as they need.
    void finish_run() { results_.finish(); }

    bool is_open() const { return results_.is_open(); }

private:
    void put(decoded_frame const& frame, frame_reading const& reading, frame_field const& each);

    bool is_table_;
    output results_;
    std::int64_t number_{0};
    bool is_first_{true};
};

} // namespace tool
