#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# The demonstration: a client and a server exchange the manuals' examples.
exec sh "$(dirname "$0")/run.sh" demo "$@"
