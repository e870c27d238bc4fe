// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What each of the two files of linked_main.cpp says of its build and of the code that it runs.
#pragma once

struct facts {
    unsigned crc;              ///< of "123456789"
    unsigned form;             ///< of the CRC, as a number of `crc_form`
    bool is_checked;           ///< RTUWIRE_CHECKED
    void const* checks_frames; ///< where its `check_frame` is
    bool traps;                ///< whether it ends the program to read a value that is not there
};

facts first_facts();
facts second_facts();
