// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One pass of a board's loop, by the functions of its file: included behind that.
#pragma once

namespace stand_in {

struct loop_of_file {
    template <typename Engine, typename Act> static void pass(Engine& engine, Act act)
    {
        receive(engine);
        act();
        transmit(engine);
        rest();
    }
};

} // namespace stand_in
