// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Our client sends random requests to another's server: agreement_client DEVICE SERVER COUNT FUNCTION...
// The server is `libmodbus` or `pymodbus`; see agreement_pymodbus_server.py for what is special there.
#include "agreement.hpp"

#include <cstring>

#include <rtuwire/client/blocking.hpp>
#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/serial_line.hpp>
#include <rtuwire/wire/errc_name.hpp>
#include <rtuwire/wire/functions.hpp>

using namespace rtuwire;

namespace {

using namespace agreement;

/// Values in wire order, as a request takes them.
std::vector<std::byte> wire_words(words const& values)
{
    std::vector<std::byte> made;
    for (std::uint16_t const each : values) {
        made.push_back(static_cast<std::byte>(each >> 8U));
        made.push_back(static_cast<std::byte>(each & 0xFFU));
    }
    return made;
}
words values_of(register_view from)
{
    words made;
    for (std::size_t i = 0; i < from.size(); ++i) {
        made.push_back(from[i]);
    }
    return made;
}
bytes values_of(byte_view from)
{
    bytes made;
    for (std::byte const each : from) {
        made.push_back(static_cast<std::uint8_t>(each));
    }
    return made;
}

class our_client {
public:
    explicit our_client(posix_serial& port)
        : line_{port,
                line_timing::host(115'200, character_format::none_8_1),
                {.response_timeout = milliseconds(1000), .retries = 0}}
    {}

    /// Asks, and hands the response on where there is one.
    template <typename Request, typename Take> outcome ask(Request const& request, Take const& take)
    {
        auto const told = line_.ask(unit_id{1}, request);
        last_ = told.error();
        if (not told) {
            std::printf("     rtuwire: %s\n", std::string{name(told.error())}.c_str());
            return told == errc::timed_out ? outcome::lost : outcome::refused;
        }
        take(*told);
        return outcome::done;
    }
    template <typename Request> outcome ask(Request const& request)
    {
        return ask(request, [](auto const&) {});
    }

    outcome read_bits(unsigned function, std::uint16_t start, std::uint16_t size, bits& seen)
    {
        auto const take = [&](bit_view from) {
            seen.clear();
            for (std::size_t i = 0; i < from.size() and i < size; ++i) {
                seen.push_back(from[i] ? 1 : 0);
            }
        };
        if (function == 1) {
            return ask(read_coils{start, size}, [&](auto const& told) { take(told.coils); });
        }
        return ask(read_discrete_inputs{start, size}, [&](auto const& told) { take(told.inputs); });
    }
    outcome read_words(unsigned function, std::uint16_t start, std::uint16_t size, words& seen)
    {
        auto const take = [&](auto const& told) { seen = values_of(told.registers); };
        return function == 3 ? ask(read_holding_registers{start, size}, take)
                             : ask(read_input_registers{start, size}, take);
    }
    outcome write_bit(std::uint16_t at, bool value) { return ask(write_single_coil{at, value}); }
    outcome write_word(std::uint16_t at, std::uint16_t value) { return ask(write_single_register{at, value}); }
    outcome write_bits(std::uint16_t at, bits const& values)
    {
        std::vector<std::byte> packed((values.size() + 7) / 8);
        for (std::size_t i = 0; i < values.size(); ++i) {
            packed[i / 8] |= static_cast<std::byte>(values[i] << (i % 8));
        }
        return ask(write_multiple_coils{at, bit_view{packed, values.size()}});
    }
    outcome write_words(std::uint16_t at, words const& values)
    {
        auto const sent = wire_words(values);
        return ask(write_multiple_registers{at, register_view{sent}});
    }
    outcome mask(std::uint16_t at, std::uint16_t and_mask, std::uint16_t or_mask)
    {
        return ask(mask_write_register{at, and_mask, or_mask});
    }
    outcome exchange(std::uint16_t read_at, std::uint16_t read_size, std::uint16_t write_at, words const& values,
                     words& seen)
    {
        auto const sent = wire_words(values);
        return ask(read_write_multiple_registers{read_at, read_size, write_at, register_view{sent}},
                   [&](auto const& told) { seen = values_of(told.registers); });
    }

private:
    blocking_client<posix_serial> line_;
    errc last_{errc::none};
};

/// What only pymodbus has a server for. What it answers stands in registers that are written before.
class further_requests {
public:
    further_requests(agreement_test& test, common_requests<our_client>& requests, our_client& client)
        : test_{test}, requests_{requests}, client_{client}
    {}

