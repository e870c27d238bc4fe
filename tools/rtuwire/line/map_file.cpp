// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/map_file.hpp"

#include <utility>

#include "device/register_file.hpp"
#include "device/register_file_writer.hpp"
#include "exit_status.hpp"
#include "files/whole_file.hpp"

namespace tool {

written_map write_map(std::string const& file, std::vector<address_range> const& found)
{
    register_file_writer writer{file, std::nullopt};
    writer.add_comment("Found by rtuwire map. Names, types, orders of words and units of measure are to be written.");
    written_map written;
    for (address_range const& each : found) {
        for (unsigned at = each.first; at <= each.last; ++at) {
            if (writer.registers() == most_registers) {
                written.beyond += each.last - at + 1;
                break;
            }
            written_register one;
            one.space = name_of(each.space);
            one.address = at;
            one.name = one.space + '_' + std::to_string(at);
            one.type = each.space < register_space::coil ? "hex" : "";
            writer.add(std::move(one));
        }
    }
    written.registers = writer.registers();
    if (written.registers > 0) {
        if (std::string const why = write_new_file(file, writer.text()); not why.empty()) {
            throw ended{exit_status::port, file + ": " + why};
        }
    }
    return written;
}

} // namespace tool
