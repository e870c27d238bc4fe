// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "port/simulated_device.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <rtuwire/server.hpp>

#include "device/register_file.hpp"
#include "words/named_value.hpp"

namespace tool {

namespace {

using rtuwire::errc;

/// The words and bits of a device: those that its file names.
class device_memory {
public:
    explicit device_memory(named_places const& of) : of_{of}
    {
        for (named_place const& each : of.places) {
            for (std::size_t i = 0; i < each.where.size(); ++i) {
                words_.try_emplace(key(each.where.space, each.where.address + i), std::uint16_t{0});
            }
            if (not each.simulated.empty()) {
                set(each, each.simulated);
            }
        }
    }

    named_places const& names() const noexcept { return of_; }

    std::uint16_t get(register_space space, std::size_t address) const { return words_.at(key(space, address)); }
    void set(register_space space, std::size_t address, std::uint16_t word) { words_.at(key(space, address)) = word; }

    /// The value of a name; of some bits of a register these alone change.
    void set(named_place const& named, std::vector<std::uint16_t> const& words)
    {
        unsigned const mask = named.where.mask();
        for (std::size_t i = 0; i < words.size(); ++i) {
            std::uint16_t& held = words_.at(key(named.where.space, named.where.address + i));
            held = static_cast<std::uint16_t>((held & ~mask) | (words[i] & mask));
        }
    }

    std::vector<std::uint16_t> words_of(named_place const& named) const
    {
        std::vector<std::uint16_t> words;
        for (std::size_t i = 0; i < named.where.size(); ++i) {
            words.push_back(get(named.where.space, named.where.address + i));
        }
        return words;
    }

    errc check_read(register_space space, std::size_t start, std::size_t count) const
    {
        for (std::size_t i = 0; i < count; ++i) {
            if (not words_.contains(key(space, start + i))) {
                return errc::illegal_data_address;
            }
        }
        return errc::none;
    }

    /// First that all are there and may be written, then what each value would be.
    errc check_write(register_space space, std::size_t start, std::vector<std::uint16_t> const& words) const
    {
        errc wrong = check_read(space, start, words.size());
        for (named_place const& each : of_.places) {
            bool const is_met = each.where.space == space and each.where.address < start + words.size() and
                                start < each.where.address + each.where.size();
            // Bits stay beside others of their register that change.
            bool const stays =
                is_met and each.where.bit >= 0 and
                ((words[each.where.address - start] ^ get(space, each.where.address)) & each.where.mask()) == 0;
            if (not is_met or stays) {
                continue;
            }
            if (not each.is_writable) {
                return errc::illegal_data_address;
            }
            wrong = wrong == errc::none and not may_become(each, start, words) ? errc::illegal_data_value : wrong;
        }
        return wrong;
    }

private:
    using place_key = std::pair<register_space, std::size_t>;
    static place_key key(register_space space, std::size_t address) { return {space, address}; }

    bool may_become(named_place const& named, std::size_t start, std::vector<std::uint16_t> const& words) const
    {
        std::vector<std::uint16_t> wanted = words_of(named);
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            std::size_t const at = named.where.address + i;
            wanted[i] = at >= start and at < start + words.size() ? words[at - start] : wanted[i];
        }
        return why_not_written(named, wanted).empty();
    }

    named_places const& of_;
    std::map<place_key, std::uint16_t> words_{};
};

/// Holding or input registers, as a server asks for them.
class word_space {
public:
    word_space(device_memory& memory, register_space space) : memory_{memory}, space_{space} {}

    errc check_read(std::uint16_t start, std::size_t count) const noexcept
    {
        std::size_t const most = memory_.names().max_registers.value_or(rtuwire::max_read_quantity);
        return count > most ? errc::illegal_data_value : memory_.check_read(space_, start, count);
    }
    errc check_write(std::uint16_t start, rtuwire::register_view values) const
    {
        return memory_.check_write(space_, start, words_of(values));
    }
    errc read(std::uint16_t start, std::size_t count, rtuwire::byte_writer& out)
    {
        for (std::size_t i = 0; i < count; ++i) {
            out.u16(memory_.get(space_, start + i));
        }
        return errc::none;
    }
    errc write(std::uint16_t start, rtuwire::register_view values)
    {
        std::vector<std::uint16_t> const words = words_of(values);
        for (std::size_t i = 0; i < words.size(); ++i) {
            memory_.set(space_, start + i, words[i]);
        }
        return errc::none;
    }

private:
    static std::vector<std::uint16_t> words_of(rtuwire::register_view values)
    {
        std::vector<std::uint16_t> words;
        for (std::size_t i = 0; i < values.size(); ++i) {
            words.push_back(values[i]);
        }
        return words;
    }

