// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Ends the wait of the thread that publishes: by a line that has news, or a signal.
#pragma once

namespace tool::gateway {

class wake_up {
public:
    wake_up();
    wake_up(wake_up const&) = delete;
    wake_up& operator=(wake_up const&) = delete;
    ~wake_up();

    /// To be waited for by poll; negative where there is none.
    [[nodiscard]] int descriptor() const noexcept { return descriptor_; }
    /// From any thread, and from a signal's handler.
    void ring() const noexcept;
    /// Waits for the next one from here on.
    void hear() const noexcept;

private:
    int descriptor_;
};

} // namespace tool::gateway
