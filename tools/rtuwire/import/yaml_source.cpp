// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include <sstream>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include "exit_status.hpp"
#include "import/source_value.hpp"

namespace tool {

namespace {

text_place place_of(YAML::Mark const& mark)
{
    bool const is_known = mark.line >= 0 and mark.column >= 0;
    return is_known ? text_place{static_cast<std::size_t>(mark.line) + 1, static_cast<std::size_t>(mark.column) + 1}
                    : text_place{};
}

class yaml_builder : public YAML::EventHandler {
public:
    explicit yaml_builder(std::string const& file) : file_{file}, built_{file} {}

    void OnDocumentStart(YAML::Mark const&) override {}
    void OnDocumentEnd() override {}
    void OnNull(YAML::Mark const& mark, YAML::anchor_t) override { add(mark, source_kind::none, {}, {}); }
    void OnAlias(YAML::Mark const& mark, YAML::anchor_t) override
    {
        refuse_word(told_place(file_, place_of(mark)) + "an alias (*name): write out what it stands for");
    }
    void OnScalar(YAML::Mark const& mark, std::string const& tag, YAML::anchor_t, std::string const& value) override
    {
        bool const is_bare = tag == "?";
        bool const is_nothing = is_bare and (value.empty() or value == "~" or value == "null");
        add(mark, is_nothing ? source_kind::none : source_kind::text, value, is_bare or tag == "!" ? "" : tag);
    }
    void OnSequenceStart(YAML::Mark const& mark, std::string const& tag, YAML::anchor_t,
                         YAML::EmitterStyle::value) override
    {
        begin(mark, source_kind::list, tag);
    }
    void OnSequenceEnd() override { built_.end(); }
    void OnMapStart(YAML::Mark const& mark, std::string const& tag, YAML::anchor_t, YAML::EmitterStyle::value) override
    {
        begin(mark, source_kind::table, tag);
    }
    void OnMapEnd() override { built_.end(); }

    source_value take() { return built_.take(); }

private:
    /// The first of two scalars in a table is a name.
    void add(YAML::Mark const& mark, source_kind kind, std::string text, std::string tag)
    {
        if (built_.is_in_table() and not built_.has_name()) {
            built_.name(std::move(text));
            return;
        }
        source_value value;
        value.kind = kind;
        value.place = place_of(mark);
        value.text = std::move(text);
        value.tag = std::move(tag);
        built_.add(std::move(value));
    }

    void begin(YAML::Mark const& mark, source_kind kind, std::string const& tag)
    {
        if (built_.is_in_table() and not built_.has_name()) {
            refuse_word(told_place(file_, place_of(mark)) + "a list or a table is no name of a field");
        }
        built_.begin(kind, place_of(mark), tag == "?" ? std::string{} : tag);
    }

    std::string const& file_;
    source_builder built_;
};

} // namespace

source_value yaml_source(std::string const& file, std::string const& text)
{
    std::istringstream stream{text};
    yaml_builder builder{file};
    try {
        YAML::Parser parser{stream};
        parser.HandleNextDocument(builder);
    } catch (YAML::Exception const& why) {
        refuse_word(told_place(file, place_of(why.mark)) + "this is no YAML: " + why.msg);
    }
    return builder.take();
}

} // namespace tool
