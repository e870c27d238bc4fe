// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Where the tool is built without yaml-cpp.
#include "exit_status.hpp"
#include "files/text_place.hpp"
#include "import/source_value.hpp"

namespace tool {

source_value yaml_source(std::string const& file, std::string const&)
{
    refuse_word(file + ": this program imports no YAML, such as that of ESPHome and Home Assistant: only JSON "
                       "(wb-mqtt-serial, SunSpec) and TOML (inputs.modbus of Telegraf). The one for Linux imports it, "
                       "and its register file is for both");
}

} // namespace tool
