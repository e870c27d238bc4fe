// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A port of whichever kind under a client: simulated drives, drives behind a TCP port, and what is said where nothing opens.
#include "../../tools/rtuwire/port/any_port.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/catch.hpp"
#include "support/soon.hpp"

#include <rtuwire/client.hpp>
#include <rtuwire/frames.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace tool;

namespace {

using clock_type = std::chrono::steady_clock;

port_description described(std::string const& word)
{
    auto const found = read_port_word(word);
    REQUIRE_FALSE(found.refused);
    return found.port;
}

/// ETA, the status word, of every drive here but the ATV28.
errc read_status(any_port& port, std::uint32_t unit, duration time_limit = test::limit)
{
    blocking_client client{port, port.timing(), {.response_timeout = time_limit, .retries = 0}};
    auto const response = client.ask(*unit_id::checked(unit), read_holding_registers{3201, 1});
    return response ? errc::none : response.error();
}

/// Whether a unit has a register at an address.
bool answers_at(any_port& port, std::uint32_t unit, std::uint16_t address)
{
    blocking_client client{port, port.timing(), {.response_timeout = test::limit, .retries = 0}};
    auto const response = client.ask(*unit_id::checked(unit), read_holding_registers{.start = address, .count = 1});
    REQUIRE((response or response.error() == errc::illegal_data_address));
    return response.has_value();
}

/// The far end of a simulated line. Its number may be given to another line at once.
class far_end {
public:
    explicit far_end(std::string const& path) : path_{path} { is_known_ = ::stat(path_.c_str(), &seen_) == 0; }

    bool is_there() const
    {
        struct stat now {};
        bool const is_any = is_known_ and ::stat(path_.c_str(), &now) == 0;
        return is_any and now.st_ctim.tv_sec == seen_.st_ctim.tv_sec and now.st_ctim.tv_nsec == seen_.st_ctim.tv_nsec;
    }

private:
    std::string path_;
    struct stat seen_ {};
    bool is_known_{false};
};

/// A TCP port of this machine on which nobody listens.
std::uint16_t free_port()
{
    sockaddr_in own{};
    own.sin_family = AF_INET;
    own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    int const found = ::socket(AF_INET, SOCK_STREAM, 0);
    socklen_t size = sizeof own;
    REQUIRE(::bind(found, reinterpret_cast<sockaddr*>(&own), size) == 0);
    REQUIRE(::getsockname(found, reinterpret_cast<sockaddr*>(&own), &size) == 0);
    ::close(found);
    return ntohs(own.sin_port);
}

/// A serial device server: socat, between a TCP port and a serial device.
class device_server {
public:
    device_server(std::uint16_t port, std::string const& device)
    {
        std::string const listen = "tcp-listen:" + std::to_string(port) + ",bind=127.0.0.1,reuseaddr,nodelay";
        std::string const line = device + ",raw,echo=0";
        process_ = ::fork();
        if (process_ == 0) {
            ::execlp("socat", "socat", listen.c_str(), line.c_str(), nullptr);
            ::_exit(127);
        }
    }
    device_server(device_server const&) = delete;
    ~device_server() { kill(); }

    void kill()
    {
        if (process_ > 0) {
            ::kill(process_, SIGKILL);
            ::waitpid(std::exchange(process_, -1), nullptr, 0);
        }
    }

private:
    pid_t process_{-1};
};

/// It listens a moment after it was started.
result<void> open_soon(any_port& port, port_description const& word)
{
    auto opened = port.open(word);
    for (int i = 0; i < 3'000 and not opened; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds{20});
        opened = port.open(word);
    }
    return opened;
}

} // namespace

TEST_CASE("simulated drives answer, each at its address")
{
    any_port port;
    REQUIRE(port.open(described("sim:atv320:7,atv12:3,atv310_2026:9")));
    CHECK(port.is_open());
    CHECK(port.is_simulated());
    for (std::uint32_t const unit : {7U, 3U, 9U}) {
        CHECK(read_status(port, unit) == errc::none);
    }
    CHECK(read_status(port, 8, milliseconds(50)) == errc::timed_out);
}

TEST_CASE("simulated drives have all their parameters, each its own")
{
    constexpr std::uint16_t preset_speed_2 = 11'410, pump_mode = 15'201, set_2_value_1 = 12'951,
                            scanner_word_8 = 12'708;
    any_port port;
    REQUIRE(port.open(described("sim:atv320:7,atv12:3,atv310_2026:9,atv310:10")));
    CHECK(answers_at(port, 7, preset_speed_2));
    CHECK(answers_at(port, 7, set_2_value_1));
    CHECK(answers_at(port, 3, preset_speed_2));
    CHECK(answers_at(port, 3, pump_mode));
    CHECK(not answers_at(port, 3, set_2_value_1));
    CHECK(not answers_at(port, 9, preset_speed_2));
    CHECK(answers_at(port, 9, scanner_word_8));
    CHECK(not answers_at(port, 10, scanner_word_8));
}