    void request(unsigned function)
    {
        switch (function) {
        case 7: return check_status();
        case 8: return check_diagnostics();
        case 11: return check_counter();
        case 12: return check_log();
        case 17: return check_id();
        case 20: return check_read_file();
        case 21: return check_write_file();
        case 24: return check_queue();
        case 43: return check_identification();
        default: test_.expect(false, "the function is known", function);
        }
    }

private:
    /// Asks; the response has to pass a check too.
    template <typename Request, typename Check>
    void expect(Request const& request, char const* what, std::size_t told, Check const& check)
    {
        bool is_right = false;
        bool const done =
            test_.asked([&] { return client_.ask(request, [&](auto const& got) { is_right = check(got); }); });
        test_.expect(done and is_right, what, told);
    }

    void set_control(std::uint16_t at, std::size_t size) { requests_.write_words(at, test_.random_words(size)); }
    void set_counted(std::uint16_t at, std::size_t least, std::size_t most)
    {
        words values = test_.random_words(most + 1);
        values[0] = static_cast<std::uint16_t>(test_.number(least, most));
        requests_.write_words(at, values);
    }

    void check_status()
    {
        set_control(status_at, 1);
        unsigned const told = test_.expected.held[status_at] & 0xFFU;
        expect(read_exception_status{}, "07 tells", told, [&](auto const& got) { return got.outputs == told; });
    }
    void check_diagnostics()
    {
        // 04 has no response.
        constexpr std::array<std::uint16_t, 13> numbers{0x00, 0x01, 0x02, 0x03, 0x0A, 0x0B, 0x0C,
                                                        0x0D, 0x0E, 0x0F, 0x10, 0x11, 0x14};
        std::uint16_t const number = numbers[test_.number(0, numbers.size() - 1)];
        bool const is_count = number >= 0x0B and number <= 0x12;
        std::uint16_t data = 0;
        std::uint16_t told = 0;
        if (is_count) {
            set_control(counters_at, 8);
            told = test_.expected.held[counters_at + number - 0x0BU];
        } else if (number == 0x00) {
            told = data = test_.word();
        } else if (number == 0x01) {
            told = data = test_.number(0, 1) == 0 ? 0 : 0xFF00;
        } else if (number == 0x03) {
            told = data = static_cast<std::uint16_t>(test_.number(0, 255) << 8U);
        }
        expect(diagnostics{static_cast<subfunction>(number), register_block{data}}, "08 tells", number,
               [&](auto const& got) {
                   return static_cast<std::uint16_t>(got.what) == number and got.data.size() == 1 and
                          got.data[0] == told;
               });
    }
    void check_counter()
    {
        set_control(events_at, 1);
        std::uint16_t const told = test_.expected.held[events_at];
        expect(get_comm_event_counter{}, "11 tells", told,
               [&](auto const& got) { return not got.is_busy() and got.events == told; });
    }
    void check_log()
    {
        set_control(events_at, 2);
        set_counted(log_at, 0, 64);
        auto const& held = test_.expected.held;
        expect(get_comm_event_log{}, "12 tells", held[log_at], [&](auto const& got) {
            return got.status == 0 and got.events == held[events_at] and got.messages == held[messages_at] and
                   values_of(got.log) == test_.expected.counted(log_at, 64);
        });
    }
    void check_id()
    {
        set_counted(id_at, 1, 122);
        bytes told = test_.expected.counted(id_at, 122);
        told.push_back(0xFF);
        expect(report_server_id{}, "17 tells", told.size(),
               [&](auto const& got) { return values_of(got.data) == told; });
    }
    file_run random_run(std::size_t most)
    {
        auto const count = static_cast<std::uint16_t>(test_.number(1, most));
        return {static_cast<std::uint16_t>(test_.number(1, 0xFFFF)),
                static_cast<std::uint16_t>(test_.number(0, 10'000U - count)), count};
    }
    words records(file_run const& run) const
    {
        words found;
        for (std::size_t i = 0; i < run.count; ++i) {
            found.push_back(test_.expected.held[memory::record_at(run.file, run.record + i)]);
        }
        return found;
    }
    template <std::size_t Count> void check_runs(std::size_t most)
    {
        std::array<file_run, Count> runs{};
        for (auto& each : runs) {
            each = random_run(most);
        }
        expect(read_file_record{runs}, "20 reads", Count, [&](auto const& got) {
            bool is_same = not got.run(Count);
            for (std::size_t i = 0; i < Count; ++i) {
                auto const found = got.run(i);
                is_same = is_same and found and values_of(*found) == records(runs[i]);
            }
            return is_same;
        });
    }
    void check_read_file()
    {
        switch (test_.number(0, 3)) {
        case 0: return check_runs<1>(121);
        case 1: return check_runs<2>(60);
        case 2: return check_runs<7>(16);
        default: return check_runs<35>(2);
        }
    }
    void check_write_file()
    {
        file_run const run = random_run(122);
        words const values = test_.random_words(run.count);
        auto const sent = wire_words(values);
        expect(write_file_record{run.file, run.record, register_view{sent}}, "21 writes", run.count,
               [&](auto const& got) {
                   auto const found = got.run(0);
                   return found and found->run == run and values_of(found->values) == values and not got.run(1);
               });
        for (std::size_t i = 0; i < values.size(); ++i) {
            test_.expected.held[memory::record_at(run.file, run.record + i)] = values[i];
        }
    }
    void check_queue()
    {
        std::uint16_t const at = test_.start(32);
        words const told = test_.expected.queue(at);
        expect(read_fifo_queue{at}, "24 reads", at, [&](auto const& got) { return values_of(got.registers) == told; });
    }
    void check_identification()
    {
        // What agreement_pymodbus_server.py says of itself: of each object its number, and how long its text is.
        constexpr std::array<std::array<std::uint8_t, 2>, 8> objects{
            {{0, 8}, {1, 158}, {2, 3}, {3, 184}, {4, 4}, {6, 11}, {0x80, 100}, {0xFF, 150}}};
        auto const access = static_cast<identification_access>(test_.number(1, 4));
        std::size_t const reachable = access == identification_access::basic     ? 3
                                      : access == identification_access::regular ? 6
                                                                                 : objects.size();
        std::size_t const from = test_.number(0, reachable - 1);
        bool const is_single = access == identification_access::single;
        std::size_t const end = is_single ? from + 1 : reachable;
        expect(read_device_identification{access, objects[from][0]}, "43 tells", objects[from][0],
               [&](device_identification const& got) {
                   std::size_t next = from;
                   for (auto at = got.first(); at; at = got.after(*at)) {
                       if (next == end or at->id != objects[next][0] or at->value.size() != objects[next][1]) {
                           return false;
                       }
                       ++next;
                   }
                   return got.more_follows ? next < end and got.next_object == objects[next][0] : next == end;
               });
    }

    agreement_test& test_;
    common_requests<our_client>& requests_;
    our_client& client_;
};

/// libmodbus tells one identifier: its number, that it runs, and its version (AP 6.13).
void check_libmodbus_id(agreement_test& test, our_client& client)
{
    bytes told;
    bool const done = test.asked(
        [&] { return client.ask(report_server_id{}, [&](auto const& got) { told = values_of(got.data); }); });
    test.expect(done and told.size() > 5 and told[0] == 180 and told[1] == 0xFF and
                    std::memcmp(told.data() + 2, "LMB", 3) == 0,
                "17 tells", told.size());
}

} // namespace

int main(int argc, char** argv)
{
    posix_serial port;
    if (argc < 5 or not port.open(argv[1])) {
        std::fprintf(stderr, "%s\n",
                     argc < 5 ? "usage: agreement_client DEVICE SERVER COUNT FUNCTION..." : port.failure().c_str());
        return 2;
    }
    bool const is_libmodbus = std::strcmp(argv[2], "libmodbus") == 0;
    static agreement_test test{2};
    our_client client{port};
    common_requests requests{test, client};
    further_requests further{test, requests, client};
    auto const count = static_cast<unsigned>(std::atoi(argv[3]));
    for (int i = 4; i < argc; ++i) {
        auto const function = static_cast<unsigned>(std::atoi(argv[i]));
        requests.fill(function);
        for (unsigned made = 0; made < count; ++made) {
            if (is_libmodbus and function == 17) {
                check_libmodbus_id(test, client);
            } else if (not requests.request(function)) {
                further.request(function);
            }
        }
        requests.sweep(function);
        test.end_of(function, count);
    }
    return test.status(count * static_cast<unsigned>(argc - 4));
}
