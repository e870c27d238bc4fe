// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Only a conversation or client that has a name lends what lies in its own memory.
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/client/access.hpp>
#include <rtuwire/client/blocking.hpp>
#include <rtuwire/client/plan_writer.hpp>
#include <rtuwire/client/poller.hpp>
#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/table/write_plan.hpp>

#include <utility>

#include "support/proof.hpp"

using namespace rtuwire;
using altivar::atv12::acc;
using altivar::atv12::rfr;

namespace {

using device = altivar::atv12::device;

template <typename T> constexpr bool has_next = requires(T&& talk)
{
    std::forward<T>(talk).next();
};
template <typename T>
constexpr bool lends_question = has_next<T&>and has_next<T const&> and not has_next<T> and
                                not has_next<T const> and conversation<T>;

STATIC_CHECK(lends_question<single_question<read_holding_registers>>);
STATIC_CHECK(lends_question<word_reading>);
STATIC_CHECK(lends_question<reading<value_of<rfr>>>);
STATIC_CHECK(lends_question<poller<read_plan<device, rfr>>>);
STATIC_CHECK(lends_question<plan_writer<write_plan<device, acc>>>);

template <typename T> constexpr bool has_latest = requires(T&& talk)
{
    std::forward<T>(talk).latest();
};
using panel = poller<read_plan<device, rfr>>;
STATIC_CHECK(has_latest<panel&>and has_latest<panel const&>);
STATIC_CHECK(not has_latest<panel> and not has_latest<panel const>);

template <typename T> constexpr bool has_ask = requires(T&& line, read_holding_registers question)
{
    std::forward<T>(line).ask(unit_id{1}, question);
};
STATIC_CHECK(has_ask<blocking_client<posix_serial>&>);
STATIC_CHECK(not has_ask<blocking_client<posix_serial>>);

} // namespace
