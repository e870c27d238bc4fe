// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Part of a program that is linked with all of glibc (RTUWIRE_STATIC_TOOL). The modules by which a system looks up hosts and
// users (/etc/nsswitch.conf) belong to its own glibc, and one of another version ends such a program by a signal, say, behind a
// write, which is noted with its user. Only what glibc has within is asked: files and name servers.
#include <nss.h>

namespace {

[[maybe_unused]] bool const is_set =
    __nss_configure_lookup("passwd", "files") == 0 and __nss_configure_lookup("hosts", "files dns") == 0;

} // namespace
