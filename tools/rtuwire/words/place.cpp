// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "words/place.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <utility>

namespace tool {

namespace {

constexpr unsigned most_scale_digits = 9;
constexpr std::size_t longest_unit = 16;
constexpr std::uint16_t most_characters = 250; ///< 125 registers, as many as a request reads

struct type_word {
    std::string_view word;
    value_type type;
    std::uint16_t registers;
};

// The first of each type is its own name.
constexpr type_word type_words[]{
    {"u16", value_type::u16, 1},     {"uint16", value_type::u16, 1},  {"i16", value_type::i16, 1},
    {"int16", value_type::i16, 1},   {"u32", value_type::u32, 2},     {"uint32", value_type::u32, 2},
    {"i32", value_type::i32, 2},     {"int32", value_type::i32, 2},   {"u64", value_type::u64, 4},
    {"uint64", value_type::u64, 4},  {"i64", value_type::i64, 4},     {"int64", value_type::i64, 4},
    {"f32", value_type::f32, 2},     {"float32", value_type::f32, 2}, {"f64", value_type::f64, 4},
    {"float64", value_type::f64, 4}, {"bcd16", value_type::bcd16, 1}, {"bcd32", value_type::bcd32, 2},
    {"bits", value_type::bits, 1},   {"hex", value_type::hex, 1},
};
constexpr char const* all_types = "u16 i16 u32 i32 u64 i64 f32 f64 bcd16 bcd32 text20 bits hex";

struct space_word {
    std::string_view word;
    std::string_view letter;
    register_space space;
};

constexpr space_word space_words[]{{"holding", "h", register_space::holding},
                                   {"input", "i", register_space::input},
                                   {"coil", "c", register_space::coil},
                                   {"discrete", "d", register_space::discrete}};
constexpr char const* all_spaces = "holding, input, coil, discrete (h, i, c, d) or list";

bool is_letter(char c) noexcept { return (c >= 'a' and c <= 'z') or (c >= 'A' and c <= 'Z'); }

bool begins_with_digit(std::string_view word) noexcept { return not word.empty() and is_digit(word[0]); }

std::optional<unsigned> whole_number(std::string_view text) noexcept
{
    unsigned number = 0;
    auto const [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), number);
    bool const is_whole = begins_with_digit(text) and wrong == std::errc{} and end == text.data() + text.size();
    return is_whole ? std::optional{number} : std::nullopt;
}

bool looks_like_order(std::string_view word) noexcept
{
    return (word.size() == 4 or word.size() == 8) and std::ranges::all_of(word, [](char c) {
               return lower({&c, 1}) <= "h" and is_letter(c);
           });
}

/// Units are shown on screens and in tables: nothing that a shell, a spreadsheet or a template takes for an order.
bool is_of_unit(char c) noexcept
{
    return is_letter(c) or is_digit(c) or static_cast<unsigned char>(c) >= 0x80U or
           std::string_view{"%/^_."}.find(c) != std::string_view::npos;
}

/// The places of a number in a list of five or six digits: 40001 or 400001 the first holding register.
std::optional<place> listed(std::string_view text)
{
    auto const number = text.size() <= 6 ? whole_number(text) : std::nullopt;
    if (not number) {
        return std::nullopt;
    }
    unsigned const size = text.size() == 6 ? 100'000U : 10'000U;
    unsigned const rest = *number % size;
    constexpr std::pair<unsigned, register_space> kinds[]{{0, register_space::coil},
                                                          {1, register_space::discrete},
                                                          {3, register_space::input},
                                                          {4, register_space::holding}};
    auto const kind = std::ranges::find(kinds, *number / size, &std::pair<unsigned, register_space>::first);
    if (kind == std::end(kinds) or rest == 0 or rest > 65'536) {
        return std::nullopt;
    }
    return place{.address = static_cast<std::uint16_t>(rest - 1), .space = kind->second, .is_space_said = true};
}

/// Takes digits, and a point among them, from the front of a text. Refuses none and too many.
std::optional<short_decimal> take_decimal(std::string_view& text) noexcept
{
    short_decimal read;
    unsigned count = 0;
    bool has_point = false;
    for (; not text.empty(); text.remove_prefix(1)) {
        bool const is_point = text[0] == '.' and not has_point and count > 0 and text.size() > 1 and is_digit(text[1]);
        if (not is_point and not is_digit(text[0])) {
            break;
        }
        has_point = has_point or is_point;
        if (not is_point and ++count <= most_scale_digits) {
            read.digits = read.digits * 10 + (text[0] - '0');
            read.places = static_cast<std::uint8_t>(read.places + (has_point ? 1U : 0U));
        }
    }
    return count > 0 and count <= most_scale_digits ? std::optional{read} : std::nullopt;
}

class place_reader {
public:
    explicit place_reader(std::string_view word) noexcept : word_{word} {}

