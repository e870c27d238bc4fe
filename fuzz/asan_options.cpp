// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the address sanitizer of a fuzz target leaves out: no call stack of each allocation, and freed memory is kept
// from being used again for a megabyte instead of 256. Only libFuzzer allocates. ASAN_OPTIONS says otherwise.
extern "C" char const* __asan_default_options();
extern "C" char const* __asan_default_options()
{
    return "malloc_context_size=0:quarantine_size_mb=1:thread_local_quarantine_size_kb=64";
}
