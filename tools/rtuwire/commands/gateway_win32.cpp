// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "commands/commands.hpp"

namespace tool {

exit_status run_gateway(choices const&)
{
    refuse_word("gateway: there is none on Windows; it runs on Linux, and reaches a line elsewhere by tcp:// or "
                "mbap://, such as one of serve");
}

} // namespace tool
