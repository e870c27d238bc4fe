// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a person types for a port, and what is said to what is none.
#include "../../tools/rtuwire/port/port_word.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <string>

#include <unistd.h>

#include "support/catch.hpp"

using namespace tool;

namespace {

port_description port(std::string const& word)
{
    auto const found = read_port_word(word);
    INFO(word);
    if (found.refused) {
        INFO(found.refused->sentence);
        CHECK_FALSE(found.refused);
    }
    return found.port;
}

struct said {
    std::string nearest;
    std::string sentence;
};

said refused(std::string const& word)
{
    auto const found = read_port_word(word);
    INFO(word);
    REQUIRE(found.refused);
    CHECK(found.refused->kind == "wrong_port");
    CHECK(found.refused->culprit == word);
    CHECK(found.refused->sentence.find("port " + word + ": ") == 0);
    CHECK(found.refused->sentence.find(found.refused->nearest) != std::string::npos);
    // What is proposed is right.
    if (not found.refused->nearest.empty() and found.refused->nearest.front() != '/') {
        CHECK_FALSE(read_port_word(found.refused->nearest).refused);
    }
    return {found.refused->nearest, found.refused->sentence};
}

bool has(std::string const& sentence, std::string const& part) { return sentence.find(part) != std::string::npos; }

/// A file that lives as long as this.
struct file {
    std::string path;

    file(std::string its_path, std::string const& content) : path{std::move(its_path)}
    {
        std::ofstream{path, std::ios::binary} << content;
    }
    file(file const&) = delete;
    ~file() { std::remove(path.c_str()); }
};

} // namespace

TEST_CASE("a serial device is a path, there or not")
{
    CHECK(port("/dev/ttyUSB77") == port_description{serial_device{"/dev/ttyUSB77"}});
    CHECK(port("/dev/serial/by-path/pci-0000:00:14.0-usb-0:2:1.0-port0") ==
          port_description{serial_device{"/dev/serial/by-path/pci-0000:00:14.0-usb-0:2:1.0-port0"}});
    CHECK(port("./ttyV0") == port_description{serial_device{"./ttyV0"}});
    CHECK(port("/dev/null") == port_description{serial_device{"/dev/null"}});
}

