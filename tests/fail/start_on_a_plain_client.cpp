// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive's start on a client that does not keep whose motor it ordered to run.
// EXPECT: this client does not keep whose motor it ordered to run: take drive_client<Units>, or a bus
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/client/client.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

#ifdef REFUSED
using link = client;
#else
using link = drive_client<>;
#endif

void pass(link& line, start& run, instant now) { line.converse(run, now); }