    [[nodiscard]] places_typed run()
    {
        std::string_view rest = word_;
        bool const is_whole = read_space(rest) and read_where(take_part(rest)) and read_forms(rest) and check_form();
        if (is_whole) {
            add_places();
        }
        return std::move(found_);
    }

private:
    bool refuse(std::string kind, std::string const& sentence, std::string nearest = {})
    {
        std::string text = std::string{word_} + ": " + sentence;
        text += nearest.empty() ? "" : "; did you mean " + nearest + "?";
        found_.refused = refusal{std::move(kind), std::string{word_}, std::move(text), std::move(nearest)};
        return false;
    }

    /// The part up to the next colon.
    std::string_view take_part(std::string_view& rest) noexcept
    {
        std::size_t const colon = rest.find(':');
        std::string_view const part = rest.substr(0, colon);
        has_more_ = colon != rest.npos;
        rest.remove_prefix(has_more_ ? colon + 1 : rest.size());
        return part;
    }

    bool read_space(std::string_view& rest)
    {
        if (begins_with_digit(rest)) {
            return true;
        }
        std::string_view const word = take_part(rest);
        is_list_ = is_same_word(word, "list");
        std::vector<std::string_view> known{"list"};
        for (space_word const& each : space_words) {
            known.push_back(each.word);
            if (is_same_word(word, each.word) or is_same_word(word, each.letter)) {
                first_.space = each.space;
                first_.is_space_said = true;
            }
        }
        if (first_.is_space_said or is_list_) {
            return true;
        }
        if (std::ranges::any_of(type_words, [word](auto const& each) { return is_same_word(word, each.word); })) {
            std::string const typed{word};
            return refuse("wrong_place", typed + " is a type, which stands behind the address: 40:" + typed);
        }
        return refuse("wrong_place", '\'' + std::string{word} + "' is no space: say " + all_spaces,
                      std::string{nearest_word(word, known)});
    }

    /// "40", "40-43", "40.3", "40.4-7".
    bool read_where(std::string_view where)
    {
        std::size_t const dot = where.find('.');
        std::string_view const bits = dot == where.npos ? std::string_view{} : where.substr(dot + 1);
        std::string_view const numbers = where.substr(0, dot);
        std::size_t const dash = numbers.find('-');
        if (not read_address(numbers.substr(0, dash), first_) or
            (dash != numbers.npos and not read_last(numbers.substr(dash + 1)))) {
            return false;
        }
        is_range_ = dash != numbers.npos;
        if (dot == where.npos) {
            return true;
        }
        if (dash != numbers.npos) {
            return refuse("wrong_place", "bits are those of one register: 40.4-7");
        }
        return read_bits(bits);
    }

    bool read_last(std::string_view number)
    {
        place last = first_;
        if (not read_address(number, last)) {
            return false;
        }
        if (last.space != first_.space or last.address < first_.address) {
            return refuse("wrong_address", "a range begins with its lower address, and both are of one space");
        }
        last_ = last.address;
        return true;
    }

