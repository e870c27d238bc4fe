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
    auto const may_be_taken = [&](auto const& each) { return not is_left_alone(each.second.front().unit, now); };
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

std::optional<serve_time> request_queue::next_turn() const
{
    std::optional<serve_time> next;
    for (auto const& [client, own] : waiting_) {
        serve_time const at = free_from(own.front().unit);
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
