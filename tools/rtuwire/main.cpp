// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// rtuwire: what a person does with a line of Modbus RTU, from a terminal. docs/tool.md is its page.
#include <exception>
#include <string>

#include "../support/platform.hpp"
#include "../support/signals.hpp"
#include "command_line.hpp"
#include "commands/commands.hpp"
#include "output/passing_text.hpp"
#include "output/plain_text.hpp"

namespace {

using namespace tool;

/// Behind the last frame, however the command ends.
struct last_note {
    ~last_note() { tell_dropped(); }
};

exit_status run(choices const& chosen)
{
    last_note const at_the_end;
    command const* const wanted = command_named(chosen.command);
    if (wanted == nullptr) {
        refuse_word("'" + chosen.command + "' is no command");
    }
    return wanted->run(chosen);
}

} // namespace

int main(int argc, char** argv)
{
    keep_standard_descriptors();
    ignore_failed_writes();
    try {
        parsed const words = parse(argc, argv);
        return static_cast<int>(words.chosen ? run(*words.chosen) : words.status);
    } catch (ended const& why) {
        tell_error(why.what());
        return static_cast<int>(why.status);
    } catch (std::exception const& why) {
        tell_error(why.what());
        return static_cast<int>(exit_status::port);
    }
}
