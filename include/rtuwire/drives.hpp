// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: what is done with an Altivar drive. Its registers are in altivar/atv320.hpp and the like; the client
// that carries it out is in client.hpp. docs/names.md lists what is public.
#pragma once

// What refuses a device that is no drive stands directly below this header: see altivar/atv12.hpp.
#include <rtuwire/altivar/device/drive_type.hpp>

#include <rtuwire/altivar/all_drives.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/device/family.hpp>
#include <rtuwire/altivar/device/reference.hpp>
#include <rtuwire/altivar/procedure/commissioning/broadcast_setting.hpp>
#include <rtuwire/altivar/procedure/commissioning/channel.hpp>
#include <rtuwire/altivar/procedure/commissioning/configure_scanner.hpp>
#include <rtuwire/altivar/procedure/commissioning/recall_from_eeprom.hpp>
#include <rtuwire/altivar/procedure/commissioning/release_link.hpp>
#include <rtuwire/altivar/procedure/commissioning/restore_factory_settings.hpp>
#include <rtuwire/altivar/procedure/commissioning/save_to_eeprom.hpp>
#include <rtuwire/altivar/procedure/inspection/identify.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision.hpp>
#include <rtuwire/altivar/procedure/inspection/watch.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_freewheel.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/reset_fault.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/altivar/procedure/outcome.hpp>
#include <rtuwire/cia402/command.hpp>
#include <rtuwire/cia402/state.hpp>
#include <rtuwire/cia402/transition.hpp>
#include <rtuwire/wire/errc_name.hpp>