    device_memory& memory_;
    register_space space_;
};

/// Coils or discrete inputs.
class bit_space {
public:
    bit_space(device_memory& memory, register_space space) : memory_{memory}, space_{space} {}

    errc check_read(std::uint16_t start, std::size_t count) const { return memory_.check_read(space_, start, count); }
    errc check_write(std::uint16_t start, rtuwire::bit_view values) const
    {
        return memory_.check_write(space_, start, words_of(values));
    }
    errc read(std::uint16_t start, std::size_t count, rtuwire::byte_span out)
    {
        for (std::size_t i = 0; i < count; ++i) {
            unsigned const bit = memory_.get(space_, start + i);
            out[i / 8] |= static_cast<std::byte>(bit << (i % 8));
        }
        return errc::none;
    }
    errc write(std::uint16_t start, rtuwire::bit_view values)
    {
        for (std::size_t i = 0; i < values.size(); ++i) {
            memory_.set(space_, start + i, values[i] ? 1 : 0);
        }
        return errc::none;
    }

private:
    static std::vector<std::uint16_t> words_of(rtuwire::bit_view values)
    {
        std::vector<std::uint16_t> words;
        for (std::size_t i = 0; i < values.size(); ++i) {
            words.push_back(values[i] ? 1 : 0);
        }
        return words;
    }

    device_memory& memory_;
    register_space space_;
};

/// All four spaces.
class device_bank : public word_space {
public:
    explicit device_bank(device_memory& memory)
        : word_space{memory, register_space::holding}, inputs_{memory, register_space::input},
          coils_{memory, register_space::coil}, discrete_{memory, register_space::discrete}
    {}

    word_space& input_registers() noexcept { return inputs_; }
    bit_space& coils() noexcept { return coils_; }
    bit_space& discrete_inputs() noexcept { return discrete_; }

private:
    word_space inputs_;
    bit_space coils_;
    bit_space discrete_;
};

using device_server = rtuwire::server::with<rtuwire::function_list<
    rtuwire::read_coils, rtuwire::read_discrete_inputs, rtuwire::read_holding_registers, rtuwire::read_input_registers,
    rtuwire::write_single_coil, rtuwire::write_single_register, rtuwire::diagnostics<>, rtuwire::write_multiple_coils<>,
    rtuwire::write_multiple_registers<>, rtuwire::mask_write_register, rtuwire::read_write_multiple_registers<>,
    rtuwire::read_device_identification>>;

/// The functions of the spaces that a file has, and 08; 43 where it says who made it.
rtuwire::function_set functions_of(named_places const& of)
{
    using rtuwire::function_code;
    auto const when = [&of](register_space space, function_code code) {
        auto const is_there = [space](named_place const& each) { return each.where.space == space; };
        return std::ranges::any_of(of.places, is_there) ? code : function_code{};
    };
    return rtuwire::function_set{function_code::diagnostics,
                                 when(register_space::holding, function_code::read_holding_registers),
                                 when(register_space::holding, function_code::write_single_register),
                                 when(register_space::holding, function_code::write_multiple_registers),
                                 when(register_space::holding, function_code::mask_write_register),
                                 when(register_space::holding, function_code::read_write_multiple_registers),
                                 when(register_space::input, function_code::read_input_registers),
                                 when(register_space::coil, function_code::read_coils),
                                 when(register_space::coil, function_code::write_single_coil),
                                 when(register_space::coil, function_code::write_multiple_coils),
                                 when(register_space::discrete, function_code::read_discrete_inputs),
                                 of.vendor.empty() ? function_code{} : function_code::encapsulated_interface};
}

class device_of_file final : public simulated_drive {
public:
    device_of_file(named_places const& of, rtuwire::unit_id unit, rtuwire::line_timing const& timing)
        : unit_{unit}, memory_{of}, bank_{memory_}, profile_{functions_of(of), limits_of(of), identity_of(of)},
          server_{unit, timing, profile_}
    {}

