// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An RS-485 line behind DMA, an idle-line interrupt and a driver-enable pin, for a server that takes whole
// frames. Two buffers: one for the DMA, one for the loop. Knows no board: what it needs of one are its
// parameters.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include <rtuwire/frames.hpp>

namespace board {

/// Whole frames, in and out. A response is written and sent in the place of its request.
template <typename Dma, typename DriverEnable> class frame_line {
public:
    constexpr frame_line() = default;

    /// Before the first interrupt.
    void begin() { Dma::receive_into(buffers_[filling_]); }

    /// The idle-line interrupt: the line has been silent for t3.5 after a byte. What arrived is handed over,
    /// unless a byte was damaged, or the loop still has the frame before it; then it is dropped.
    void on_idle()
    {
        std::size_t const size = Dma::stop_receiving();
        unsigned const other = 1 - filling_;
        bool const has_place = sizes_[other].load(std::memory_order_acquire) == 0;
        if (Dma::take_damage() or not has_place) {
            dropped_.store(dropped_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
        } else if (size > 0) {
            sizes_[filling_].store(static_cast<std::uint16_t>(size), std::memory_order_release);
            filling_ = other;
        }
        Dma::receive_into(buffers_[filling_]);
    }

    /// The transmitter's interrupt: the last stop bit has left.
    void on_sent()
    {
        DriverEnable::set(false);
        is_sending_.store(false, std::memory_order_release);
    }

    /// A frame that arrived: its place, with room for a response, and its size; 0 where there is none.
    struct arrived {
        rtuwire::byte_span place;
        std::size_t size;
    };
    [[nodiscard]] arrived poll_frame()
    {
        if (is_answering_ and not is_sending_.load(std::memory_order_acquire)) {
            is_answering_ = false;
            release();
        }
        return {buffers_[reading_], is_answering_ ? 0U : sizes_[reading_].load(std::memory_order_acquire)};
    }

    /// Gives the place of the frame back to the DMA.
    void release()
    {
        sizes_[reading_].store(0, std::memory_order_release);
        reading_ = 1 - reading_;
    }

    /// Sends a response, which lies in the place of the frame; the place is given back once it has left. Not
    /// sent where the line is no longer silent: then the client has given up.
    void send(rtuwire::byte_view response)
    {
        bool const is_late = sizes_[1 - reading_].load(std::memory_order_acquire) != 0 or Dma::is_receiving();
        if (is_late) {
            release();
            return;
        }
        is_answering_ = true;
        is_sending_.store(true, std::memory_order_release);
        DriverEnable::set(true);
        Dma::send(response);
    }

    /// Whether the loop may sleep; to be asked with interrupts masked.
    [[nodiscard]] bool is_served() const
    {
        return is_answering_ ? is_sending_.load(std::memory_order_relaxed)
                             : sizes_[reading_].load(std::memory_order_relaxed) == 0;
    }

    /// How many frames were damaged, or came too early.
    [[nodiscard]] unsigned dropped() const { return dropped_.load(std::memory_order_relaxed); }

private:
    // One more than the longest frame, so that a longer one is seen.
    std::array<std::array<std::byte, 257>, 2> buffers_{};
    std::array<std::atomic<std::uint16_t>, 2> sizes_{}; ///< 0: the interrupt's, else the loop's
    std::atomic<unsigned> dropped_{0};
    std::atomic<bool> is_sending_{false};
    unsigned filling_{0}; ///< the interrupt's
    unsigned reading_{0}; ///< the loop's
    bool is_answering_{false};
};

/// A stand-in for two DMA channels and an idle-line detector, which the emulated chips do not have: the UART's
/// interrupt moves each byte, and the clock's interrupt sees the silence. `on_interrupt` and `on_tick` are what a
/// chip with DMA does by itself.
template <typename Uart> class dma_stand_in {
public:
    static void receive_into(rtuwire::byte_span place)
    {
        place_ = place;
        count_ = 0;
    }
    static std::size_t stop_receiving() { return count_; }
    static bool is_receiving() { return count_ > 0; }
    static bool take_damage()
    {
        bool const is_damaged = is_damaged_;
        is_damaged_ = false;
        return is_damaged;
    }
    static void send(rtuwire::byte_view frame)
    {
        rest_ = frame;
        is_sending_.store(true, std::memory_order_release);
        Uart::request_interrupt();
    }

    template <typename Line> static void on_interrupt(Line& line)
    {
        Uart::clear_interrupts();
        while (Uart::has_byte()) {
            auto const got = Uart::take();
            is_damaged_ = is_damaged_ or got.is_damaged or got.is_after_loss;
            silent_ticks_ = 0;
            if (count_ < place_.size()) {
                place_[count_] = got.value;
                count_ = count_ + 1;
            }
        }
        go_on(line);
    }
    template <typename Line> static void on_tick(Line& line)
    {
        if (count_ > 0 and ++silent_ticks_ == idle_ticks) {
            line.on_idle();
        }
        go_on(line);
    }

private:
    // t3.5 is 2 ms at 19 200 bit/s; an emulated UART delivers in lumps.
    static constexpr unsigned idle_ticks = 5;

    template <typename Line> static void go_on(Line& line)
    {
        if (not is_sending_.load(std::memory_order_acquire)) {
            return;
        }
        while (not rest_.empty() and Uart::has_room()) {
            Uart::put(rest_[0]);
            rest_ = rest_.subspan(1);
        }
        if (rest_.empty() and Uart::is_idle()) {
            is_sending_.store(false, std::memory_order_release);
            line.on_sent();
        }
    }

    static inline rtuwire::byte_span place_{};
    static inline std::size_t volatile count_{0};
    static inline unsigned silent_ticks_{0};
    static inline bool is_damaged_{false};
    static inline rtuwire::byte_view rest_{};
    static inline std::atomic<bool> is_sending_{false};
};

} // namespace board
