// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The sketch is the .cpp file beside this one; Arduino finds the library by the line below.
#include <rtuwire.h>
