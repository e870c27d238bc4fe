#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Puts "Modbus RTU line" among Wireshark's interfaces: copied to its folder of extcap programs, it listens with `rtuwire capture`.

Wireshark asks what there is (--extcap-interfaces, --extcap-dlts, --extcap-config), and then for a capture (--capture --fifo).
The program `rtuwire` is found in PATH, or where the variable RTUWIRE says.
"""
import argparse
import glob
import os
import shutil
import signal
import subprocess
import sys

INTERFACE = "rtuwire"
LINK_TYPE = 228  # the UDP form; the file itself says it, too
RATES = (1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200)
FORMATS = ("8E1", "8O1", "8N1", "8N2", "8E2", "8O2")


def capture_command(program, port, baud, form, fifo):
    """The one place that knows how the tool is called."""
    return [program, "--port", port, "--baud", str(baud), "--format", form, "capture", "-o", fifo]


def ports():
    """What may be a serial line, by its lasting name first."""
    named = sorted(glob.glob("/dev/serial/by-id/*"))
    taken = {os.path.realpath(path) for path in named}
    return named + [path for pattern in ("/dev/ttyUSB*", "/dev/ttyACM*", "/dev/ttyAMA*", "/dev/cu.usb*")
                    for path in sorted(glob.glob(pattern)) if path not in taken]


def print_interfaces():
    print("extcap {version=1.0}{display=rtuwire}")
    print(f"interface {{value={INTERFACE}}}{{display=Modbus RTU line}}")


def print_link_types():
    print(f"dlt {{number={LINK_TYPE}}}{{name=IPV4}}{{display=Modbus RTU as UDP}}")


def print_settings():
    # A list would leave out tcp://host:4001, and Wireshark 4.0 knows no list that takes other words.
    found = ports()
    print("arg {number=0}{call=--port}{display=Port}{type=string}{required=true}"
          + (f"{{default={found[0]}}}" if found else "")
          + f"{{tooltip=A serial device, or tcp://host:4001. Devices now: {', '.join(found) or 'none'}}}")
    print("arg {number=1}{call=--baud}{display=Bit rate}{type=selector}")
    print("arg {number=2}{call=--format}{display=Format}{type=selector}")
    for number, choices, usual in ((1, RATES, 19200), (2, FORMATS, "8E1")):
        for each in choices:
            default = "true" if each == usual else "false"
            print(f"value {{arg={number}}}{{value={each}}}{{display={each}}}{{default={default}}}")


def capture(options):
    """Runs the tool until it ends, or until Wireshark stops this script."""
    if not options.port or not options.fifo:
        print("no port chosen: see the settings of the interface", file=sys.stderr)
        return 2
    program = os.environ.get("RTUWIRE") or shutil.which("rtuwire")
    if not program:
        print("the program rtuwire is not in PATH, and the variable RTUWIRE does not say where it is", file=sys.stderr)
        return 4
    command = capture_command(program, options.port, options.baud, options.format, options.fifo)
    child = None

    def stop(*_):
        if child and child.poll() is None:
            child.terminate()

    for each in (signal.SIGTERM, signal.SIGINT):
        signal.signal(each, stop)
    child = subprocess.Popen(command, stdin=subprocess.DEVNULL)
    status = child.wait()
    silent_line = 3  # nothing passed: no fault of this interface
    return 0 if status in (-signal.SIGTERM, silent_line) else status if status >= 0 else 1


def parse():
    parser = argparse.ArgumentParser(description="A line of Modbus RTU as an interface of Wireshark")
    for action in ("--extcap-interfaces", "--extcap-dlts", "--extcap-config", "--capture"):
        parser.add_argument(action, action="store_true")
    for word in ("--extcap-version", "--extcap-interface", "--extcap-capture-filter", "--fifo", "--port"):
        parser.add_argument(word, nargs="?" if word.endswith(("version", "filter")) else None)
    parser.add_argument("--baud", type=int, choices=RATES, default=19200)
    parser.add_argument("--format", choices=FORMATS, default="8E1")
    return parser.parse_known_args()[0]


def main():
    options = parse()
    if options.extcap_interfaces:
        print_interfaces()
    elif options.extcap_dlts:
        print_link_types()
    elif options.extcap_config:
        print_settings()
    elif options.capture:
        return capture(options)
    else:
        print(__doc__)
    return 0


if __name__ == "__main__":
    sys.exit(main())
