// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client of libmodbus sends random requests to our server: agreement_libmodbus_client DEVICE COUNT FUNCTION...
#include <cerrno>

#include <modbus.h>

#include "agreement.hpp"

namespace {

using namespace agreement;

class libmodbus_client {
public:
    explicit libmodbus_client(modbus_t* line) : line_{line} {}

    outcome read_bits(unsigned function, std::uint16_t start, std::uint16_t size, bits& seen)
    {
        seen.assign(size, 2);
        int const got = function == 1 ? modbus_read_bits(line_, start, size, seen.data())
                                      : modbus_read_input_bits(line_, start, size, seen.data());
        return ended(got == size);
    }
    outcome read_words(unsigned function, std::uint16_t start, std::uint16_t size, words& seen)
    {
        seen.assign(size, 0);
        int const got = function == 3 ? modbus_read_registers(line_, start, size, seen.data())
                                      : modbus_read_input_registers(line_, start, size, seen.data());
        return ended(got == size);
    }
    outcome write_bit(std::uint16_t at, bool value) { return ended(modbus_write_bit(line_, at, value ? 1 : 0) == 1); }
    outcome write_word(std::uint16_t at, std::uint16_t value)
    {
        return ended(modbus_write_register(line_, at, value) == 1);
    }
    outcome write_bits(std::uint16_t at, bits const& values)
    {
        int const size = static_cast<int>(values.size());
        return ended(modbus_write_bits(line_, at, size, values.data()) == size);
    }
    outcome write_words(std::uint16_t at, words const& values)
    {
        int const size = static_cast<int>(values.size());
        return ended(modbus_write_registers(line_, at, size, values.data()) == size);
    }
    outcome mask(std::uint16_t at, std::uint16_t and_mask, std::uint16_t or_mask)
    {
        return ended(modbus_mask_write_register(line_, at, and_mask, or_mask) == 1);
    }
    outcome exchange(std::uint16_t read_at, std::uint16_t read_size, std::uint16_t write_at, words const& values,
                     words& seen)
    {
        seen.assign(read_size, 0);
        int const got = modbus_write_and_read_registers(line_, write_at, static_cast<int>(values.size()), values.data(),
                                                        read_at, read_size, seen.data());
        return ended(got == read_size);
    }
    outcome server_id(bytes& seen)
    {
        seen.assign(256, 0);
        int const got = modbus_report_slave_id(line_, 256, seen.data());
        seen.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
        return ended(got > 0);
    }

private:
    outcome ended(bool is_done)
    {
        if (is_done) {
            return outcome::done;
        }
        bool const is_lost = errno == ETIMEDOUT;
        std::printf("     libmodbus: %s\n", modbus_strerror(errno));
        modbus_flush(line_);
        return is_lost ? outcome::lost : outcome::refused;
    }

    modbus_t* line_;
};

/// An identifier of random bytes: set by function 16, read by 17.
void check_server_id(agreement_test& test, common_requests<libmodbus_client>& requests, libmodbus_client& client)
{
    words control = test.random_words(122);
    control[0] = static_cast<std::uint16_t>(test.number(1, 121));
    requests.write_words(id_at, control);
    bytes seen;
    bool const done = test.asked([&] { return client.server_id(seen); });
    bool is_same = done and seen.size() == control[0];
    for (std::size_t i = 0; is_same and i < seen.size(); ++i) {
        is_same = seen[i] == (control[i + 1] & 0xFFU);
    }
    test.expect(is_same, "17 tells", seen.size(), control[0]);
}

} // namespace

int main(int argc, char** argv)
{
    modbus_t* const line = argc > 3 ? modbus_new_rtu(argv[1], 115'200, 'N', 8, 1) : nullptr;
    if (line == nullptr or modbus_set_slave(line, 1) != 0 or modbus_connect(line) != 0) {
        std::fprintf(stderr, "libmodbus cannot open the device: %s\n", modbus_strerror(errno));
        return 2;
    }
    modbus_set_response_timeout(line, 1, 0);
    static agreement_test test{1};
    libmodbus_client client{line};
    common_requests requests{test, client};
    auto const count = static_cast<unsigned>(std::atoi(argv[2]));
    for (int i = 3; i < argc; ++i) {
        auto const function = static_cast<unsigned>(std::atoi(argv[i]));
        requests.fill(function);
        for (unsigned made = 0; made < count; ++made) {
            if (function == 17) {
                check_server_id(test, requests, client);
            } else {
                test.expect(requests.request(function), "the function is known", function);
            }
        }
        requests.sweep(function);
        test.end_of(function, count);
    }
    modbus_close(line);
    modbus_free(line);
    return test.status(count * static_cast<unsigned>(argc - 3));
}
