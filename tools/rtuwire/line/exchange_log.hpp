// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the program itself says on a line and hears there: each frame on the standard error (-v), in a file for Wireshark
// (--trace), and as what its units owe.
#pragma once

#include <rtuwire/trace.hpp>

#include "choices.hpp"
#include "line/owed_answers.hpp"
#include "port/any_port.hpp"

namespace tool {

struct line_setting;

/// How far the words that were written to single registers have come.
enum class written_word { unsent, sent, confirmed };

class exchange_log {
public:
    /// Before the line is opened: makes the file, which must not be there yet, so that nothing is lost and no pipe is
    /// waited for. Ends where that cannot be; where the frames come first (`is_trace_optional`), it is told, and left.
    static void open_file(line_choices const& chosen);

    /// As the choices say, of a port that outlives it. All lines of a run have one file, which begins with the first of them.
    static exchange_log of(line_choices const& chosen, line_setting const& how, any_port const& port);

    /// What the units owe by all that passed.
    owed_answers& owed() { return owed_; }
    owed_answers const& owed() const { return owed_; }

    /// How far any of them came that has passed.
    written_word written() const { return written_; }

    /// How many requests have left, repetitions counted.
    unsigned long sent() const { return sent_; }

    /// A frame has passed. A file that can take no more is told of once, and left.
    void take(rtuwire::traced_frame const& frame) noexcept;

private:
    owed_answers owed_{};
    written_word written_{written_word::unsent};
    unsigned long sent_{0};
    any_port const* port_{nullptr};
    any_port const* shown_{nullptr}; ///< whose frames are shown, where they are
};

} // namespace tool
