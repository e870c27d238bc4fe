// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client of libmodbus over Modbus TCP that asks unit 1 what its standard input says, and says what it was answered:
//
//   asking_libmodbus PORT
//
//   3 1000 2          -> ok 18 7           (also 1, 2 and 4)
//   6 1000 5          -> ok                (5, 15 and 16, too: address, values)
//   22 1000 255 5     -> exception 1
//   23 1000 2 1010 7  -> ok 18 7           (what is read, then where the values go)
//                     -> failed ...        (no answer, or one that it does not take)
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <modbus.h>

namespace {

struct outcome {
    int result{-1};
    std::vector<unsigned> values{};
};

template <class Item> std::vector<Item> items(std::vector<int> const& words, std::size_t from)
{
    std::vector<Item> found;
    for (std::size_t i = from; i < words.size(); ++i) {
        found.push_back(static_cast<Item>(words[i]));
    }
    return found;
}

template <class Item, class Read> outcome read_values(modbus_t* line, std::vector<int> const& words, Read read)
{
    std::vector<Item> room(static_cast<std::size_t>(words[2]));
    int const result = read(line, words[1], words[2], room.data());
    return {result, result < 0 ? std::vector<unsigned>{} : std::vector<unsigned>(room.begin(), room.end())};
}

outcome ask(modbus_t* line, std::vector<int> const& words)
{
    int const address = words[1];
    switch (words[0]) {
    case 1: return read_values<std::uint8_t>(line, words, modbus_read_bits);
    case 2: return read_values<std::uint8_t>(line, words, modbus_read_input_bits);
    case 3: return read_values<std::uint16_t>(line, words, modbus_read_registers);
    case 4: return read_values<std::uint16_t>(line, words, modbus_read_input_registers);
    case 5: return {modbus_write_bit(line, address, words[2])};
    case 6: return {modbus_write_register(line, address, static_cast<std::uint16_t>(words[2]))};
    case 15: {
        auto const values = items<std::uint8_t>(words, 2);
        return {modbus_write_bits(line, address, static_cast<int>(values.size()), values.data())};
    }
    case 16: {
        auto const values = items<std::uint16_t>(words, 2);
        return {modbus_write_registers(line, address, static_cast<int>(values.size()), values.data())};
    }
    case 22:
        return {modbus_mask_write_register(line, address, static_cast<std::uint16_t>(words[2]),
                                           static_cast<std::uint16_t>(words[3]))};
    default: {
        auto const values = items<std::uint16_t>(words, 4);
        std::vector<std::uint16_t> room(static_cast<std::size_t>(words[2]));
        int const result = modbus_write_and_read_registers(line, words[3], static_cast<int>(values.size()),
                                                           values.data(), address, words[2], room.data());
        return {result, result < 0 ? std::vector<unsigned>{} : std::vector<unsigned>(room.begin(), room.end())};
    }
    }
}

} // namespace

int main(int argc, char** argv)
{
    modbus_t* const line = argc == 2 ? modbus_new_tcp("127.0.0.1", std::atoi(argv[1])) : nullptr;
    if (line == nullptr or modbus_set_slave(line, 1) != 0 or modbus_connect(line) != 0) {
        std::fprintf(stderr, "libmodbus cannot connect\n");
        return 2;
    }
    modbus_set_response_timeout(line, 20, 0);
    for (std::string text; std::getline(std::cin, text);) {
        std::istringstream in{text};
        std::vector<int> words;
        for (int word = 0; in >> word;) {
            words.push_back(word);
        }
        errno = 0;
        outcome const found = ask(line, words);
        if (found.result < 0) {
            int const code = errno - MODBUS_ENOBASE;
            std::cout << (code > 0 and code < MODBUS_EXCEPTION_MAX ? "exception " + std::to_string(code)
                                                                   : std::string{"failed "} + modbus_strerror(errno));
        } else {
            std::cout << "ok";
            for (unsigned const value : found.values) {
                std::cout << ' ' << value;
            }
        }
        std::cout << std::endl;
    }
    modbus_close(line);
    modbus_free(line);
    return 0;
}
