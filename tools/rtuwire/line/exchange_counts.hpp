// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How long a unit's responses took, and how many were none.
#pragma once

#include <algorithm>
#include <string>

namespace tool {

struct exchange_counts {
    unsigned long asked{0};
    unsigned long silent{0};  ///< nobody responded in time
    unsigned long refused{0}; ///< exceptions
    unsigned long damaged{0}; ///< all else
    double last{0};           ///< milliseconds from a request to its response
    double longest{0};
    double sum{0};

    unsigned long errors() const { return silent + refused + damaged; }
    unsigned long answered() const { return asked - silent - damaged; }
    double mean() const { return answered() == 0 ? 0 : sum / static_cast<double>(answered()); }

    void note_response(double milliseconds)
    {
        last = milliseconds;
        longest = std::max(longest, milliseconds);
        sum += milliseconds;
    }
};

} // namespace tool
