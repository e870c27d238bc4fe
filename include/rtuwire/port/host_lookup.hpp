// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The addresses of a host, by its name or number, within a time limit. The system's own call knows no limit: it waits for
// a name server for up to a minute, so a name is looked up in a thread, which is left behind when the time is over.
#pragma once

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

#ifdef _WIN32
#include <process.h>
#else
#include <pthread.h>
#include <signal.h>
#endif

#include <rtuwire/core/version.hpp>
#include <rtuwire/port/chrono.hpp>
#include <rtuwire/port/descriptor.hpp>
#include <rtuwire/port/platform.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// One look-up: what is asked, and what was found. Made by `std::make_shared`. The addresses live as long as this.
class host_lookup : public std::enable_shared_from_this<host_lookup> {
public:
    host_lookup(std::string host, std::uint16_t port) : host_{std::move(host)}, port_{std::to_string(port)} {}
    host_lookup(host_lookup const&) = delete;
    host_lookup& operator=(host_lookup const&) = delete;
    ~host_lookup()
    {
        if (found_ != nullptr) {
            ::freeaddrinfo(found_);
        }
    }

    /// Looks the host up before a deadline, once. Errors: `device_not_found`, `timed_out`, `device_failed`; `why()` says
    /// more.
    result<void> run(host_deadline const& until)
    {
        start_sockets();
        ask(AI_NUMERICHOST);
        if (status_ == EAI_NONAME) {
            if (auto const asked = ask_aside(until); not asked) {
                why_ = asked == errc::timed_out ? "not found in time" : system_text(errno);
                return asked;
            }
        }
        if (status_ == 0) {
            return {};
        }
        bool const has_errno = status_ == lookup_failed_by_errno;
        why_ = has_errno ? system_text(system_error_) : lookup_text(status_);
        return has_errno or status_ == EAI_MEMORY ? errc::device_failed : errc::device_not_found;
    }

    /// Why nothing was found.
    [[nodiscard]] std::string const& why() const noexcept { return why_; }

    /// The addresses that were found.
    [[nodiscard]] addrinfo const* first() const noexcept { return found_; }

private:
    void ask(int flags) noexcept
    {
        addrinfo wanted{};
        wanted.ai_family = AF_UNSPEC;
        wanted.ai_socktype = SOCK_STREAM;
        wanted.ai_flags = flags | AI_NUMERICSERV;
        status_ = ::getaddrinfo(host_.c_str(), port_.c_str(), &wanted, &found_);
        system_error_ = errno;
    }

#ifdef _WIN32

    /// Asks in a thread that keeps this alive. Where the time is over first, what is asked for belongs to the thread.
    result<void> ask_aside(host_deadline const& until)
    {
        auto own = std::make_unique<std::shared_ptr<host_lookup>>(shared_from_this());
        auto const thread =
            reinterpret_cast<HANDLE>(::_beginthreadex(nullptr, 0, &host_lookup::thread, own.get(), 0, nullptr));
        if (thread == nullptr) {
            return errc::device_failed;
        }
        static_cast<void>(own.release()); // it is the thread's now
        DWORD const ended = ::WaitForSingleObject(thread, until.left().microseconds / 1'000U + 1U);
        ::CloseHandle(thread);
        return ended == WAIT_OBJECT_0 ? result<void>{} : errc::timed_out;
    }

    static unsigned __stdcall thread(void* given)
    {
        std::unique_ptr<std::shared_ptr<host_lookup>> const own{static_cast<std::shared_ptr<host_lookup>*>(given)};
        (*own)->ask(0);
        return 0;
    }

#else

    /// Asks in a thread that keeps this alive; its end is a byte in a pipe, of which both ends belong to this, too. Where
    /// the time is over first, what is asked for belongs to the thread.
    result<void> ask_aside(host_deadline const& until)
    {
        {
            standard_places const kept;
            std::array<int, 2> ends{};
            if (::pipe(ends.data()) != 0) {
                return errc::device_failed;
            }
            is_over_ = descriptor{ends[0]};
            says_so_ = descriptor{ends[1]};
        }
        for (descriptor const* each : {&is_over_, &says_so_}) {
            static_cast<void>(::fcntl(each->number(), F_SETFD, FD_CLOEXEC));
        }
        if (not start_thread()) {
            return errc::device_failed;
        }
        std::array<std::byte, 1> place{};
        auto const ended = is_over_.read(place, until);
        if (not ended) {
            return ended.error();
        }
        return ended->empty() ? result<void>{errc::timed_out} : result<void>{};
    }

    /// The program's signals stay with the threads that it knows.
    bool start_thread()
    {
        auto own = std::make_unique<std::shared_ptr<host_lookup>>(shared_from_this());
        sigset_t all{};
        sigset_t before{};
        sigfillset(&all); // a macro on macOS
        ::pthread_sigmask(SIG_SETMASK, &all, &before);
        pthread_t thread{};
        int const failure = ::pthread_create(&thread, nullptr, &host_lookup::thread, own.get());
        ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
        if (failure != 0) {
            errno = failure;
            return false;
        }
        static_cast<void>(own.release()); // it is the thread's now
        ::pthread_detach(thread);
        return true;
    }

    static void* thread(void* given)
    {
        std::unique_ptr<std::shared_ptr<host_lookup>> const own{static_cast<std::shared_ptr<host_lookup>*>(given)};
        (*own)->ask(0);
        std::array<std::byte, 1> const over{};
        static_cast<void>((*own)->says_so_.write(over, steady_now()));
        return nullptr;
    }

    descriptor is_over_{};
    descriptor says_so_{};

#endif

    std::string host_;
    std::string port_;
    std::string why_{};
    addrinfo* found_{nullptr};
    int status_{0};
    int system_error_{0};
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