    void receive(rtuwire::byte_view bytes, rtuwire::instant now) override
    {
        if (not is_cut_off_) {
            server_.receive(bytes, now);
        }
    }
    void receive_error(rtuwire::instant now) override
    {
        if (not is_cut_off_) {
            server_.receive_error(now);
        }
    }
    void sent(rtuwire::instant now) override { server_.sent(now); }
    void advance(rtuwire::instant now) override
    {
        server_.advance(now);
        if (server_.is_asked()) {
            server_.serve(bank_, now);
        }
    }
    rtuwire::byte_view poll_transmit() override { return is_mute_ ? rtuwire::byte_view{} : server_.poll_transmit(); }
    rtuwire::deadline poll_deadline() const override { return server_.poll_deadline(); }
    rtuwire::unit_id address() const override { return unit_; }
    bool is_at_rest() const override { return true; }

    std::string shown() const override
    {
        std::string all;
        for (named_place const& each : memory_.names().places) {
            all += (all.empty() ? "" : ", ") + each.where.name + ' ' + value_of(each, memory_.words_of(each)).text;
        }
        return all;
    }

    /// "voltage_l1=230.1V", whatever may be written and within which limits; "cut" and the like.
    bool suffer(std::string const& what, rtuwire::instant) override
    {
        if (what == "cut" or what == "join" or what == "deaf" or what == "mute") {
            is_cut_off_ = what == "cut" or what == "deaf";
            is_mute_ = what == "cut" or what == "mute";
            return true;
        }
        std::size_t const equals = what.find('=');
        named_place const* const named = memory_.names().by_name(what.substr(0, equals));
        if (equals == what.npos or named == nullptr) {
            why_not_.clear();
            return false;
        }
        words_typed const typed = words_to_hold(*named, std::string_view{what}.substr(equals + 1));
        why_not_ = typed.wrong;
        if (why_not_.empty()) {
            memory_.set(*named, typed.words);
        }
        return why_not_.empty();
    }

    std::string understood() const override
    {
        return why_not_.empty() ? "UNIT show|NAME=VALUE|cut|deaf|mute|join" : why_not_;
    }

private:
    static rtuwire::device_limits limits_of(named_places const& of)
    {
        rtuwire::device_limits limits;
        if (of.max_registers) {
            limits.read = *of.max_registers;
            limits.write = std::min(limits.write, *of.max_registers);
            limits.exchange_read = limits.read;
            limits.exchange_write = std::min(limits.exchange_write, *of.max_registers);
        }
        return limits;
    }

    rtuwire::device_objects identity_of(named_places const& of)
    {
        rtuwire::byte_writer out{identity_};
        std::uint8_t id = rtuwire::vendor_name;
        for (std::string_view const text :
             {std::string_view{of.vendor}, std::string_view{of.product}, simulated_revision}) {
            out.u8(id++);
            out.u8(static_cast<std::uint32_t>(text.size()));
            for (char const letter : text) {
                out.u8(static_cast<std::uint8_t>(letter));
            }
        }
        auto const made = rtuwire::device_objects::from(out.written());
        return made and not of.vendor.empty() ? *made : rtuwire::device_objects{};
    }

    static constexpr std::string_view simulated_revision = "simulated";

    rtuwire::unit_id unit_;
    std::array<std::byte, rtuwire::max_adu_size> identity_{};
    device_memory memory_;
    device_bank bank_;
    rtuwire::server_profile profile_;
    device_server server_;
    std::string why_not_{};
    bool is_cut_off_{false};
    bool is_mute_{false};
};

} // namespace

std::unique_ptr<simulated_drive> simulated_device(simulated_drive_choice const& choice,
                                                  rtuwire::line_timing const& timing)
{
    auto const unit = rtuwire::unit_id::checked(choice.unit);
    if (not unit) {
        throw usage_error{"unit " + std::to_string(choice.unit) + " is out of range: 1 to 247"};
    }
    return std::make_unique<device_of_file>(register_file_at(choice.drive), *unit, timing);
}

} // namespace tool
