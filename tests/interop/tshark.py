# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Lets tshark read the captures of our frames: python3 tshark.py WRITE_CAPTURES"""
import os
import re
import subprocess
import tempfile

from simulator import runs

UDP = ["-o", "mbrtu.udp.port:5020", "-o", "mbrtu.crc_verification:TRUE"]
SERIAL = ["-d", "rtacser.data,mbrtu", "-o", "mbrtu.crc_verification:TRUE"]
WRONG = re.compile(r"malformed|incorrect|expert info|exception occurred|bad checksum", re.IGNORECASE)

FIELDS = ["func_code", "reference_type", "reference_num", "reference_num_32", "bit_cnt", "word_cnt",
          "read_reference_num", "read_word_cnt", "write_reference_num", "write_word_cnt", "bitval",
          "regval_uint16", "and_mask", "or_mask", "ev_status", "ev_count", "ev_msg_count", "data",
          "diagnostic_code", "diagnostic.return_query_data.request",
          "diagnostic.return_query_data.echo", "diagnostic.restart_communication_option",
          "diagnostic.bus_message_count", "diagnostic.slave_busy_count", "object_str_value",
          "exception_code"]
# tshark takes nothing below five bytes for a frame of Modbus; SL 2.5.1.1 has no such limit, and the
# requests of functions 07, 11, 12 and 17 (AP 6.7, 6.9, 6.10, 6.13) have four.
SHORT = ""
# Request and answer in turn; of each frame the fields that tshark finds in it. The data that it shows
# of the first run of function 20 go on to the end of the frame; by AP 6.14 they are 0dff0e00.
FRAMES = ["3 3102 4", "3 40,0,0,0", "6 3103 000d", "6 3103 000d", "8 0 a537", "8 0 a537",
          "16 3104 2 20,30", "16 3104 2", "23 3102 2 3110 2 000f05dc", "23 00280000",
          "43", "43 Schneider Electric,ATV310H037N4,0201", "3 1 1", "3 2",
          "1 1 10", "1 1,0,0,1,0,0,1,0,0,0", "2 2 9", "2 1,0,0,1,0,0,1,0,0", "4 0 2", "4 0,10",
          "5 17 ff00", "5 17 ff00", "5 18 0000", "5 18 0000", SHORT, "7 6d",
          "8 1 0xff00", "8 1 0xff00", "8 0000 11", "8 11 258", "8 0000 17", "8 17 0",
          SHORT, "11 0x0000 1", SHORT, "12 0x0000 1 258", "15 19 10 cd01", "15 19 10",
          SHORT, "17 031234ff", "20 6,6 262145,196617 2,1", "20 6,6 0dff0e0003060e07,0e07",
          "21 6 262151 3 06af04be100d", "21 6 262151 3 06af04be100d",
          "22 3104 0x00f2 0x0025", "22 3104 0x00f2 0x0025", "24 1246", "24 2 01b81284"]
CHECKED = len(FRAMES) - FRAMES.count(SHORT)


def tshark(capture, *words):
    return subprocess.run(["tshark", "-n", "-r", capture, *words], text=True, timeout=60,
                          stdout=subprocess.PIPE, check=True).stdout


def fields_of_frames(capture):
    named = [word for field in FIELDS for word in ("-e", f"modbus.{field}")]
    lines = tshark(capture, *UDP, "-T", "fields", *named).splitlines()
    return [" ".join(filter(None, line.split("\t"))) for line in lines]


def check_captures(captures, expect):
    seen = fields_of_frames(captures[0][0])
    expect(seen == FRAMES, "every function and its registers are told apart", seen)
    for capture, options in captures:
        text = tshark(capture, *options, "-V")
        expect(text.count("[correct]") == CHECKED, f"every CRC is right in {capture}")
        expect(not WRONG.search(text), f"no complaint about {capture}", WRONG.findall(text))


def check_damaged(captures, expect):
    for capture, options in captures:
        text = tshark(capture, *options, "-V")
        expect(text.count("incorrect, should be") == 1
               and text.count("[correct]") == CHECKED - 1, f"damage is found in {capture}")


def main(expect, write_captures):
    with tempfile.TemporaryDirectory(prefix="capture-", dir=os.getcwd()) as folder:
        captures = [(f"{folder}/udp.pcap", UDP), (f"{folder}/serial.pcap", SERIAL)]
        subprocess.run([write_captures, folder], check=True)
        check_captures(captures, expect)
        subprocess.run([write_captures, folder, "damaged"], check=True)
        check_damaged(captures, expect)


runs(main)
