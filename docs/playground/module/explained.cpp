// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "explained.hpp"

#include <optional>

#include <rtuwire/frames.hpp>

#include "frame/hex_text.hpp"

namespace playground {

namespace {

std::optional<unsigned> digit_of(char letter)
{
    constexpr std::string_view digits = "0123456789abcdef";
    auto const low = static_cast<char>(letter >= 'A' and letter <= 'F' ? letter - 'A' + 'a' : letter);
    std::size_t const at = digits.find(low);
    return at == digits.npos ? std::nullopt : std::optional{static_cast<unsigned>(at)};
}

/// Letters and digits of any writing: what is none of ours is no byte.
bool is_word_character(char letter)
{
    bool const is_foreign = static_cast<unsigned char>(letter) > 0x7F;
    return is_foreign or (letter >= '0' and letter <= '9') or (letter >= 'a' and letter <= 'z') or
           (letter >= 'A' and letter <= 'Z');
}

typed_bytes flaw_at(std::size_t at, std::string_view why)
{
    return {.flaw = "character " + std::to_string(at + 1) + ": " + std::string{why}};
}

std::vector<std::byte> with_crc(std::vector<std::byte> bytes)
{
    unsigned const crc = rtuwire::crc16(bytes);
    bytes.push_back(static_cast<std::byte>(crc & 0xFFU));
    bytes.push_back(static_cast<std::byte>(crc >> 8U));
    return bytes;
}

bool is_good_frame(std::vector<std::byte> const& bytes, tool::drive_catalog const& drive)
{
    tool::names_by_drive const names{drive};
    auto const frames = tool::frame_decoder{&names}.decode(bytes);
    return frames.size() == 1 and frames[0].is_good() and frames[0].readings[0].flaw.empty();
}

/// What typed bytes are, and the frame that is offered instead where its CRC is missing or wrong.
struct judgement {
    std::string_view kind;
    std::vector<std::byte> offer{};
};

judgement judge(std::vector<std::byte> const& bytes, tool::drive_catalog const& drive)
{
    constexpr std::size_t crc_size = 2;
    if (is_good_frame(bytes, drive)) {
        return {"good"};
    }
    if (auto offer = with_crc(bytes); is_good_frame(offer, drive)) {
        return {"crc missing", std::move(offer)};
    }
    if (bytes.size() >= rtuwire::min_adu_size) {
        auto offer = with_crc({bytes.begin(), bytes.end() - crc_size});
        if (is_good_frame(offer, drive)) {
            return {"crc wrong", std::move(offer)};
        }
    }
    return {"not a frame"};
}

} // namespace

void put_frame(json_text& to, tool::decoded_frame const& frame)
{
    to.open_object();
    to.put("hex", tool::hex_of(frame.bytes));
    to.put("crc", frame.has_right_crc);
    to.put("whole", frame.is_whole);
    to.open_list("readings");
    for (auto const& reading : frame.readings) {
        to.open_object();
        to.put("as", reading.as);
        to.put("flaw", reading.flaw);
        to.open_list("fields");
        for (auto const& field : reading.fields) {
            to.open_object();
            to.put("offset", field.offset);
            to.put("length", field.length);
            to.put("name", field.name);
            to.put("value", field.value);
            to.close_object();
        }
        to.close_list();
        to.close_object();
    }
    to.close_list();
    to.close_object();
}

typed_bytes read_typed(std::string_view text)
{
    typed_bytes read;
    for (std::size_t at = 0; at < text.size();) {
        if (not is_word_character(text[at])) {
            ++at;
            continue;
        }
        if (std::string_view const sign = text.substr(at, 2); sign == "0x" or sign == "0X") {
            at += sign.size(); // as logs write bytes
            continue;
        }
        auto const high = digit_of(text[at]);
        auto const low = at + 1 < text.size() ? digit_of(text[at + 1]) : std::nullopt;
        if (not high) {
            return flaw_at(at, "not a hexadecimal digit");
        }
        if (not low) {
            return flaw_at(at, "a byte has two digits");
        }
        read.bytes.push_back(static_cast<std::byte>(*high << 4U | *low));
        at += 2;
    }
    if (read.bytes.size() > rtuwire::max_adu_size) {
        return {.flaw = std::to_string(read.bytes.size()) + " bytes: a frame has 256 at most"};
    }
    return read;
}

std::string explain_typed(std::string_view text, tool::drive_catalog const& drive)
{
    typed_bytes const typed = read_typed(text);
    judgement const found = judge(typed.bytes, drive);
    json_text out;
    out.open_object();
    out.put("size", typed.bytes.size());
    out.put("flaw", typed.flaw);
    out.put("kind", found.kind);
    out.put("offer", found.offer.empty() ? std::string{} : tool::hex_of(found.offer));
    out.open_list("frames");
    bool const is_only_without = found.kind == "crc missing";
    tool::names_by_drive const names{drive};
    for (auto const& frame : tool::frame_decoder{&names}.decode(is_only_without ? found.offer : typed.bytes)) {
        put_frame(out, frame);
    }
    out.close_list();
    out.close_object();
    return out.text();
}

} // namespace playground
