// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Arduino finds a library by a header beside its folders; from then on a sketch may include any other, by its own name.
#pragma once

#include <rtuwire/client.hpp>
#include <rtuwire/server.hpp>
