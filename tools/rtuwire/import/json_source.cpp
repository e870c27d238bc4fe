// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include <nlohmann/json.hpp>

#include "exit_status.hpp"
#include "files/counting_iterator.hpp"
#include "import/source_value.hpp"

namespace tool {

namespace {

class json_builder : public nlohmann::json_sax<nlohmann::json> {
public:
    json_builder(std::string const& file, std::string_view text, char const* const& at)
        : file_{file}, text_{text}, places_{text}, at_{at}, built_{file}
    {}

    bool null() override { return add(source_kind::none, {}); }
    bool boolean(bool value) override { return add(source_kind::truth, value ? "true" : "false"); }
    bool number_integer(number_integer_t value) override { return add(source_kind::number, std::to_string(value)); }
    bool number_unsigned(number_unsigned_t value) override { return add(source_kind::number, std::to_string(value)); }
    bool number_float(number_float_t, string_t const& text) override { return add(source_kind::number, text); }
    bool string(string_t& text) override { return add(source_kind::text, text); }
    bool binary(binary_t&) override { return add(source_kind::none, {}); }
    bool start_object(std::size_t) override { return begin(source_kind::table); }
    bool start_array(std::size_t) override { return begin(source_kind::list); }
    bool end_object() override { return end(); }
    bool end_array() override { return end(); }
    bool key(string_t& text) override
    {
        built_.name(text);
        return true;
    }
    bool parse_error(std::size_t, std::string const&, nlohmann::detail::exception const& why) override
    {
        bool const is_template = text_.find("{%") != text_.npos;
        refuse_word(told_place(file_, place()) +
                    (is_template ? "this is a template out of which JSON is made (Jinja): import what comes out of it"
                                 : "this is no JSON: " + json_reason(why.what())));
    }

    source_value take() { return built_.take(); }

private:
    /// Behind the last byte that was looked at, which for a number is the one after it.
    text_place place()
    {
        auto const read = static_cast<std::size_t>(at_ - text_.data());
        return places_.of(read == 0 ? 0 : read - 1);
    }

    bool add(source_kind kind, std::string text)
    {
        source_value value;
        value.kind = kind;
        value.place = place();
        value.text = std::move(text);
        built_.add(std::move(value));
        return true;
    }

    bool begin(source_kind kind)
    {
        built_.begin(kind, place());
        return true;
    }

    bool end()
    {
        built_.end();
        return true;
    }

    std::string const& file_;
    std::string_view text_;
    place_counter places_;
    char const* const& at_;
    source_builder built_;
};

} // namespace

source_value json_source(std::string const& file, std::string_view text)
{
    char const* at = text.data();
    char const* ignored = at;
    json_builder builder{file, text, at};
    nlohmann::json::sax_parse(counting_iterator{text.data(), &at},
                              counting_iterator{text.data() + text.size(), &ignored}, &builder,
                              nlohmann::json::input_format_t::json, true, true);
    return builder.take();
}

} // namespace tool
