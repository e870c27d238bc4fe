// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "serve/request_queue.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace tool {

bool request_queue::add(served_request request)
{
    auto const own = waiting_.find(request.client);
    if (size_ >= most or (own != waiting_.end() and own->second.size() >= most_of_client)) {
        return false;
    }
    waiting_[request.client].push_back(std::move(request));
    ++size_;
    return true;
}

void request_queue::drop(std::uint64_t client)
{
    if (auto const own = waiting_.find(client); own != waiting_.end()) {
        size_ -= own->second.size();
        waiting_.erase(own);
    }
}

std::optional<served_request> request_queue::take(serve_time now)
{
    auto const may_be_taken = [&](auto const& each) { return now >= turn_of(each.second.front()); };
    auto const behind = waiting_.upper_bound(latest_);
    auto next = std::find_if(behind, waiting_.end(), may_be_taken);
    next = next == waiting_.end() ? std::find_if(waiting_.begin(), behind, may_be_taken) : next;
    if (next == waiting_.end() or not may_be_taken(*next)) {
        return std::nullopt;
    }
    latest_ = next->first;
    served_request request = std::move(next->second.front());
    next->second.pop_front();
    --size_;
    if (next->second.empty()) {
        waiting_.erase(next);
    }
    return request;
}

void request_queue::put_back(served_request request)
{
    waiting_[request.client].push_front(std::move(request));
    ++size_;
}

void request_queue::leave_alone(served_request const& unanswered, serve_time all, serve_time others)
{
    serve_time& alone = alone_until_[unanswered.unit];
    alone = std::max(alone, all);
    owed_answer& owed = owed_[{unanswered.unit, unanswered.pdu.front()}];
    owed = {unanswered.pdu, std::max(owed.until, others)};
}

serve_time request_queue::free_from(served_request const& request) const
{
    auto const alone = alone_until_.find(request.unit);
    auto const owed = owed_.find({request.unit, request.pdu.front()});
    // The same again, with the next turn of its client, is answered by either; who asks it anew waits as the others do, or
    // these would wait for ever.
    bool const is_other = owed != owed_.end() and (request.sent == 0 or owed->second.pdu != request.pdu);
    auto const kept = kept_until_.find(request.unit);
    return std::max({alone == alone_until_.end() ? serve_time{} : alone->second,
                     is_other ? owed->second.until : serve_time{},
                     kept == kept_until_.end() ? serve_time{} : kept->second});
}

serve_time request_queue::turn_of(served_request const& request) const
{
    return is_refused_at_once_ and is_refused_at_once_(request.unit) ? serve_time{} : free_from(request);
}

std::optional<serve_time> request_queue::next_turn() const
{
    std::optional<serve_time> next;
    for (auto const& [client, own] : waiting_) {
        serve_time const at = turn_of(own.front());
        next = next ? std::min(*next, at) : at;
    }
    return next;
}

std::vector<served_request> request_queue::take_old(serve_time now)
{
    std::vector<served_request> old;
    for (auto client = waiting_.begin(); client != waiting_.end();) {
        auto& own = client->second;
        if (now - own.front().came < oldest) {
            ++client;
            continue;
        }
        std::ranges::move(own, std::back_inserter(old));
        client = waiting_.erase(client);
    }
    size_ -= old.size();
    return old;
}

std::optional<serve_time> request_queue::next_old() const
{
    std::optional<serve_time> next;
    for (auto const& [client, own] : waiting_) {
        serve_time const at = own.front().came + oldest;
        next = next ? std::min(*next, at) : at;
    }
    return next;
}

} // namespace tool
