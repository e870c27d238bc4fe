// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "monitor/typed_keys.hpp"

#include <string_view>

namespace tool {

namespace {

constexpr char escape = '\x1b';

key key_of_letter(char letter)
{
    switch (letter) {
    case 'k': return key::up;
    case 'j': return key::down;
    case '>': return key::next_value;
    case '<': return key::value_before;
    case 'g': return key::plot;
    case 'c': return key::changed;
    case 't': return key::times;
    case 'b': return key::bell;
    case 'p': return key::pause;
    case '?':
    case 'h': return key::help;
    case '+':
    case '=': return key::longer;
    case '-': return key::shorter;
    case 'q':
    case 'Q': return key::quit;
    case '\f': return key::redraw; // Ctrl-L
    default: return key::none;
    }
}

key key_of_arrow(char last)
{
    switch (last) {
    case 'A': return key::up;
    case 'B': return key::down;
    case 'C': return key::next_value;
    case 'D': return key::value_before;
    default: return key::none;
    }
}

} // namespace

key typed_keys::push(char byte)
{
    if (byte == escape) {
        within_ = part::escape;
        return key::none;
    }
    switch (within_) {
    case part::escape:
        within_ = byte == '[' or byte == 'O'                                       ? part::sequence
                  : std::string_view{"PX]^_"}.find(byte) != std::string_view::npos ? part::text
                                                                                   : part::nothing;
        return is_within() ? key::none : key_of_letter(byte);
    case part::sequence:
    case part::parameters: return push_sequence(byte);
    case part::text: // to BEL, or Esc and a backslash
        within_ = byte == '\a' ? part::nothing : part::text;
        return key::none;
    case part::nothing: break;
    }
    return key_of_letter(byte);
}

key typed_keys::push_sequence(char byte)
{
    bool const is_plain = within_ == part::sequence; // not Ctrl and the arrow, nor F5
    within_ = byte >= ' ' and byte <= '?' ? part::parameters : part::nothing;
    return is_plain and not is_within() ? key_of_arrow(byte) : key::none;
}

} // namespace tool
