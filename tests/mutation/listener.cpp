// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Tells after each test case how long it took and which changes it came by, ends the program in one that
// takes too long to be asked often, and bounds what a changed program takes of the machine.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using listener_base = Catch::EventListenerBase;
#else
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <catch2/catch.hpp>
using listener_base = Catch::TestEventListenerBase;
#endif

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include <sys/resource.h>
#include <sys/time.h>

#include "rtuwire_mutation.hpp"

namespace {

class listener : public listener_base {
public:
    using listener_base::listener_base;

    void testRunStarting(Catch::TestRunInfo const&) override
    {
        if (char const* const path = std::getenv("RTUWIRE_REACHED"); path != nullptr) {
            report_ = std::fopen(path, "w");
        }
        if (char const* const us = std::getenv("RTUWIRE_MICROSECONDS"); us != nullptr) {
            case_limit_us_ = std::atol(us);
            rlimit const memory{most_memory, most_memory};
            setrlimit(RLIMIT_AS, &memory);
        }
    }
    void testCaseStarting(Catch::TestCaseInfo const&) override
    {
        limit_time(case_limit_us_);
        start_ = std::clock();
        std::memset(rtuwire_mutation::reached, 0, sizeof rtuwire_mutation::reached);
    }
    void testCaseEnded(Catch::TestCaseStats const& about) override
    {
        double const took = static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC;
        limit_time(0);
        if (report_ == nullptr) {
            return;
        }
        std::fprintf(report_, "%.4f\t%s\t", took, name_of(about.testInfo));
        for (std::size_t i = 0; i < sizeof rtuwire_mutation::reached; ++i) {
            if (rtuwire_mutation::reached[i] != 0) {
                std::fprintf(report_, " %zu", i);
            }
        }
        std::fputc('\n', report_);
        std::fflush(report_);
    }

private:
    static constexpr rlim_t most_memory = 2'000'000'000;

    /// Of the processor; the signal ends the program.
    static void limit_time(long us)
    {
        itimerval const left{{}, {us / 1'000'000, us % 1'000'000}};
        setitimer(ITIMER_PROF, &left, nullptr);
    }

    // A pointer in version 3 of Catch2.
    static char const* name_of(Catch::TestCaseInfo const& test) { return test.name.c_str(); }
    static char const* name_of(Catch::TestCaseInfo const* test) { return test->name.c_str(); }

    std::FILE* report_ = nullptr;
    long case_limit_us_ = 0;
    std::clock_t start_{};
};
CATCH_REGISTER_LISTENER(listener)

} // namespace
