# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Lets tshark read the captures of our frames: python3 tshark.py WRITE_CAPTURES"""
import os
import re
import subprocess
import sys
import tempfile

UDP = ["-o", "mbrtu.udp.port:5020", "-o", "mbrtu.crc_verification:TRUE"]
SERIAL = ["-d", "rtacser.data,mbrtu", "-o", "mbrtu.crc_verification:TRUE"]
WRONG = re.compile(r"malformed|incorrect|expert info|exception occurred|bad checksum", re.IGNORECASE)

FIELDS = ["func_code", "reference_num", "word_cnt", "read_reference_num", "read_word_cnt",
          "write_reference_num", "write_word_cnt", "regval_uint16", "data",
          "diagnostic.return_query_data.request", "diagnostic.return_query_data.echo",
          "object_str_value", "exception_code"]
# Request and answer in turn; of each frame the fields that tshark finds in it.
FRAMES = ["3 3102 4", "3 40,0,0,0", "6 3103 000d", "6 3103 000d", "8 a537", "8 a537",
          "16 3104 2 20,30", "16 3104 2", "23 3102 2 3110 2 000f05dc", "23 00280000",
          "43", "43 Schneider Electric,ATV310H037N4,0201", "3 1 1", "3 2"]
failures = 0


def expect(is_right, what, detail=""):
    global failures
    print("ok  " if is_right else f"FAIL {detail}", what)
    failures += not is_right


def tshark(capture, *words):
    return subprocess.run(["tshark", "-n", "-r", capture, *words], text=True, timeout=20,
                          stdout=subprocess.PIPE, check=True).stdout


def fields_of_frames(capture):
    named = [word for field in FIELDS for word in ("-e", f"modbus.{field}")]
    lines = tshark(capture, *UDP, "-T", "fields", *named).splitlines()
    return [" ".join(filter(None, line.split("\t"))) for line in lines]


def check_captures(captures):
    seen = fields_of_frames(captures[0][0])
    expect(seen == FRAMES, "every function and its registers are told apart", seen)
    for capture, options in captures:
        text = tshark(capture, *options, "-V")
        expect(text.count("[correct]") == len(FRAMES), f"every CRC is right in {capture}")
        expect(not WRONG.search(text), f"no complaint about {capture}", WRONG.findall(text))


def check_damaged(captures):
    for capture, options in captures:
        text = tshark(capture, *options, "-V")
        expect(text.count("incorrect, should be") == 1
               and text.count("[correct]") == len(FRAMES) - 1, f"damage is found in {capture}")


def main(write_captures):
    with tempfile.TemporaryDirectory(prefix="capture-", dir=os.getcwd()) as folder:
        captures = [(f"{folder}/udp.pcap", UDP), (f"{folder}/serial.pcap", SERIAL)]
        subprocess.run([write_captures, folder], check=True)
        check_captures(captures)
        subprocess.run([write_captures, folder, "damaged"], check=True)
        check_damaged(captures)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
