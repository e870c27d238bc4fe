# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""mbpoll, as a commissioning engineer calls it, against our server: python3 mbpoll_client.py DEVICE"""
import subprocess
import sys

# Verbose: it shows the bytes it sends.
LINE = ["-v", "-m", "rtu", "-b", "19200", "-P", "even", "-0", "-1", "-o", "5"]
failures = 0


def mbpoll(device, *words, unit="1"):
    options = [word for word in words if not word.startswith("=")]
    values = [word[1:] for word in words if word.startswith("=")]
    done = subprocess.run(["mbpoll", *LINE, "-a", unit, *options, device, *values], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60, check=False)
    return done.returncode, done.stdout


def expect(is_right, what, output):
    global failures
    print("ok  " if is_right else f"FAIL\n{output}", what)
    failures += not is_right


def main(device):
    code, output = mbpoll(device, "-r", "100", "-c", "3")
    expect(code == 0 and "[01][03]" in output and "[102]: \t102" in output, "03 reads", output)
    code, output = mbpoll(device, "-r", "110", "=4711")
    expect(code == 0 and "[01][06]" in output and "Written 1 reference" in output, "06 writes", output)
    code, output = mbpoll(device, "-r", "111", "=7", "=8")
    expect(code == 0 and "[01][10]" in output and "Written 2 reference" in output, "16 writes", output)
    code, output = mbpoll(device, "-r", "110", "-c", "3")
    expect("[110]: \t4711" in output and "[112]: \t8" in output, "all was written", output)
    code, output = mbpoll(device, "-t", "0", "-r", "0")
    expect("Illegal function" in output, "exception 01", output)
    code, output = mbpoll(device, "-r", "199", "-c", "2")
    expect("Illegal data address" in output, "exception 02", output)
    code, output = mbpoll(device, "-r", "100", "-c", "64")
    expect("Illegal data value" in output, "exception 03", output)
    code, output = mbpoll(device, "-r", "100", unit="9")
    expect("timed out" in output, "silence of another unit", output)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
