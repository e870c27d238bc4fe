// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the check must find: an allocation.
int* exercise();

int* exercise() { return new int{1}; }
