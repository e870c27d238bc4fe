// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive's start, its stop, its cycle or a stop of several drives on a client that does not keep whose motor it ordered to run.
// CASES: 4
// ALONE
// EXPECT: this client does not keep whose motor it ordered to run: take drive_client<Units>, or a bus
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/drives.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

#ifdef REFUSED
using link = client;
#else
using link = drive_client<>;
#endif

#if not defined(REFUSED) or REFUSED == 1
void pass(link& line, start& run, instant now) { line.converse(run, now); }
#endif
#if not defined(REFUSED) or REFUSED == 2
void pass(link& line, stop& rest, instant now) { line.converse(rest, now); }
#endif
#if not defined(REFUSED) or REFUSED == 3
void pass(link& line, cyclic<atv320::device>& loop, instant now) { line.converse(loop, now); }
#endif
#if not defined(REFUSED) or REFUSED == 4
void pass(link& line, broadcast_stop<2>& rest, instant now) { line.converse(rest, now); }
#endif
