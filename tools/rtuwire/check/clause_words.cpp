// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "check/clause_words.hpp"

#include <algorithm>
#include <cctype>

#include "frame/hex_text.hpp"
#include "words/words.hpp"

namespace tool {

namespace {

using rtuwire::byte_view;

/// Splits at blanks that stand in no parentheses.
std::vector<std::string_view> words_in(std::string_view text)
{
    std::vector<std::string_view> words;
    int depth = 0;
    std::size_t from = 0;
    for (std::size_t at = 0; at <= text.size(); ++at) {
        bool const ends = at == text.size() or (text[at] == ' ' and depth == 0);
        depth += at < text.size() and text[at] == '(' ? 1 : at < text.size() and text[at] == ')' ? -1 : 0;
        if (ends) {
            if (at > from) {
                words.push_back(text.substr(from, at - from));
            }
            from = at + 1;
        }
    }
    return words;
}

bool is_hex_byte(std::string_view word)
{
    return word.size() == 2 and std::ranges::all_of(word, [](unsigned char each) { return std::isxdigit(each) != 0; });
}

std::byte hex_byte_of(std::string_view word)
{
    return static_cast<std::byte>(std::stoul(std::string{word}, nullptr, 16));
}

unsigned number_of(std::string_view word, known_places const& where)
{
    if (word.starts_with('(')) {
        word = word.substr(1, word.size() - 2);
    }
    return word == "2*PQ"  ? 2U * where.crc_quantity
           : word == "N-1" ? where.scratch_count - 1
           : word == "RN"  ? where.readable
                           : static_cast<unsigned>(std::stoul(std::string{word}));
}

/// The address that a word names, with what is added to it: "R", "S+1", "XA-1".
std::optional<std::uint16_t> address_of(std::string_view word, known_places const& where)
{
    std::size_t const sign = std::min(word.find_first_of("+-"), word.size());
    std::string_view const name = word.substr(0, sign);
    std::optional<std::uint16_t> const last_scratch =
        where.scratch ? std::optional{static_cast<std::uint16_t>(*where.scratch + where.scratch_count - 1U)}
                      : std::nullopt;
    struct named {
        std::string_view name;
        std::optional<std::uint16_t> value;
    };
    named const all[]{{"R", where.holding},
                      {"RI", where.input},
                      {"RC", where.coil},
                      {"RD", where.discrete},
                      {"S", where.scratch},
                      {"SC", where.scratch_coil},
                      {"SE", last_scratch},
                      {"XA", where.behind_holding},
                      {"XC", where.behind_coil},
                      {"PA", where.crc_address},
                      {"PQ", where.crc_address ? std::optional{where.crc_quantity} : std::nullopt}};
    named const* const found = std::ranges::find(all, name, &named::name);
    if (found == std::end(all)) {
        return std::nullopt;
    }
    if (not found->value) {
        throw unknown_place{std::string{name}};
    }
    int const more = sign == word.size() ? 0 : std::stoi(std::string{word.substr(sign)});
    return static_cast<std::uint16_t>(*found->value + more);
}

void add_word(line_bytes& bytes, std::uint16_t value)
{
    bytes.push_back(static_cast<std::byte>(value >> 8U));
    bytes.push_back(static_cast<std::byte>(value & 0xFFU));
}

/// What a word stands for that is the same in what is sent and in what comes; nothing of others.
std::optional<line_bytes> plain_bytes(std::string_view word, known_places const& where)
{
    if (is_hex_byte(word)) {
        return line_bytes{hex_byte_of(word)};
    }
    if (word == "U" or word == "V") {
        return line_bytes{std::byte{word == "U" ? where.unit : where.other}};
    }
    if (word.starts_with("B(")) {
        return line_bytes{static_cast<std::byte>(number_of(word.substr(1), where))};
    }
    if (word == "READ") {
        return plain_read(where);
    }
    if (auto const address = address_of(word, where)) {
        line_bytes bytes;
        add_word(bytes, *address);
        return bytes;
    }
    return std::nullopt;
}

/// What is sent, word by word.
class sentence {
public:
    explicit sentence(known_places const& where) : where_{where} {}

    void take(std::string_view word)
    {
        std::size_t const star = word.find('*');
        if (word == ";") {
            end_frame();
        } else if (word.starts_with('~')) {
            take_silence(word.substr(1));
        } else if (word.starts_with('!')) {
            changes_.push_back(word);
        } else if (word.starts_with("CRC") or word == "SWAP") {
            take_crc(word);
        } else if (star != word.npos and not word.starts_with("B(")) {
            take_repeated(word.substr(0, star), number_of(word.substr(star + 1), where_));
        } else if (auto const bytes = plain_bytes(word, where_)) {
            add(*bytes);
        } else {
            throw std::logic_error{"'" + std::string{word} + "' is no word of a clause"};
        }
    }

