// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Frames that passed, as results: when, who, what it was, and what it says.
#pragma once

#include "choices.hpp"
#include "exit_status.hpp"
#include "frame/known_units.hpp"
#include "line/tap.hpp"
#include "output/output.hpp"

namespace tool {

class frame_records {
public:
    explicit frame_records(choices const& chosen);

    void put(tapped_frame const& it);
    bool is_open() const { return results_.is_open(); }

    /// `no_answer` where nothing passed.
    exit_status finish();

private:
    record record_of(tapped_frame const& it) const;

    known_units units_;
    bool is_table_;
    output results_;
    bool has_any_{false};
};

} // namespace tool
