// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Where the tool is built without yaml-cpp.
#include "exit_status.hpp"
#include "files/text_place.hpp"
#include "import/source_value.hpp"

namespace tool {

source_value yaml_source(std::string const& file, std::string const&)
{
    refuse_word(file +
                ": neither JSON nor TOML, and YAML (ESPHome, Home Assistant) is not in this build; the one for Linux "
                "imports it, and its register file is for both");
}

} // namespace tool
