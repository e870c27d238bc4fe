// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A conversation that tells what it is asked and told, and the two engines that run it.
#pragma once

#include <memory>
#include <optional>

#include <rtuwire/client/bus.hpp>
#include <rtuwire/client/client.hpp>

#include "frames.hpp"
#include "setting.hpp"

namespace rtuwire::simulation {

class conversation_on_trial;

/// Who is told what a conversation does.
class witness {
public:
    virtual void given(conversation_on_trial& by) = 0;
    virtual void accepted(conversation_on_trial& by, result<response> const& outcome) = 0;

protected:
    ~witness() = default;
};

/// A conversation of one request at a time.
class conversation_on_trial : public asker {
public:
    explicit conversation_on_trial(witness& seen_by) : witness_{&seen_by} {}
    conversation_on_trial(conversation_on_trial const&) = default;
    conversation_on_trial& operator=(conversation_on_trial const&) = default;
    /// Whoever still reads the request of one that is gone sends this.
    ~conversation_on_trial() { request_.fill(std::byte{0xDD}); }

    void begin(std::uint32_t number, frame const& request, bool may_repeat)
    {
        if (wants) {
            forget();
        }
        inquiry = number;
        request_ = request;
        again_ = may_repeat ? repetition::allowed : repetition::never;
        wants = true;
        was_given = false;
    }

    /// May be called again before the request is taken: the client copies it only then.
    std::optional<request_frame> next()
    {
        if (not wants) {
            return std::nullopt;
        }
        was_given = true;
        witness_->given(*this);
        return request_frame{request_.view(), again_};
    }
    void give_up()
    {
        forget();
        wants = was_given = false;
    }
    void accept(result<response> const& outcome) { witness_->accepted(*this, outcome); }
    bool settled() const { return not wants; }

    std::uint32_t inquiry{0};
    bool wants{false};
    bool was_given{false};

private:
    witness* witness_;
    frame request_{};
    repetition again_{repetition::allowed};
};

/// The two engines behind one face.
class engine {
public:
    virtual ~engine() = default;
    virtual void receive(byte_view bytes, instant now) = 0;
    virtual void receive_error(instant now) = 0;
    virtual void sent(instant at) = 0;
    virtual void advance(instant now) = 0;
    virtual void converse(std::size_t index, conversation_on_trial& with, instant now) = 0;
    virtual byte_view poll_transmit() = 0;
    virtual deadline poll_deadline() const = 0;
    virtual void cancel(instant now) = 0;
};

template <typename Engine> class engine_of : public engine {
public:
    engine_of(line_timing const& line, client_options const& options) : engine_{line, options} {}
    void receive(byte_view bytes, instant now) override { engine_.receive(bytes, now); }
    void receive_error(instant now) override { engine_.receive_error(now); }
    void sent(instant at) override { engine_.sent(at); }
    void advance(instant now) override { engine_.advance(now); }
    void cancel(instant now) override { engine_.cancel(now); }
    byte_view poll_transmit() override { return engine_.poll_transmit(); }
    deadline poll_deadline() const override { return engine_.poll_deadline(); }

protected:
    Engine engine_;
};

template <typename Client> class one_client final : public engine_of<Client> {
public:
    using engine_of<Client>::engine_of;
    void converse(std::size_t, conversation_on_trial& with, instant now) override { this->engine_.converse(with, now); }
};

class one_bus final : public engine_of<bus<setting::most_conversations>> {
public:
    using engine_of::engine_of;
    void converse(std::size_t index, conversation_on_trial& with, instant now) override
    {
        engine_.converse(index, with, now);
    }
};

inline std::unique_ptr<engine> engine_for(setting const& how)
{
    line_timing const line = client_timing_of(how);
    if (how.is_bus) {
        return std::make_unique<one_bus>(line, how.options);
    }
    if (how.is_host) {
        return std::make_unique<one_client<host_client>>(line, how.options);
    }
    return std::make_unique<one_client<client>>(line, how.options);
}

} // namespace rtuwire::simulation