    std::vector<sent_piece> pieces()
    {
        end_frame();
        return pieces_;
    }

private:
    void add(line_bytes const& bytes)
    {
        pieces_.back().bytes.insert(pieces_.back().bytes.end(), bytes.begin(), bytes.end());
        frame_.insert(frame_.end(), bytes.begin(), bytes.end());
    }

    void take_silence(std::string_view word)
    {
        bool const is_time = word.ends_with("ms");
        sent_piece next;
        (is_time ? static_cast<void>(next.ms = static_cast<unsigned>(std::stoul(std::string{word})))
                 : static_cast<void>(next.characters = std::stod(std::string{word})));
        pieces_.push_back(next);
    }

    void take_repeated(std::string_view what, unsigned times)
    {
        bool const is_group = what.starts_with('(');
        std::vector<std::string_view> const words = words_in(is_group ? what.substr(1, what.size() - 2) : what);
        for (unsigned i = 0; i < times; ++i) {
            for (std::string_view const each : words) {
                take(each);
            }
        }
    }

    void take_crc(std::string_view word)
    {
        line_bytes of = frame_;
        if (word == "CRC@V" and not of.empty()) {
            of.front() = std::byte{where_.other};
        } else if (word.starts_with("CRC(")) {
            of = bytes_of(pieces_of(word.substr(4, word.size() - 5), where_));
        }
        line_bytes crc = crc_of(of);
        if (word == "SWAP") {
            std::ranges::reverse(crc);
        }
        add(crc);
    }

    /// Changes its bytes where they stand.
    void end_frame()
    {
        for (std::string_view const each : changes_) {
            std::size_t const hat = each.find('^');
            std::size_t index = begin_ + std::stoul(std::string{each.substr(1, hat - 1)});
            for (sent_piece& piece : pieces_) {
                if (index < piece.bytes.size()) {
                    piece.bytes[index] ^= hex_byte_of(each.substr(hat + 1));
                    break;
                }
                index -= piece.bytes.size();
            }
        }
        changes_.clear();
        begin_ += frame_.size();
        frame_.clear();
    }

    known_places const& where_;
    std::vector<sent_piece> pieces_{1};
    line_bytes frame_{};
    std::size_t begin_{0}; ///< of the frame, in all bytes
    std::vector<std::string_view> changes_{};
};

/// An answer that is held against words, from its begin on.
class held_answer {
public:
    held_answer(line_bytes const& came, line_bytes const& asked, known_places const& where)
        : came_{came}, asked_{asked}, where_{where}
    {}

    bool is(std::string_view words)
    {
        at_ = begin_ = 0;
        std::vector<std::string_view> const all = words_in(words);
        return std::ranges::all_of(all, [this](std::string_view word) { return takes(word); }) and at_ == came_.size();
    }

private:
    bool takes(std::string_view word)
    {
        std::size_t const star = word.find('*');
        if (word.starts_with("??")) {
            return skip(star == word.npos ? 1 : number_of(word.substr(star + 1), where_));
        }
        if (word == "CRC") {
            line_bytes const crc = crc_of(byte_view{came_}.subspan(begin_, at_ - begin_));
            bool const fits = takes_bytes(crc);
            begin_ = at_;
            return fits;
        }
        if (word == "OK1" or word == "OK2") {
            std::size_t const registers = word == "OK1" ? 1 : 2;
            return takes_bytes(
                       {std::byte{where_.unit}, where_.read_function, static_cast<std::byte>(2 * registers)}) and
                   skip(2 * registers) and takes("CRC");
        }
        if (word == "ECHO") {
            bool const fits = takes_bytes(asked_);
            begin_ = at_;
            return fits;
        }
        if (word == "TEXT") {
            return at_ < came_.size() and skip(1 + std::to_integer<std::size_t>(came_[at_]));
        }
        return word == "IDENT" ? takes_identification() : word == "FIFO" ? takes_queue() : takes_plain(word);
    }

    bool takes_plain(std::string_view word)
    {
        std::optional<line_bytes> const bytes = plain_bytes(word, where_);
        if (not bytes) {
            throw std::logic_error{"'" + std::string{word} + "' is no word of an answer"};
        }
        return takes_bytes(*bytes);
    }

    bool takes_bytes(line_bytes const& bytes)
    {
        bool const fits = came_.size() - at_ >= bytes.size() and
                          std::equal(bytes.begin(), bytes.end(), came_.begin() + static_cast<std::ptrdiff_t>(at_));
        at_ += fits ? bytes.size() : 0;
        return fits;
    }

