// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "words/value_block.hpp"

#include <rtuwire/frames.hpp>

#include "catalog/catalog.hpp"

namespace tool {

std::string why_no_neighbours(std::vector<chosen_register> const& registers, unsigned most)
{
    place const& first = registers.front().where;
    unsigned count = 0;
    for (chosen_register const& each : registers) {
        if (each.where.bit >= 0) {
            return "bits of a register are written by words of their own: 40.3=on 40.4-7=9";
        }
        if (each.where.space != first.space or each.where.address != first.address + count) {
            return "values of one request go to neighbours, in rising order and without a hole, and " +
                   text_of(each.where) + " is none of the one before it";
        }
        count += each.where.size();
    }
    return count <= most
               ? std::string{}
               : "one request has at most " + std::to_string(most) + (first.is_single_bit() ? " coils" : " registers") +
                     ", and these are " + std::to_string(count);
}

value_block values_in(std::string_view word, vocabulary const& meant)
{
    value_block block{.words = {std::string{word}}};
    std::size_t const equals = word.find('=');
    std::string_view const name = word.substr(0, equals);
    bool const is_pattern = name.find_first_of("*?@") != name.npos or not group_in(name).empty();
    if (equals == word.npos or is_pattern) { // refused as what names no register
        return block;
    }
    register_selection selected = select_registers({&name, 1}, meant);
    if (selected.refused or selected.registers.size() < 2) {
        return block;
    }
    block.registers = std::move(selected.registers);
    auto const refuse = [&block, word](std::string const& sentence) {
        block.refused = refusal{"no_block", std::string{word}, std::string{word} + ": " + sentence, {}};
        return block;
    };
    if (meant.drive != nullptr) {
        return refuse("the registers of an " + std::string{meant.drive->name} +
                      " are written one at a time, each checked by what is known of it: say a word for each");
    }
    unsigned const registers = meant.names == nullptr
                                   ? rtuwire::max_write_quantity
                                   : meant.names->max_registers.value_or(rtuwire::max_write_quantity);
    bool const is_of_bits = block.registers[0].where.is_single_bit();
    std::string const why =
        why_no_neighbours(block.registers, is_of_bits ? rtuwire::max_bit_write_quantity : registers);
    if (not why.empty()) {
        return refuse(why);
    }
    std::vector<std::string_view> const values = parts_of(word.substr(equals + 1));
    if (values.size() != block.registers.size()) {
        return refuse(std::string{name} + " is " + std::to_string(block.registers.size()) + " values, and " +
                      std::to_string(values.size()) + (values.size() == 1 ? " stands" : " stand") +
                      " behind it: each takes one, as in 40-42=1,2,3");
    }
    block.words.clear();
    for (std::size_t i = 0; i < values.size(); ++i) {
        block.words.push_back(text_of(block.registers[i].where) + '=' + std::string{values[i]});
    }
    return block;
}

} // namespace tool
