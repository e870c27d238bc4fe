// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "serve/metrics_page.hpp"

namespace tool {

namespace {

std::string response(std::string_view status, std::string_view type, std::string const& body,
                     std::string_view more = {})
{
    return "HTTP/1.1 " + std::string{status} + "\r\nContent-Type: " + std::string{type} +
           "\r\nContent-Length: " + std::to_string(body.size()) + "\r\nConnection: close\r\n" + std::string{more} +
           "\r\n" + body;
}

std::string refusal_of(std::string_view status, std::string_view more = {})
{
    return response(status, "text/plain; charset=utf-8", std::string{status} + "\nthere is only GET /metrics here\n",
                    more);
}

} // namespace

std::optional<std::string> http_response(std::string_view came, std::function<std::string()> const& metrics)
{
    bool const is_whole = came.find("\r\n\r\n") != came.npos or came.find("\n\n") != came.npos;
    if (not is_whole) {
        return came.size() < longest_http_request ? std::nullopt
                                                  : std::optional{refusal_of("431 Request Header Fields Too Large")};
    }
    std::string_view const line = came.substr(0, came.find_first_of("\r\n"));
    std::size_t const method = line.find(' ');
    std::size_t const end = method == line.npos ? line.npos : line.find(' ', method + 1);
    if (end == line.npos or not line.substr(end + 1).starts_with("HTTP/1.")) {
        return refusal_of("400 Bad Request");
    }
    if (line.substr(0, method) != "GET") {
        return refusal_of("405 Method Not Allowed", "Allow: GET\r\n");
    }
    std::string_view const target = line.substr(method + 1, end - method - 1);
    if (target.substr(0, target.find('?')) != "/metrics") {
        return refusal_of("404 Not Found");
    }
    return response("200 OK", "text/plain; version=0.0.4; charset=utf-8", metrics());
}

} // namespace tool