TEST_CASE("a host with its port")
{
    CHECK(port("tcp://plc-7.example:4001") == port_description{tcp_address{"plc-7.example", 4001}});
    CHECK(port("TCP://10.0.0.9:65535") == port_description{tcp_address{"10.0.0.9", 65'535}});
    CHECK(port("tcp://[fe80::1%eth0]:1") == port_description{tcp_address{"fe80::1%eth0", 1}});
}

TEST_CASE("a server of Modbus TCP, whose port is 502 where none is named")
{
    CHECK(port("mbap://plc-7.example") == port_description{mbap_address{"plc-7.example", 502}});
    CHECK(port("MBAP://10.0.0.9:1502") == port_description{mbap_address{"10.0.0.9", 1502}});
    CHECK(port("mbap://[::1]") == port_description{mbap_address{"::1", 502}});
    CHECK(port("mbap://[fe80::1%eth0]:1") == port_description{mbap_address{"fe80::1%eth0", 1}});
    CHECK_FALSE(port("tcp://host:502") == port("mbap://host"));
    CHECK(refused("mbap://host:").nearest == "mbap://host");
    CHECK(refused("mbap://host:0").nearest == "mbap://host");
    CHECK(refused("mbap://host:65536").nearest == "mbap://host");
    CHECK(refused("mbap://host/1").nearest == "mbap://host");
    CHECK(refused("mbap://::1:502").nearest == "mbap://[::1]:502");
    CHECK(refused("mbap://::1").nearest == "mbap://[::1]");
    CHECK(refused("mbap://fe80::1%eth0").nearest == "mbap://[fe80::1%eth0]");
    CHECK(refused("mbap://2001:db8:0:0:0:0:0:7").nearest == "mbap://[2001:db8:0:0:0:0:0:7]");
    CHECK(refused("tcp://::1").nearest == "tcp://[::1]:4001");
    CHECK(refused("mbap://plc:502:1").nearest.empty());
    CHECK(refused("mbap:host").nearest == "mbap://host");
    CHECK(refused("mbpa://host:502").nearest == "mbap://host:502");
    CHECK(has(refused("mbap://").sentence, "no host"));
    CHECK(has(refused("mbap://:502").sentence, "it is like mbap://host"));
}

TEST_CASE("who listens names an address of this machine by its number, and a port")
{
    auto const listens = [](std::string const& word) { return read_listen_word(word).port; };
    CHECK(listens("mbap://127.0.0.1:1502") == port_description{mbap_address{"127.0.0.1", 1502}});
    CHECK(listens("mbap://0.0.0.0:502") == port_description{mbap_address{"0.0.0.0", 502}});
    CHECK(listens("tcp://[::]:4001") == port_description{tcp_address{"::", 4001}});
    CHECK(listens("tcp://[fe80::1%eth0]:0") == port_description{tcp_address{"fe80::1%eth0", 0}});
    CHECK(listens("mbap://localhost:1502") == port_description{mbap_address{"127.0.0.1", 1502}});
    CHECK(listens("tcp://LOCALHOST:4001") == port_description{tcp_address{"127.0.0.1", 4001}});
    auto const refused_to_listen = [](std::string const& word) {
        auto const found = read_listen_word(word);
        INFO(word);
        REQUIRE(found.refused);
        CHECK(has(found.refused->sentence, word));
        CHECK((found.refused->nearest.empty() or not read_listen_word(found.refused->nearest).refused));
        return said{found.refused->nearest, found.refused->sentence};
    };
    for (std::string const host : {"meter", "plc-7.example", "127.1", "1.2.3.4.5", "256.0.0.1", "localhost.", "*"}) {
        for (std::string const start : {"mbap://", "tcp://"}) {
            auto const found = refused_to_listen(start + host + ":1502");
            CHECK(has(found.sentence, "an address of this machine"));
            CHECK(found.nearest == (host == "*" ? start + "0.0.0.0:1502" : ""));
        }
    }
    for (std::string const host : {"224.0.0.1", "239.255.255.250", "255.255.255.255", "[ff02::1]", "[ff02::1%eth0]"}) {
        for (std::string const start : {"mbap://", "tcp://"}) {
            CHECK(has(refused_to_listen(start + host + ":1502").sentence, "an address of many machines at once"));
        }
    }
    CHECK(listens("tcp://223.255.255.255:1") == port_description{tcp_address{"223.255.255.255", 1}});
    CHECK(refused_to_listen("mbap://127.0.0.1").nearest == "mbap://127.0.0.1:1502");
    CHECK(refused_to_listen("mbap://localhost").nearest == "mbap://localhost:1502");
    CHECK(refused_to_listen("tcp://127.0.0.1").nearest == "tcp://127.0.0.1:4001");
    CHECK(refused_to_listen("mbap://[::1]").nearest == "mbap://[::1]:1502");
    CHECK(has(refused_to_listen("mbap://*").sentence, "no port is named; it is like mbap://127.0.0.1:1502"));
    CHECK(has(refused_to_listen("tcp://127.0.0.1").sentence, "no port is named; it is like tcp://127.0.0.1:4001"));
    CHECK(has(refused_to_listen("127.0.0.1:1502").sentence, "an address to listen at is like"));
}

TEST_CASE("simulated drives with their units")
{
    using choice = simulated_drives_choice;
    CHECK(port("sim:atv320:7,atv12:3") == port_description{choice{{{"atv320", 7}, {"atv12", 3}}}});
    CHECK(port("sim:atv28") == port_description{choice{{{"atv28", 1}}}});
    CHECK(port("SIM:ATV310_2026:247") == port_description{choice{{{"atv310_2026", 247}}}});
}

TEST_CASE("a capture is known by its first bytes, whatever its name")
{
    file const capture{"port_word_capture_" + std::to_string(::getpid()), "\x0A\x0D\x0D\x0A"
                                                                          "rest"};
    CHECK(port(capture.path) == port_description{capture_file{capture.path}});
    CHECK(port("./" + capture.path) == port_description{capture_file{"./" + capture.path}});
    file const other{"port_word_text_" + std::to_string(::getpid()), "\x0A\x0D"};
    CHECK(has(refused(other.path).sentence, "no capture"));
    CHECK(has(refused("/tmp").sentence, "directory"));
}

TEST_CASE("a wrong host or port says what is wrong with it, and what would be right")
{
    CHECK(refused("tcp://host").nearest == "tcp://host:4001");
    CHECK(refused("tcp://host:").nearest == "tcp://host:4001");
    CHECK(refused("tcp://host:0").nearest == "tcp://host:4001");
    CHECK(refused("tcp://host:65536").nearest == "tcp://host:4001");
    CHECK(refused("tcp://host:-1").nearest == "tcp://host:4001");
    CHECK(refused("tcp://host:4001x").nearest == "tcp://host:4001");
    CHECK(refused("tcp://host:4001/").nearest == "tcp://host:4001");
    CHECK(refused("tcp://::1:4001").nearest == "tcp://[::1]:4001");
    CHECK(refused("tcp://[::1]").nearest == "tcp://[::1]:4001");
    CHECK(has(refused("tcp://").sentence, "no host"));
    CHECK(has(refused("tcp://:4001").sentence, "no host"));
    CHECK(has(refused("tcp://[]:4001").sentence, "no host"));
    CHECK(refused("tcp:host:4001").nearest == "tcp://host:4001");
    CHECK(refused("tcp:/host:4001").nearest == "tcp://host:4001");
    CHECK(refused("tpc://host:4001").nearest == "tcp://host:4001");
    CHECK(has(refused("http://host:4001").sentence, "a port is"));
}

TEST_CASE("a wrong simulated drive says which there are, and the nearest")
{
    CHECK(refused("sim:atv321:7,atv12:3").nearest == "sim:atv320:7,atv12:3");
    CHECK(refused("sim:atv320:7,atv21:3").nearest == "sim:atv320:7,atv12:3");
    CHECK(has(refused("sim:atv321").sentence, "there is no drive atv321, only atv12|"));
    CHECK(refused("sim:atv320:7,atv12:7").nearest == "sim:atv320:7,atv12:1");
    CHECK(refused("sim:atv320,atv12").nearest == "sim:atv320,atv12:2");
    CHECK(refused("sim:atv320:0").nearest == "sim:atv320:1");
    CHECK(refused("sim:atv320:248").nearest == "sim:atv320:1");
    CHECK(has(refused("sim:atv320:248").sentence, "248 is out of range"));
    CHECK(refused("sim:atv320:").nearest == "sim:atv320:1");
    CHECK(refused("sim:atv320:x").nearest == "sim:atv320:1");
    CHECK(has(refused("sim:").sentence, "a drive is missing, one of atv12|"));
    CHECK(has(refused("sim:atv320,").sentence, "a drive is missing"));
    CHECK(refused("sin:atv320:7").nearest == "sim:atv320:7");
}

TEST_CASE("whatever is mistyped, what is proposed is right")
{
    unsigned refusals = 0;
    for (std::string const right : {"tcp://host:4001", "tcp://[::1]:4001", "mbap://host", "mbap://[::1]:502",
                                    "sim:atv320:7,atv12:3", "sim:atv28"}) {
        for (std::size_t at = 0; at <= right.size(); ++at) {
            for (std::string const other : {"", "[", "]", ":", "/", ",", "x", "0", " ", "-"}) {
                for (std::size_t const left_out : {0U, 1U, 2U}) {
                    std::string const word =
                        right.substr(0, at) + other + right.substr((std::min)(at + left_out, right.size()));
                    if (read_port_word(word).refused) {
                        static_cast<void>(refused(word));
                        ++refusals;
                    }
                }
            }
        }
    }
    CHECK(refusals > 500);
    CHECK(refused("tcp://[::1:4001").nearest.empty());
}

TEST_CASE("the name of something that is not there")
{
    CHECK(refused("null").nearest == "/dev/null");
    CHECK(has(refused("ttyUSB77").sentence, "/dev/ttyUSB0"));
    CHECK(has(refused("").sentence, "a port is"));
}