TEST_CASE("the first response of a simulated drive is soon there")
{
    // The best of some, and of many where other programs run as well.
    constexpr clock_type::duration most = std::chrono::milliseconds{30};
    auto shortest = clock_type::duration::max();
    for (int i = 0; i < 5 or (i < 50 and shortest >= most); ++i) {
        auto const start = clock_type::now();
        any_port port;
        REQUIRE(port.open(described("sim:atv320")));
        REQUIRE(read_status(port, 1) == errc::none);
        shortest = (std::min)(shortest, clock_type::now() - start);
    }
    INFO("busy?");
    CHECK(shortest < most);
}

TEST_CASE("simulated drives fall silent when their port is closed, opened anew or moved over")
{
    any_port port;
    REQUIRE(port.open(described("sim:atv320:7")));
    far_end const first{port.device()};
    CHECK(first.is_there());
    REQUIRE(port.open(described("sim:atv12:3")));
    CHECK_FALSE(first.is_there());
    CHECK(read_status(port, 3) == errc::none);
    CHECK(read_status(port, 7, milliseconds(50)) == errc::timed_out);
    any_port other{std::move(port)};
    CHECK(read_status(other, 3) == errc::none);
    far_end const second{other.device()};
    any_port third;
    REQUIRE(third.open(described("sim:atv28:5")));
    far_end const replaced{third.device()};
    third = std::move(other);
    CHECK_FALSE(replaced.is_there());
    CHECK(read_status(third, 3) == errc::none);
    other = std::move(third);
    other.close();
    CHECK_FALSE(second.is_there());
    CHECK_FALSE(other.is_open());
    CHECK_FALSE(other.is_simulated());
    CHECK(read_status(other, 3) == errc::device_not_open);
}

TEST_CASE("simulated drives end with their program, be it killed")
{
    int ends[2];
    REQUIRE(::pipe(ends) == 0);
    pid_t const program = ::fork();
    if (program == 0) {
        any_port port;
        static_cast<void>(port.open(described("sim:atv320")));
        static_cast<void>(::write(ends[1], port.device().data(), port.device().size()));
        ::pause();
    }
    char device[64]{};
    ssize_t const size = ::read(ends[0], device, sizeof device);
    CHECK(size > 0);
    far_end const far{device};
    CHECK(far.is_there());
    ::kill(program, SIGKILL);
    ::waitpid(program, nullptr, 0);
    CHECK_FALSE(far.is_there());
    ::close(ends[0]);
    ::close(ends[1]);
}

TEST_CASE("signals reach the program, not the thread of the drives")
{
    static std::atomic<std::thread::id> caught{};
    caught = std::thread::id{};
    auto* const before = std::signal(SIGUSR1, [](int) { caught = std::this_thread::get_id(); });
    any_port port;
    REQUIRE(port.open(described("sim:atv320")));
    ::kill(::getpid(), SIGUSR1);
    CHECK(caught.load() == std::this_thread::get_id());
    std::signal(SIGUSR1, before);
}

TEST_CASE("drives behind a serial device server answer until it is killed")
{
    simulated_drives drives;
    REQUIRE(drives.start({{{"atv320", 7}}}));
    std::uint16_t const number = free_port();
    device_server server{number, drives.device()};
    any_port port;
    REQUIRE(open_soon(port, described("tcp://127.0.0.1:" + std::to_string(number))));
    CHECK_FALSE(port.is_simulated());
    for (int i = 0; i < 20; ++i) {
        CHECK(read_status(port, 7) == errc::none);
    }
    CHECK(read_status(port, 8, milliseconds(50)) == errc::timed_out);
    // Not asked anything when it goes.
    server.kill();
    CHECK(read_status(port, 7) == errc::device_vanished);
    CHECK(port.failure().find("127.0.0.1:" + std::to_string(number) + ": the connection is gone") == 0);
}

