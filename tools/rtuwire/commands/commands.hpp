// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the tool can do: a function a command, each in a file of its own. They throw `ended` where they end early.
#pragma once

#include "choices.hpp"
#include "exit_status.hpp"

namespace tool {

exit_status run_scan(choices const& chosen);
exit_status run_identify(choices const& chosen);
exit_status run_map(choices const& chosen);
exit_status run_ask(choices const& chosen);
exit_status run_read(choices const& chosen);
exit_status run_watch(choices const& chosen);
exit_status run_monitor(choices const& chosen);
exit_status run_list(choices const& chosen);
exit_status run_explain(choices const& chosen);
exit_status run_faults(choices const& chosen);
exit_status run_backup(choices const& chosen);
exit_status run_compare(choices const& chosen);
exit_status run_restore(choices const& chosen);
exit_status run_write(choices const& chosen);
exit_status run_decode(choices const& chosen);
exit_status run_simulate(choices const& chosen);
exit_status run_start(choices const& chosen);
exit_status run_stop(choices const& chosen);
exit_status run_reset(choices const& chosen);
exit_status run_sniff(choices const& chosen);
exit_status run_capture(choices const& chosen);
exit_status run_replay(choices const& chosen);
exit_status run_timing(choices const& chosen);
exit_status run_ports(choices const& chosen);
exit_status run_device(choices const& chosen);

} // namespace tool
