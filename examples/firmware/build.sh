#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Builds one program for one board:  sh build.sh BOARD PROGRAM ELF [compiler flags]
#
#   sh examples/firmware/build.sh mps2_an385 controller controller.elf -DRTUWIRE_DRIVE=atv28
set -eu
here=$(CDPATH='' cd "$(dirname "$0")" && pwd)
board=$1
program=$2
elf=$3
shift 3
exec arm-none-eabi-g++ -std=c++20 -Os -mcpu=cortex-m3 -mthumb -fno-exceptions -fno-rtti \
    -fno-threadsafe-statics -fno-use-cxa-atexit -ffunction-sections -fdata-sections \
    -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wno-register -Werror \
    -I"$here/../../include" -I"$here" -DRTUWIRE_BOARD="\"boards/$board.hpp\"" "$@" \
    -nostartfiles --specs=nano.specs --specs=nosys.specs -Wl,--gc-sections \
    -L"$here/boards" -T "$here/boards/$board.ld" \
    -o "$elf" "$here/startup.cpp" "$here/$program.cpp"