TEST_CASE("over Modbus TCP a frame goes as a message, without the CRC that was made up")
{
    any_port port;
    CHECK(port.open(described("mbap://127.0.0.1:" + std::to_string(free_port()))) == errc::device_not_found);
    CHECK(port.has_numbers());
    std::array<std::byte, 260> place{};
    auto const frame = "07 06 21 35 00 00 93 9E"_hex;
    auto const hex = [](byte_view bytes) { return std::vector<std::byte>{bytes.begin(), bytes.end()}; };
    CHECK(hex(port.as_sent(frame, place)) == hex("FF FF 00 00 00 06 07 06 21 35 00 00"_hex));
    CHECK(hex(port.passed(frame)) == hex("07 06 21 35 00 00"_hex));
    any_port other;
    CHECK_FALSE(other.has_numbers());
    CHECK(hex(other.as_sent(frame, place)) == hex(frame));
    CHECK(hex(other.passed(frame)) == hex(frame));
}

TEST_CASE("what was written is known to have been taken, or not to have gone anywhere")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    any_port port;
    REQUIRE(port.open(described(far.path())));
    CHECK_FALSE(port.has_taken_last());
    std::vector<std::byte> const more(1U << 20U);
    CHECK(port.write(more, port.now() + milliseconds(20)) == errc::transmit_stalled);
    CHECK_FALSE(port.has_taken_last());
    std::array<std::byte, 4'096> place{};
    while (far.read(place, steady_now() + milliseconds(20))->size() != 0) {
    }
    // The failure before is one no more, and still the last that there was.
    CHECK(port.write(std::array<std::byte, 1>{}, test::soon()));
    CHECK(port.has_taken_last());
    CHECK_FALSE(port.failure().empty());

    struct : port_attendant {
        void wait(int, instant) override {}
        bool is_over() const override { return false; }
        bool may_send() const override { return may; }
        bool may{false};
    } attendant;
    port.attend(attendant);
    REQUIRE(far.read(place, test::soon())->size() == 1);
    CHECK(port.write(std::array<std::byte, 2>{}, test::soon()) == errc::cancelled);
    CHECK_FALSE(port.has_taken_last());
    attendant.may = true;
    CHECK(port.write(std::array<std::byte, 3>{}, test::soon()));
    CHECK(far.read(place, test::soon())->size() == 3);
}

TEST_CASE("what does not open says so with its name")
{
    any_port port;
    CHECK(port.failure().empty());
    CHECK(port.open(described("/dev/rtuwire-does-not-exist")) == errc::device_not_found);
    CHECK(port.failure().find("/dev/rtuwire-does-not-exist: ") == 0);
    pseudo_terminal other;
    REQUIRE(other.open());
    std::string const link = "./ttyTool" + std::to_string(::getpid());
    REQUIRE(::symlink(other.path().c_str(), link.c_str()) == 0);
    CHECK(port.open(serial_device{link + "x"}) == errc::device_not_found);
    CHECK(port.failure().find(link + "x: no such device") == 0);
    CHECK(port.failure().find("; did you mean " + link + "?") != std::string::npos);
    ::unlink(link.c_str());
    std::string const nobody = "127.0.0.1:" + std::to_string(free_port());
    CHECK(port.open(described("tcp://" + nobody)) == errc::device_not_found);
    CHECK(port.failure().find(nobody + ": ") == 0);
    CHECK(port.open(capture_file{"line.pcapng"}) == errc::device_not_serial);
    CHECK(port.failure().find("line.pcapng: a capture file") == 0);
    CHECK(port.open(simulated_drives_choice{{{"atv320", 0}}}) == errc::device_failed);
    CHECK(port.failure().find("sim: unit 0 is out of range") == 0);
    CHECK_FALSE(port.is_open());
    CHECK(port.descriptor_number() == -1);
}

TEST_CASE("a serial device has the times of its wire, what is no wire has none")
{
    any_port port;
    REQUIRE(port.open(described("sim:atv320")));
    CHECK(port.timing().silence() == duration{});
    CHECK(port.timing().characters(8) == duration{});
    pseudo_terminal far;
    REQUIRE(far.open());
    REQUIRE(port.open(described(far.path()), {.bits_per_second = 9'600}));
    CHECK_FALSE(port.is_simulated());
    CHECK(port.timing().characters(1) == line_timing{9'600, character_format::even_8_1}.characters(1));
    CHECK(port.timing().silence() == line_timing{9'600, character_format::even_8_1}.t3_5());
    port.keep_pause(milliseconds(7));
    CHECK(port.timing().silence() == milliseconds(7));
    CHECK(far.write(std::array<std::byte, 1>{}, test::soon()));
    std::array<std::byte, 4> place{};
    auto const bytes = port.read(place, test::soon());
    REQUIRE(bytes);
    CHECK(bytes->size() == 1);
}