    bool read_address(std::string_view number, place& where)
    {
        if (is_list_) {
            auto const read = listed(number);
            where = read.value_or(where);
            return read or
                   refuse("wrong_address", '\'' + std::string{number} +
                                               "' is no number of a list: 1 to 9999 are coils, 10001 to 19999 discrete "
                                               "inputs, 30001 to 39999 input registers, 40001 to 49999 holding "
                                               "registers; of six digits 400001 to 465536 and so on");
        }
        auto const read = word_number(number);
        where.address = read.value_or(0);
        return read or refuse("wrong_address", '\'' + std::string{number} +
                                                   "' is no address, which is a number from 0 to 65535: 40, 0x28, "
                                                   "40-43, 40.3");
    }

    bool read_bits(std::string_view bits)
    {
        std::size_t const dash = bits.find('-');
        auto const low = word_number(bits.substr(0, dash));
        auto const high = dash == bits.npos ? low : word_number(bits.substr(dash + 1));
        if (first_.is_single_bit()) {
            return refuse("wrong_place", "a " + std::string{name_of(first_.space)} + " is one bit: leave out '." +
                                             std::string{bits} + '\'');
        }
        if (not low or not high or *low > *high or *high > 15) {
            return refuse("unknown_bit", "'." + std::string{bits} +
                                             "' is no bit, which has a number from 0 to 15: 40.3, "
                                             "or 40.4-7 with the lower one first");
        }
        first_.bit = *low;
        first_.last_bit = dash == bits.npos ? -1 : int{*high};
        return true;
    }

    bool read_forms(std::string_view rest)
    {
        while (has_more_) {
            std::string_view const how = take_part(rest);
            if (not read_form(how)) {
                return false;
            }
        }
        return true;
    }

    bool read_form(std::string_view how)
    {
        if (begins_with_digit(how)) {
            return once(scale_, how, "scale") and read_scale(how);
        }
        if (looks_like_order(how)) {
            return once(order_, how, "order") and keep_order(lower(how));
        }
        return once(type_, how, "type") and read_type(how);
    }

    bool once(std::string_view& place_of, std::string_view how, char const* what)
    {
        if (not place_of.empty()) {
            return refuse("wrong_form", "its " + std::string{what} + " is said twice: " + std::string{place_of} +
                                            " and " + std::string{how});
        }
        place_of = how;
        return true;
    }

    bool read_type(std::string_view how)
    {
        value_form& form = first_.form;
        std::vector<std::string_view> known{"abcd", "cdab", "badc", "dcba"};
        for (type_word const& each : type_words) {
            known.push_back(each.word);
            if (is_same_word(how, each.word)) {
                form.type = each.type;
                form.said += ':' + lower(how);
                return true;
            }
        }
        if (is_same_word(how.substr(0, 4), "text")) {
            auto const count = whole_number(how.substr(4));
            if (not count or *count == 0 or *count > most_characters) {
                return refuse("wrong_form", "a text has its number of characters behind it, 1 to 250: text20");
            }
            form.type = value_type::text;
            form.characters = static_cast<std::uint16_t>(*count);
            form.said += ":text" + std::to_string(*count);
            return true;
        }
        return refuse_form(how, nearest_word(how, known));
    }

    bool refuse_form(std::string_view how, std::string_view nearest)
    {
        if (how.empty()) {
            return refuse("wrong_form",
                          "nothing stands behind a colon: say a type, an order or a scale, or leave it out");
        }
        bool const is_sign = std::string_view{"+-."}.find(how[0]) != std::string_view::npos;
        if (is_sign) {
            return refuse("wrong_form", '\'' + std::string{how} + "': a scale begins with a digit: 0.1V, 1-40");
        }
        return refuse("wrong_form",
                      '\'' + std::string{how} + "' is no type (" + all_types +
                          "), no order (abcd cdab badc dcba) and no scale (0.1V)",
                      std::string{nearest});
    }

    bool keep_order(std::string const& order)
    {
        first_.form.order = order;
        first_.form.said += ':' + order;
        return true;
    }

