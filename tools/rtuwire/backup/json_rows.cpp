// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The parser tells what it meets one after the other, and how far it has read: so each text has its place, and a key that
// stands twice is seen.
#include <string>

#include <nlohmann/json.hpp>

#include "backup/saved_text.hpp"
#include "files/counting_iterator.hpp"

namespace tool {

namespace {

class row_reader : public nlohmann::json_sax<nlohmann::ordered_json> {
public:
    row_reader(std::string_view text, char const* const& at, saved_text& found)
        : begin_{text.data()}, places_{text}, at_{at}, found_{found}
    {}

    bool null() override { return take({}); }
    bool boolean(bool) override { return refuse("a text or a number belongs here, not true or false"); }
    bool number_integer(number_integer_t value) override { return take(std::to_string(value)); }
    bool number_unsigned(number_unsigned_t value) override { return take(std::to_string(value)); }
    bool number_float(number_float_t, string_t const& text) override { return take(text); }
    bool string(string_t& text) override { return take(text); }
    bool binary(binary_t&) override { return refuse("bytes do not belong here"); }

    bool start_object(std::size_t) override
    {
        ++depth_;
        if (depth_ == 3 and is_in_list_) {
            found_.rows.push_back({place(), {}});
            return true;
        }
        return depth_ == 1 or refuse("an object does not belong here");
    }
    bool end_object() override
    {
        --depth_;
        return true;
    }
    bool start_array(std::size_t) override
    {
        ++depth_;
        if (depth_ != 2 or key_.text != "parameters" or is_in_list_ or has_list_) {
            return refuse("a list does not belong here");
        }
        is_in_list_ = has_list_ = true;
        return true;
    }
    bool end_array() override
    {
        --depth_;
        is_in_list_ = false;
        return true;
    }
    bool key(string_t& text) override
    {
        key_ = {text, place()};
        bool const is_row = depth_ == 3;
        if (is_row and not is_row_field(text)) {
            return refuse("'" + text + "' is no field of a parameter");
        }
        return not fields().contains(text) or refuse("'" + text + "' stands here a second time");
    }
    bool parse_error(std::size_t, std::string const&, nlohmann::detail::exception const& why) override
    {
        return refuse("this is no JSON: " + json_reason(why.what()));
    }

private:
    saved_fields& fields() { return depth_ == 3 ? found_.rows.back().fields : found_.head; }

    bool take(std::string text)
    {
        if (depth_ == 0 or (is_in_list_ and depth_ == 2)) {
            return refuse("an object belongs here");
        }
        fields().insert_or_assign(key_.text, placed_text{std::move(text), place()});
        return true;
    }

    /// Behind the last byte that was looked at, which for a number is the one after it.
    text_place place()
    {
        auto const read = static_cast<std::size_t>(at_ - begin_);
        return places_.of(read == 0 ? 0 : read - 1);
    }

    bool refuse(std::string const& sentence)
    {
        found_.fault = file_fault{place(), sentence};
        return false;
    }

    char const* begin_;
    place_counter places_;
    char const* const& at_;
    saved_text& found_;
    placed_text key_{};
    int depth_{0};
    bool is_in_list_{false};
    bool has_list_{false};
};

} // namespace

saved_text read_json_rows(std::string_view text)
{
    saved_text found;
    std::string_view const mark = "\xEF\xBB\xBF";
    std::string_view const body = text.starts_with(mark) ? text.substr(mark.size()) : text;
    char const* at = body.data();
    row_reader reader{body, at, found};
    char const* ignored = body.data();
    nlohmann::ordered_json::sax_parse(counting_iterator{body.data(), &at},
                                      counting_iterator{body.data() + body.size(), &ignored}, &reader);
    return found;
}

} // namespace tool
