# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What Wireshark makes of our captures, with and without our script: wireshark.py WRITE_TRACE READ_TRACE WIRESHARK_LUA EXTCAP PAGE"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

UDP = ["-o", "mbrtu.udp.port:1502", "-o", "mbrtu.crc_verification:TRUE", "-o", "ip.check_checksum:TRUE"]
USER0 = ["-o", 'uat:user_dlts:"User 0 (DLT=147)","mbrtu","0","","0",""']
UNITS = ["-o", "rtuwire.units:7=atv320,3=atv12"]
UNABLE = "Unable to classify"
# Wireshark dissects no frame of four bytes, the requests of these, and pairs no response to what it has not seen.
SHORT = {7, 11, 12, 17}
FORMS = ("udp", "user0", "rtac_serial", "upper_pdu")
# The table of an ATV320: CMD 8501, LFR 8502 in 0.1 Hz, signed; ETA 3201; RFR 3202 in 0.1 Hz, signed; ACC 9001 in
# steps that INR sets. The ATV12 has RFR at the same address.
REGISTERS = ["read ETA, RFR", "ETA 0x0237, RFR 50.0 Hz", "write ACC 13 steps of INR", "ACC 13 steps of INR",
             "write CMD 0x0006, LFR -50.0 Hz", "written CMD, LFR",
             "write CMD 0x000F, LFR 50.0 Hz; read ETA, RFR", "ETA 0x0237, RFR -1.0 Hz",
             "read RFR", "RFR 12.3 Hz", "", "", "write ACC 13 steps of INR", "refused: illegal data value", "", ""]
COMMENTS = ["", "echo", "damaged", "", "late", "foreign", "foreign", "stray", "stray", "damaged", "", ""]
failures = 0


def expect(is_right, what, detail=""):
    global failures
    print("ok  " if is_right else f"FAIL {detail}", what)
    failures += not is_right


def run(*words, **more):
    return subprocess.run(words, text=True, timeout=60, stdout=subprocess.PIPE, stderr=subprocess.PIPE, **more)


def tshark(capture, *words):
    done = run("tshark", "-n", "-r", capture, *words)
    expect(done.returncode == 0 and "Lua" not in done.stderr, f"tshark reads {pathlib.Path(capture).name}", done.stderr)
    return done.stdout


def fields(capture, names, *words):
    """Of each frame a list of texts, one a field."""
    named = [word for name in names for word in ("-e", name)]
    return [line.split("\t") for line in tshark(capture, *UDP, *words, "-T", "fields", *named).splitlines()]


class Captures:
    def __init__(self, write, folder):
        self.write, self.folder = write, folder

    def path(self, scene, form="udp"):
        name = f"{self.folder}/{form}-{scene}.pcapng"
        subprocess.run([self.write, name, form, scene], check=True, timeout=60)
        return name


def check_functions(captures, script):
    names = ["_ws.col.Protocol", "_ws.col.Info", "modbus.func_code", "modbus.request_frame", "modbus.response_time",
             "ip.checksum.status", "udp.payload", "modbus.exception_code"]
    frames = fields(captures.path("functions"), names)
    seen, plain = set(), 0
    for i, (protocol, info, code, request, time, checksum, payload, exception) in enumerate(frames):
        function = int(payload[2:4], 16) % 128
        seen.add(function)
        expect(checksum == "1", f"frame {i + 1}: the checksum of IPv4 is right", checksum)
        is_request = i % 2 == 0
        if is_request and function in SHORT:
            expect(protocol == "UDP" and len(payload) == 8, f"frame {i + 1}: too short for Wireshark", protocol)
            plain += 1
            continue
        way = "   Query: " if is_request else "Response: "
        expect(info.strip().startswith(way.strip()) and int(code) == function, f"frame {i + 1}: {info}", info)
        if not is_request and function not in SHORT and not exception:
            expect((request, time) == (str(i), "0.005000000"), f"frame {i + 1}: its request", (request, time))
    expect(len(seen) == 19 and plain == len(SHORT), "all nineteen functions were seen", seen)
    check_functions_with_script(captures, script)


def check_functions_with_script(captures, script):
    names = ["_ws.col.Protocol", "_ws.col.Info", "rtuwire.request_frame", "rtuwire.response_time"]
    frames = fields(captures.path("functions"), names, "-X", f"lua_script:{script}")
    for i, (protocol, info, request, time) in enumerate(frames):
        way = "Query: Unit:   2" if i % 2 == 0 else "Response: Unit:   2"
        expect(protocol == "Modbus RTU" and info.strip().startswith(way), f"frame {i + 1} with the script: {way}", info)
        link = ("", "") if i % 2 == 0 else (str(i), "0.005000000")
        expect((request, time) == link, f"frame {i + 1} with the script: its request", (request, time))


def check_registers(captures, script):
    capture = captures.path("drive")
    names = ["_ws.col.Info", "rtuwire.registers", "ip.dst", "modbus.func_code", "mbrtu.unit_id"]
    frames = fields(capture, names, "-X", f"lua_script:{script}", *UNITS)
    for i, (info, registers, *_) in enumerate(frames):
        expect(registers == REGISTERS[i] and info.endswith(REGISTERS[i]), f"frame {i + 1}: {REGISTERS[i]}", info)
    expect([frame[2:] for frame in frames[-2:]] == [["10.0.0.0", "6", "0"], ["10.0.0.0", "16", "0"]],
           "both broadcasts are shown", frames[-2:])
    chosen = fields(capture, names, "-X", f"lua_script:{script}", *UNITS, "-o", "rtuwire.drive:atv320")
    expect(chosen[11][1] == "RFR 12.3 Hz" and chosen[14][1] == "write CMD 0x0000",
           "a drive for all other units, and broadcasts", chosen)
    numbers = fields(capture, ["modbus.regnum16", "modbus.regval_uint16"])
    expect(numbers[1] == ["3201,3202", "567,500"], "Wireshark itself numbers a response's registers", numbers[1])
    text = tshark(capture, *UDP, "-V")
    expect(text.count("Interface name: /dev/ttyUSB0") == len(frames), "the line's name is shown")
    expect(text.count("Direction: Outbound") == 9 and text.count("Direction: Inbound") == 7, "both directions")
    about = run("capinfos", capture).stdout
    expect("Speed = 19200" in about and "10.0.0.254 the client" in about, "bit rate and comment of the line", about)