    /// "0.1", "0.01m3/h", "0.1degC-50".
    bool read_scale(std::string_view how)
    {
        std::string_view rest = how;
        value_form& form = first_.form;
        auto const factor = take_decimal(rest);
        if (not factor or factor->digits == 0) {
            return refuse("wrong_form",
                          '\'' + std::string{how} + "': a scale is a number above 0 with at most nine digits: 0.1V");
        }
        std::size_t const sign = rest.find_first_of("+-");
        std::string_view const unit = rest.substr(0, sign);
        bool const has_power = not unit.empty() and (unit[0] == 'e' or unit[0] == 'E') and
                               (unit.size() == 1 ? sign != rest.npos : is_digit(unit[1]));
        if (has_power) { // "1e3V" is no unit "e3V"
            return refuse("wrong_form",
                          '\'' + std::string{how} + "': a scale is written without a power of ten: 1000V, 0.001V");
        }
        bool const is_unit = unit.size() <= longest_unit and std::ranges::all_of(unit, is_of_unit) and
                             (unit.empty() or (unit[0] != '.' and unit[0] != '/'));
        if (not is_unit) {
            return refuse("wrong_form", '\'' + std::string{how} + "': '" + std::string{unit} +
                                            "' is no unit, which has at most 16 letters, digits and % / ^ _ .");
        }
        form.factor = *factor;
        form.unit = std::string{unit};
        form.said += ':' + std::string{how};
        return sign == rest.npos or read_offset(how, unit, rest.substr(sign));
    }

    bool read_offset(std::string_view how, std::string_view unit, std::string_view text)
    {
        bool const is_negative = text[0] == '-';
        std::string_view rest = text.substr(1);
        auto offset = take_decimal(rest);
        if (not offset or not rest.empty()) {
            return refuse("wrong_form", '\'' + std::string{how} +
                                            "': behind the unit stands what is added, a number with "
                                            "at most nine digits: 0.1degC-50");
        }
        // A unit such as min-1 would be taken for minutes less one.
        bool const may_be_power = not unit.empty() and is_negative and text.size() == 2 and text[1] <= '3';
        if (may_be_power) {
            return refuse("wrong_form", '\'' + std::string{how} + "' may mean a power or a difference: say 1/" +
                                            std::string{unit} + " for a unit, or " + std::string{text} +
                                            ".0 for what is added");
        }
        offset->digits *= is_negative ? -1 : 1;
        first_.form.offset = *offset;
        return true;
    }

    /// What does not go together.
    bool check_form()
    {
        value_form const& form = first_.form;
        if (form.said.empty()) {
            return check_order() and check_range();
        }
        if (first_.is_single_bit() or first_.bit >= 0) {
            std::string const what = first_.bit >= 0 ? "bits" : "a " + std::string{name_of(first_.space)};
            return refuse("wrong_form", what + (first_.bit >= 0 ? " have" : " has") +
                                            " no type, order or scale: leave out '" + form.said + '\'');
        }
        bool const is_number =
            form.type != value_type::text and form.type != value_type::bits and form.type != value_type::hex;
        if (not scale_.empty() and not is_number) {
            return refuse("wrong_form", std::string{type_} + " is no number and has no scale: leave out ':" +
                                            std::string{scale_} + '\'');
        }
        return check_order() and check_range();
    }

    bool check_order()
    {
        value_form const& form = first_.form;
        if (form.order.empty()) {
            return true;
        }
        std::string letters = form.order;
        std::ranges::sort(letters);
        bool const is_one_word = form.type == value_type::text or form.registers() == 1;
        bool const is_known =
            form.order == "abcd" or form.order == "cdab" or form.order == "badc" or form.order == "dcba";
        if (form.order.size() == 8 ? letters != "abcdefgh" : not is_known) {
            return refuse("wrong_form", '\'' + form.order +
                                            "' is no order: say abcd, cdab, badc or dcba, or of 64 bits "
                                            "each of the letters a to h once");
        }
        if (form.order.size() == 8 and (is_one_word or form.registers() != 4)) {
            return refuse("wrong_form", "an order of eight letters is of 64 bits: say abcd, cdab, badc or dcba");
        }
        if (is_one_word and form.order != "abcd" and form.order != "badc") {
            return refuse("wrong_form", "each of its values is bytes of one register: say abcd, or badc where they are "
                                        "swapped; of two registers say a type, such as u32");
        }
        return true;
    }

