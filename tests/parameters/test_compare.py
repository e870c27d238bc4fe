# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Shows that compare.py notices each kind of difference: rows of the headers are changed one by one."""
import os
import unittest

import compare
import facts

# What is changed in which row, and a word that the complaint has.
CHANGES = [
    ("atv12", "SP2", {"most": "3999"}, "most"), ("atv12", "SP2", {"least": ""}, "least"),
    ("atv12", "SP2", {"factory": "101"}, "factory"), ("atv12", "SP2", {"address": "11411"}, "address"),
    ("atv12", "SP2", {"unit": "rpm"}, "unit"), ("atv12", "SP2", {"step": "1/1"}, "unit"),
    ("atv12", "SP2", {"access": "conf"}, "access"), ("atv12", "SP2", {"kind": "i16"}, "kind"),
    ("atv12", "AIV1", {"kind": "u16"}, "kind"), ("atv12", "AO1C", {"access": "rw"}, "access"),
    ("atv12", "AO1C", {"source": "documented"}, "provenance"), ("atv12", "CRC", {"meanings": "0=x;1=x;2=x;3=x"}, "bits"),
    ("atv12", "RPT", {"mnemonics": "0=LIn;1=S"}, "enumeration"), ("atv12", "RPT", {"mnemonics": "0=LIn;1=S;3=U"}, "enum"),
    ("atv12", "RPT", {"meanings": "7=none"}, "words"), ("atv12", "RPT", {"kind": "u16"}, "kind"),
    ("atv12", "LSP", {"most": "TFR"}, "most"), ("atv12", "LPI", {"least": ""}, "least"),
    ("atv320", "CRL3", {"unit": "V"}, "unit"), ("atv320", "BFR", {"factory": "1"}, "factory"),
    ("atv320", "SH2", {"access": "r"}, "access"), ("atv320", "ULP3", {"step": "1/1"}, "unit"),
    ("atv320", "HSP", {"most": "5990"}, "most"), ("atv310", "NC8", {"access": "r"}, "access"),
]
TABLE = facts.read_table()
ROWS = {drive: compare.rows_of(os.environ["RTUWIRE_ROWS"], drive) for drive in facts.DRIVES}


class Changes(unittest.TestCase):
    def test_each_is_noticed(self):
        for drive, code, change, word in CHANGES:
            with self.subTest(drive=drive, code=code, change=change):
                row = next(row for row in ROWS[drive] if row["code"] == code)
                of_row = [fact for fact in TABLE if (fact.drive, fact.code) == (drive, code)]
                self.assertTrue(of_row)
                for fact in of_row:
                    compare.compare(row, fact)
                said = []
                for fact in of_row:
                    try:
                        compare.compare({**row, **change}, fact)
                    except compare.Difference as difference:
                        said.append(str(difference))
                self.assertTrue(said, "not noticed")
                self.assertTrue(any(word in each for each in said), said)