def check_page(captures, script, page):
    """The transcript on the page is what tshark prints."""
    shown = tshark(captures.path("drive"), "-o", "mbrtu.udp.port:1502", "-X", f"lua_script:{script}", "-o",
                   "rtuwire.units:0=atv320,7=atv320,3=atv12")
    lines = [line.rstrip() for line in shown.splitlines()]
    transcript = pathlib.Path(page).read_text(encoding="utf-8").split("```\n$ tshark", 1)[1].split("```")[0]
    printed = [line for line in transcript.splitlines()[1:] if line != "..."]
    expect(len(printed) > 10 and all(line in lines for line in printed), "the page shows what tshark prints", printed)


def check_troubles(captures):
    names = ["frame.comment", "mbrtu.crc16.status", "frame.time_relative", "_ws.col.Protocol", "modbus.response_time"]
    frames = fields(captures.path("troubles"), names)
    expect([frame[0] for frame in frames] == COMMENTS, "verdicts are comments", frames)
    expect([i for i, frame in enumerate(frames) if frame[1] == "0"] == [2], "only the damaged frame has a bad CRC", frames)
    expect([i for i, frame in enumerate(frames) if frame[3] == "UDP"] == [8, 9], "what has no role is no exchange", frames)
    expect(frames[4][4] == "0.305000000", "a late response tells how late", frames[4])
    expect(frames[10][2] == "4200.410000000", "time goes on over a pause of 70 minutes", frames[10])


def check_forms(captures):
    for form in FORMS:
        for scene in ("functions", "drive", "troubles"):
            text = tshark(captures.path(scene, form), *UDP, *USER0, "-d", "rtacser.data,mbrtu")
            # The way to see that the form of the others is told apart, too: Wireshark says so.
            expect((UNABLE in text) == (form != "udp" and scene != "troubles"), f"{form}, {scene}: classified or not")


def check_reading(captures, read):
    """Our reader reads what other programs made of our files."""
    for form in FORMS:
        capture = captures.path("troubles", form)
        ours = run(read, capture)
        expect(ours.returncode == 0 and len(ours.stdout.splitlines()) == 12, f"{form} is read back", ours.stdout)
        expect(ours.stdout.splitlines()[4].startswith("1700000000370000 in response late 07 03 02 01 F4"),
               f"{form}: time, role, verdict and bytes", ours.stdout)
        again = f"{captures.folder}/again"
        tshark(capture, "-w", again)
        expect(run(read, again).stdout == ours.stdout, f"{form}, written by tshark, is the same")
        for kind in ("pcap", "nsecpcap"):
            tshark(capture, "-F", kind, "-w", again)
            bytes_of = [line.split(" ", 4)[4] for line in run(read, again).stdout.splitlines()]
            expect(bytes_of == [line.split(" ", 4)[4] for line in ours.stdout.splitlines()], f"{form} as {kind}")


def check_extcap(captures, extcap):
    """The interface of Wireshark runs the tool: here one that writes a capture and goes on, as a line does."""
    folder = pathlib.Path(captures.folder, "extcap")
    folder.mkdir()
    shutil.copy(extcap, folder)
    tool = folder.parent / "rtuwire"
    tool.write_text(f'#!/bin/sh\necho "$@" >"$0.words"\nfor last; do :; done\ncat {captures.path("drive")} >"$last"\n'
                    "exec sleep 20\n", encoding="utf-8")
    tool.chmod(0o755)
    # Wireshark takes the folder from nobody who is root.
    user = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"] if os.getuid() == 0 else []
    for path in (folder.parent, folder, *folder.iterdir()):
        os.chmod(path, 0o777)
    environment = {**os.environ, "HOME": str(folder.parent), "WIRESHARK_EXTCAP_DIR": str(folder), "RTUWIRE": str(tool)}
    if "Modbus RTU line" not in run(*user, "tshark", "-D", env=environment).stdout:
        expect(False, "the line is among the interfaces")
        return
    shown = run(*user, "tshark", "-n", "-i", "rtuwire", "-o", "extcap.rtuwire.port:/dev/ttyUSB9", "-o",
                "extcap.rtuwire.baud:9600", *UDP, "-c", "16", env=environment)
    expect(len(shown.stdout.splitlines()) == 16 and "Read Write Register" in shown.stdout, "frames arrive live", shown)
    words = tool.with_name("rtuwire.words").read_text(encoding="utf-8")
    expect(words.startswith("--port /dev/ttyUSB9 --baud 9600 --format 8E1 capture -o /"), "the tool is told the line", words)


def main(write, read, lua, extcap, page):
    os.environ["LC_ALL"] = "C.UTF-8"
    with tempfile.TemporaryDirectory(prefix="rtuwire-capture-") as folder:
        script = f"{folder}/rtuwire.lua"
        pathlib.Path(script).write_text(run(lua).stdout, encoding="utf-8")
        captures = Captures(write, folder)
        check_functions(captures, script)
        check_registers(captures, script)
        check_page(captures, script, page)
        check_troubles(captures)
        check_forms(captures)
        check_reading(captures, read)
        check_extcap(captures, extcap)
    print(f"{failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
