// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What happens while clients are served: words on the error output, or JSON objects on standard output, or what another
// program makes of it. Nothing of it makes a client wait.
#pragma once

#include <string>
#include <string_view>

#include "output/output.hpp"

namespace tool {

class serve_events {
public:
    explicit serve_events(output_form form) : is_json_{form == output_form::json} {}
    serve_events(serve_events const&) = delete;
    serve_events& operator=(serve_events const&) = delete;
    virtual ~serve_events() = default;

    /// For programs alone.
    virtual void note(std::string_view event, record const& more, std::string const& text) const;
    /// For people, too.
    virtual void tell(std::string_view event, record const& more, std::string const& text) const;
    /// On standard output in either form, at once: what a script waits for.
    void begin(record const& more, std::string const& text) const;

private:
    bool is_json_;
};

} // namespace tool
