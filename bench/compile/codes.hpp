// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A mnemonic for each address, so that a thousand registers have different ones.
#pragma once

inline constexpr char letters[] = "0123456789ABCDEF";
template <unsigned A>
inline constexpr char code[5]{letters[A / 4096 % 16], letters[A / 256 % 16], letters[A / 16 % 16], letters[A % 16], 0};
