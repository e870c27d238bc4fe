// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The keys in the bytes that a terminal sends: letters, and sequences of an arrow. All else is none, a sequence as a whole.
#pragma once

#include "monitor/keys.hpp"

namespace tool {

class typed_keys {
public:
    /// The key that ends with this byte; `none` for most.
    key push(char byte);
    /// Whether more bytes belong to what has begun; the key Esc begins, and nothing follows.
    bool is_within() const { return within_ != part::nothing; }
    void give_up() { within_ = part::nothing; }

private:
    enum class part { nothing, escape, sequence, parameters, text };

    key push_sequence(char byte);

    part within_{part::nothing};
};

} // namespace tool
