// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server of libmodbus whose memory is set and told on its standard input and output: unit 1, each space as many addresses.
//
//   memory_libmodbus DEVICE FIRST COUNT [usual]        (mbap:1502 for a device: Modbus TCP on that port of this machine)
//
// It waits for its response time-out before some of its exceptions: for 2 ms here. With `usual` it is asked nothing and does as its
// examples do: it waits in modbus_receive, with the default of 500 ms.
//
//   set holding 40 1234 00ff   -> done          (words in hexadecimal; of coil and discrete 0 or 1)
//   get holding 40 2           -> 1234 00ff
//   lack 5 6                   -> done          (functions refused with exception 01 from now on)
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <set>
#include <sstream>
#include <string>

#include <modbus.h>
#include <poll.h>
#include <unistd.h>

namespace {

class memory {
public:
    memory(unsigned first, int count)
        : first_{first}, bank_{modbus_mapping_new_start_address(
                             first, static_cast<unsigned>(count), first, static_cast<unsigned>(count), first,
                             static_cast<unsigned>(count), first, static_cast<unsigned>(count))}
    {}

    modbus_mapping_t* bank() { return bank_; }
    bool lacks(int function) const { return lacking_.count(function) != 0; }

    std::string told(std::string const& line)
    {
        std::istringstream words{line};
        std::string what, space;
        words >> what;
        if (what == "lack") {
            lacking_.clear();
            for (int function = 0; words >> function;) {
                lacking_.insert(function);
            }
            return "done";
        }
        std::size_t address = 0;
        words >> space >> address;
        if (what == "set") {
            words >> std::hex;
            for (unsigned word = 0; words >> word; ++address) {
                put(space, address - first_, word);
            }
            return "done";
        }
        std::size_t count = 0;
        words >> count;
        std::string text;
        for (std::size_t i = 0; i < count; ++i) {
            char word[8] = "";
            std::snprintf(word, sizeof word, "%s%04x", i == 0 ? "" : " ", held(space, address - first_ + i));
            text += word;
        }
        return text;
    }

private:
    void put(std::string const& space, std::size_t at, unsigned word)
    {
        if (space == "holding" or space == "input") {
            (space == "holding" ? bank_->tab_registers : bank_->tab_input_registers)[at] =
                static_cast<std::uint16_t>(word);
        } else {
            (space == "coil" ? bank_->tab_bits : bank_->tab_input_bits)[at] = static_cast<std::uint8_t>(word);
        }
    }

    unsigned held(std::string const& space, std::size_t at) const
    {
        if (space == "holding" or space == "input") {
            return (space == "holding" ? bank_->tab_registers : bank_->tab_input_registers)[at];
        }
        return (space == "coil" ? bank_->tab_bits : bank_->tab_input_bits)[at];
    }

    unsigned first_;
    modbus_mapping_t* bank_;
    std::set<int> lacking_{};
};

/// False where the other end has gone.
bool answer(modbus_t* line, memory& held)
{
    std::uint8_t request[MODBUS_TCP_MAX_ADU_LENGTH];
    int const size = modbus_receive(line, request);
    if (size <= 0) {
        return size == 0;
    }
    if (held.lacks(request[modbus_get_header_length(line)])) {
        modbus_reply_exception(line, request, MODBUS_EXCEPTION_ILLEGAL_FUNCTION);
    } else {
        modbus_reply(line, request, size, held.bank());
    }
    return true;
}

/// On a serial device, or a port of this machine, where one client after another is served.
class served_line {
public:
    explicit served_line(std::string const& device) : is_tcp_{device.rfind("mbap:", 0) == 0}
    {
        line_ = is_tcp_ ? modbus_new_tcp("127.0.0.1", std::stoi(device.substr(5)))
                        : modbus_new_rtu(device.c_str(), 115'200, 'N', 8, 1);
        if (line_ != nullptr and modbus_set_slave(line_, 1) == 0) {
            socket_ = is_tcp_                      ? modbus_tcp_listen(line_, 1)
                      : modbus_connect(line_) == 0 ? modbus_get_socket(line_)
                                                   : -1;
        }
    }

    bool is_open() const { return socket_ >= 0; }
    void refuse_soon() { modbus_set_response_timeout(line_, 0, 2000); }
    int socket() const { return has_client_ ? modbus_get_socket(line_) : socket_; }

    void serve(memory& held)
    {
        if (is_tcp_ and not has_client_) {
            has_client_ = modbus_tcp_accept(line_, &socket_) >= 0;
        } else if (not answer(line_, held) and is_tcp_) {
            modbus_close(line_);
            has_client_ = false;
        }
    }

private:
    bool is_tcp_;
    bool has_client_{false};
    modbus_t* line_{nullptr};
    int socket_{-1};
};

} // namespace

int main(int argc, char** argv)
{
    served_line line{argc == 4 or argc == 5 ? argv[1] : ""};
    if (not line.is_open()) {
        std::fprintf(stderr, "libmodbus cannot serve on the device\n");
        return 2;
    }
    memory held{static_cast<unsigned>(std::stoul(argv[2])), std::stoi(argv[3])};
    std::cout << "ready" << std::endl;
    while (argc == 5) {
        line.serve(held);
    }
    line.refuse_soon();
    for (;;) {
        pollfd both[]{{STDIN_FILENO, POLLIN, 0}, {line.socket(), POLLIN, 0}};
        poll(both, 2, -1);
        if (both[1].revents != 0) {
            line.serve(held);
        }
        std::string words;
        if (both[0].revents != 0) {
            if (not std::getline(std::cin, words)) {
                return 0;
            }
            std::cout << held.told(words) << std::endl;
        }
    }
}