    bool check_range()
    {
        unsigned const each = first_.form.registers();
        unsigned const count = is_range_ ? last_ - first_.address + 1U : each;
        if (count % each != 0) {
            unsigned const end = first_.address + (count + each - 1) / each * each - 1;
            return refuse("wrong_place", std::to_string(count) + " registers are no whole number of values of " +
                                             std::to_string(each) + " each; end the range at " + std::to_string(end));
        }
        if (first_.address + count > 65'536U) {
            return refuse("wrong_place",
                          "a value of " + std::to_string(each) + " registers would end behind 65535, the last address");
        }
        count_ = count;
        return true;
    }

    void add_places()
    {
        unsigned const each = first_.form.registers();
        for (unsigned done = 0; done < count_; done += each) {
            place one = first_;
            one.address = static_cast<std::uint16_t>(first_.address + done);
            found_.places.push_back(std::move(one));
        }
    }

    std::string_view word_;
    bool has_more_{false};
    bool is_list_{false};
    place first_{0};
    bool is_range_{false};
    std::uint16_t last_{0};
    unsigned count_{0};
    std::string_view type_{};
    std::string_view order_{};
    std::string_view scale_{};
    places_typed found_{};
};

} // namespace

std::uint16_t place::size() const noexcept { return is_single_bit() or bit >= 0 ? std::uint16_t{1} : form.registers(); }

std::uint16_t place::mask() const noexcept
{
    if (bit < 0) {
        return 0xFFFF;
    }
    auto const last = static_cast<unsigned>(last_bit < 0 ? bit : last_bit);
    return static_cast<std::uint16_t>((0xFFFFU >> (15U - last)) & (0xFFFFU << static_cast<unsigned>(bit)));
}

std::uint16_t value_form::registers() const noexcept
{
    if (type == value_type::text) {
        return static_cast<std::uint16_t>((characters + 1U) / 2U);
    }
    auto const found = std::ranges::find(type_words, type, &type_word::type);
    return found == std::end(type_words) ? std::uint16_t{1} : found->registers;
}

std::string value_form::letters() const
{
    std::size_t const size = std::size_t{2} * registers();
    if (order.size() == size) {
        return order;
    }
    bool const has_low_word_first = order == "cdab" or order == "dcba";
    bool const has_low_byte_first = order == "badc" or order == "dcba";
    std::string letters;
    for (std::size_t i = 0; i < size; ++i) {
        std::size_t const word = has_low_word_first ? size / 2 - 1 - i / 2 : i / 2;
        std::size_t const byte = has_low_byte_first ? 1 - i % 2 : i % 2;
        letters += static_cast<char>('a' + 2 * word + byte);
    }
    return letters;
}

std::string_view group_in(std::string_view word) noexcept
{
    constexpr std::string_view mark = "group:";
    return word.starts_with('@')                             ? word.substr(1)
           : is_same_word(word.substr(0, mark.size()), mark) ? word.substr(mark.size())
                                                             : std::string_view{};
}

bool is_place_word(std::string_view word) noexcept
{
    if (not group_in(word).empty()) {
        return false;
    }
    std::size_t const dot = word.find('.');
    bool const has_bits = begins_with_digit(word) and dot != word.npos and word.find('-', dot) != word.npos;
    return word.find(':') != word.npos or has_bits;
}

places_typed read_places(std::string_view word) { return place_reader{word}.run(); }

std::string text_of(place const& where)
{
    if (not where.name.empty()) {
        return where.name;
    }
    std::string text = where.is_space_said ? std::string{name_of(where.space)} + ':' : std::string{};
    text += std::to_string(where.address);
    text += where.bit < 0 ? "" : '.' + std::to_string(where.bit);
    text += where.last_bit < 0 ? "" : '-' + std::to_string(where.last_bit);
    return text + where.form.said;
}

std::string_view name_of(register_space space) noexcept
{
    return std::ranges::find(space_words, space, &space_word::space)->word;
}

std::string list_hint(std::uint16_t number)
{
    std::string const text = std::to_string(number);
    auto const where = text.size() == 5 ? listed(text) : std::nullopt;
    return where ? "list:" + text + " is " + text_of(*where) : std::string{};
}

} // namespace tool
