// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Only a conversation or client that has a name lends what lies in its own memory.
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/plan_writer.hpp>
#include <rtuwire/ask/poller.hpp>
#include <rtuwire/client/blocking.hpp>
#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/table/write_plan.hpp>

#include <utility>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using altivar::atv12::acc;
using altivar::atv12::rfr;

namespace {

using device = altivar::atv12::device;

template <typename T> constexpr bool has_next = requires(T&& conversation) { std::forward<T>(conversation).next(); };
template <typename T>
constexpr bool lends_request =
    has_next<T&>and has_next<T const&> and not has_next<T> and not has_next<T const> and conversation<T>;

STATIC_CHECK(lends_request<single_request<read_holding_registers>>);
STATIC_CHECK(lends_request<word_read>);
STATIC_CHECK(lends_request<register_read<value_of<rfr>>>);
STATIC_CHECK(lends_request<poller<read_plan<device, rfr>>>);
STATIC_CHECK(lends_request<plan_writer<write_plan<device, acc>>>);

template <typename T> constexpr bool has_latest = requires(T&& conversation)
{
    std::forward<T>(conversation).latest();
};
using panel = poller<read_plan<device, rfr>>;
STATIC_CHECK(has_latest<panel&>and has_latest<panel const&>);
STATIC_CHECK(not has_latest<panel> and not has_latest<panel const>);

template <typename T> constexpr bool has_ask = requires(T&& line, read_holding_registers request)
{
    std::forward<T>(line).ask(unit_id{1}, request);
};
STATIC_CHECK(has_ask<blocking_client<posix_serial>&>);
STATIC_CHECK(not has_ask<blocking_client<posix_serial>>);

} // namespace
