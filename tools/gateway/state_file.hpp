// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a gateway knows beyond its end: a file of its state folder, an object of JSON with a member for each gateway that shares
// the folder.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace tool::gateway {

class state_file {
public:
    /// `owner`: the gateway's file. Makes the folder where there is none.
    state_file(std::string folder, std::string_view name, std::string owner);

    /// What this gateway has noted; null where it has noted nothing, or where `is_right` takes it for damaged. What is damaged is
    /// kept in a file beside it.
    [[nodiscard]] nlohmann::json read(bool (*is_right)(nlohmann::json const& own));
    /// In place of that, on the disk when this returns; null: nothing. Why it is not; empty where it is.
    [[nodiscard]] std::string write(nlohmann::json const& own);

    /// Why it could not be read; empty where it was, or is not there yet.
    [[nodiscard]] std::string const& failure() const { return failure_; }
    /// What was found damaged since the last call, a sentence; empty where nothing was.
    [[nodiscard]] std::string take_damage();

private:
    nlohmann::json read_all();
    void put_aside(std::string const& text, std::string const& why);

    std::string folder_;
    std::string path_;
    std::string owner_;
    std::string failure_{};
    std::string damage_{};
};

} // namespace tool::gateway
