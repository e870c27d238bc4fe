// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Names and values by a register file.
#pragma once

#include <map>
#include <utility>

#include "frame/register_names.hpp"
#include "words/named_places.hpp"

namespace tool {

/// What the file says must outlive it.
class names_by_file final : public register_names {
public:
    explicit names_by_file(named_places const& said);

    std::string name_at(register_space space, unsigned address) const override;
    std::vector<passed_value> values_at(register_space space, unsigned address,
                                        std::span<std::uint16_t const> words) const override;

private:
    /// By each address that a place has.
    std::multimap<std::pair<register_space, unsigned>, named_place const*> places_{};
};

} // namespace tool