    bool skip(std::size_t count)
    {
        bool const fits = came_.size() - at_ >= count;
        at_ += fits ? count : 0;
        return fits;
    }

    /// Unit, 2B 0E, the code that was asked, level, more, next, count, objects.
    bool takes_identification()
    {
        if (asked_.size() < 4 or
            not takes_bytes({std::byte{where_.unit}, std::byte{0x2B}, std::byte{0x0E}, asked_[3]}) or not skip(4)) {
            return false;
        }
        std::size_t const count = std::to_integer<std::size_t>(came_[at_ - 1]);
        for (std::size_t i = 0; i < count; ++i) {
            if (not skip(1) or not takes("TEXT")) {
                return false;
            }
        }
        return takes("CRC");
    }

    bool takes_queue()
    {
        std::size_t const head = at_ + 2;
        if (not takes_bytes({std::byte{where_.unit}, std::byte{0x18}}) or not skip(4)) {
            return false;
        }
        auto const word = [&](std::size_t at) {
            return std::to_integer<unsigned>(came_[at]) << 8U | std::to_integer<unsigned>(came_[at + 1]);
        };
        unsigned const count = word(head + 2);
        return word(head) == 2 + 2 * count and count <= 31 and skip(2 * count) and takes("CRC");
    }

    line_bytes const& came_;
    line_bytes const& asked_;
    known_places const& where_;
    std::size_t at_{0};
    std::size_t begin_{0}; ///< of the frame
};

/// An exception without its high bit, or with a byte more behind its code, is the one that it means: one clause judges its form.
bool means_exception(std::string_view words, line_bytes const& came, known_places const& where)
{
    std::vector<std::string_view> const all = words_in(words);
    if (all.size() != 4 or all[0] != "U" or all[3] != "CRC" or not is_hex_byte(all[1]) or not is_hex_byte(all[2]) or
        came.size() < 5 or came.size() > 6 or
        crc_of(byte_view{came}.first(came.size() - 2)) != line_bytes{came.end() - 2, came.end()}) {
        return false;
    }
    std::byte const function = hex_byte_of(all[1]);
    constexpr std::byte high{0x80};
    return (function & high) != std::byte{0} and came[0] == std::byte{where.unit} and (came[1] | high) == function and
           came[2] == hex_byte_of(all[2]);
}

} // namespace

std::vector<std::string_view> steps_of(std::string_view text) { return parts_of(text, " / "); }

line_bytes crc_of(byte_view bytes)
{
    unsigned const crc = rtuwire::crc16(bytes);
    return {static_cast<std::byte>(crc & 0xFFU), static_cast<std::byte>(crc >> 8U)};
}

line_bytes framed(line_bytes frame)
{
    line_bytes const crc = crc_of(frame);
    frame.insert(frame.end(), crc.begin(), crc.end());
    return frame;
}

std::string shown(line_bytes const& bytes)
{
    constexpr std::size_t most = 40;
    return bytes.empty() ? "nothing"
           : bytes.size() <= most
               ? hex_of(bytes)
               : hex_of(byte_view{bytes}.first(most)) + " ... (" + std::to_string(bytes.size()) + " bytes)";
}

bool has_right_crc(line_bytes const& frame)
{
    return frame.size() >= 4 and
           crc_of(byte_view{frame}.first(frame.size() - 2)) == line_bytes{frame.end() - 2, frame.end()};
}

line_bytes plain_read(known_places const& where)
{
    std::optional<std::uint16_t> const from = where.read_function == std::byte{3} ? where.holding : where.input;
    if (not from) {
        throw unknown_place{"READ"};
    }
    line_bytes frame{std::byte{where.unit}, where.read_function};
    add_word(frame, *from);
    add_word(frame, 1);
    return framed(frame);
}

line_bytes bytes_of(std::vector<sent_piece> const& pieces)
{
    line_bytes all;
    for (sent_piece const& each : pieces) {
        all.insert(all.end(), each.bytes.begin(), each.bytes.end());
    }
    return all;
}

std::vector<sent_piece> pieces_of(std::string_view step, known_places const& where)
{
    sentence all{where};
    for (std::string_view const each : words_in(step)) {
        all.take(each);
    }
    return all.pieces();
}

bool is_allowed(std::string_view answers, line_bytes const& came, line_bytes const& asked, line_bytes const& before,
                known_places const& where)
{
    held_answer answer{came, asked, where};
    std::vector<std::string_view> const all = parts_of(answers, " or ");
    return std::ranges::any_of(all, [&](std::string_view each) {
        return each == "-"                            ? came.empty()
               : each == "any"                        ? true
               : each == "the same as the one before" ? came == before
                                                      : answer.is(each) or means_exception(each, came, where);
    });
}

} // namespace tool
