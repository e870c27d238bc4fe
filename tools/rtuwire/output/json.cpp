// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One JSON object a line.
#include <nlohmann/json.hpp>

#include "output/output.hpp"
#include "output/plain_text.hpp"

namespace tool {

namespace {

struct to_json {
    nlohmann::ordered_json operator()(std::monostate) const { return nullptr; }
    template <typename Value> nlohmann::ordered_json operator()(Value const& value) const { return value; }
};

class json : public form {
public:
    std::string text_of(record const& line) override
    {
        nlohmann::ordered_json object = nlohmann::ordered_json::object();
        for (field const& each : line.fields()) {
            object[each.name] = std::visit(to_json{}, each.value);
        }
        // Bytes that are no UTF-8 (a device may name itself anyhow) are replaced, not a reason to fail.
        return plain_json(object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) + '\n';
    }
};

} // namespace

std::unique_ptr<form> make_json() { return std::make_unique<json>(); }

} // namespace tool
