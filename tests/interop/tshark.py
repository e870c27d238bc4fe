# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Lets tshark read the captures of our frames: python3 tshark.py WRITE_CAPTURES"""
import re
import subprocess
import sys
import tempfile

UDP = ["-o", "mbrtu.udp.port:5020", "-o", "mbrtu.crc_verification:TRUE"]
SERIAL = ["-d", "rtacser.data,mbrtu", "-o", "mbrtu.crc_verification:TRUE"]
WRONG = re.compile(r"malformed|incorrect|expert info|exception occurred|bad checksum", re.IGNORECASE)
failures = 0


def expect(is_right, what, output=""):
    global failures
    print("ok  " if is_right else f"FAIL {output}", what)
    failures += not is_right


def tshark(capture, *words):
    done = subprocess.run(["tshark", "-n", "-r", capture, *words], text=True, timeout=60,
                          capture_output=True, check=False)
    return done.stdout if done.returncode == 0 else f"malformed: {done.stderr}"


def columns(capture, *fields):
    named = [word for field in fields for word in ("-e", field)]
    return [line.split("\t") for line in
            tshark(capture, *UDP, "-T", "fields", *named).splitlines()]


def main(write_captures):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([write_captures, folder], check=True)
        udp, serial = f"{folder}/udp.pcap", f"{folder}/serial.pcap"
        codes = [row[0] for row in columns(udp, "modbus.func_code")]
        expect(codes == [code for pair in "3 6 8 16 23 43 3".split() for code in (pair, pair)],
               "every function is told apart", codes)
        words = [row[0] for row in columns(udp, "modbus.regval_uint16")]
        expect(words[1] == "40,0,0,0", "the registers of an answer are shown", words)
        refusals = [row[0] for row in columns(udp, "modbus.exception_code")]
        expect(refusals[-1] == "2", "the exception is shown", refusals)
        names = [row[0] for row in columns(udp, "modbus.object_str_value")]
        expect("ATV310H037N4" in names[11], "the identification is shown", names)
        for capture, options in ((udp, UDP), (serial, SERIAL)):
            text = tshark(capture, *options, "-V")
            expect("Modbus RTU" in text and not WRONG.search(text), f"no complaint about {capture}",
                   WRONG.findall(text))
        subprocess.run([write_captures, folder, "damaged"], check=True)
        for capture, options in ((udp, UDP), (serial, SERIAL)):
            expect(WRONG.search(tshark(capture, *options, "-V")), f"damage is found in {capture}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
