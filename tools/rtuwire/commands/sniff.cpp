// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Shows what others say on the line, a line a frame.
#include "commands/commands.hpp"
#include "frame/frame_record.hpp"
#include "line/end_wish.hpp"
#include "line/tap.hpp"

namespace tool {

exit_status run_sniff(choices const& chosen)
{
    note_signals();
    frame_records show{chosen};
    any_port port = open_to_listen(chosen);
    listen(
        port, chosen.last, [&show](tapped_frame const& it) { show.put(it); }, [&show] { return show.is_open(); });
    return show.finish();
}

} // namespace tool
