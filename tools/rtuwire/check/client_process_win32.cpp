// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Of the tool's commands this alone starts programs of others, and ends all that they start.
#include "check/client_process.hpp"

#include "exit_status.hpp"

namespace tool {

client_process::client_process(std::vector<std::string> const&)
{
    refuse_word("check --client: Windows: this program starts no client there; start it yourself, and leave out its "
                "words here");
}

client_process::~client_process() = default;

bool client_process::look() { return false; }

std::string client_process::last_complaint() const { return {}; }

std::string client_process::end() const { return {}; }

} // namespace tool
