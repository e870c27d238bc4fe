// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Shows a capture as `sniff` showed its line.
#include "commands/commands.hpp"
#include "frame/frame_record.hpp"
#include "line/played_capture.hpp"

namespace tool {

exit_status run_replay(choices const& chosen)
{
    frame_records show{chosen};
    play_capture(capture_in(chosen), setting_in(chosen.line), [&show](tapped_frame const& it) { show.put(it); });
    return show.finish();
}

} // namespace tool
