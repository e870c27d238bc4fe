// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Reads a value that is not there. With another file, which is linked before or behind this one and has the program's hook.
#include <rtuwire/core/result.hpp>
#include <rtuwire/wire/errc.hpp>

namespace {

rtuwire::result<int> half(int number)
{
    return number < 2 ? rtuwire::result<int>{rtuwire::errc::timed_out} : number / 2;
}

} // namespace

int main(int argc, char**) { return *half(argc); }
