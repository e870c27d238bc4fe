# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What makes the site refuses what is wrong: a dead link, an unlisted page, a block that differs from its program, an error
without a remedy, a refusal without its sentence."""
import pathlib
import re
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "docs" / "generate"))
import diagrams  # noqa: E402
import first  # noqa: E402
import gallery  # noqa: E402
import headers  # noqa: E402
import inherited  # noqa: E402
import links  # noqa: E402
import pages  # noqa: E402
import search  # noqa: E402
import snippets  # noqa: E402
import stage  # noqa: E402


class Folder(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = pathlib.Path(place.name)

    def write(self, name, text):
        path = self.place / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


class Links(Folder):
    def found(self):
        return list(links.broken(self.place.resolve(), links.read(self.place.resolve())))

    def test_a_link_that_leads_somewhere(self):
        self.write("a.html", '<a href="b.html#there">b</a> <a href="https://nobody.invalid/">out</a>')
        self.write("b.html", '<p id="there">x</p><a href="#there">up</a>')
        self.assertEqual(self.found(), [])

    def test_a_file_that_is_not_there(self):
        self.write("a.html", '<a href="b.html">b</a>')
        self.assertEqual(self.found(), ["a.html:1: b.html: no such file"])

    def test_a_place_that_is_not_there(self):
        self.write("a.html", '<a href="#nowhere">b</a>')
        self.assertEqual(self.found(), ["a.html:1: #nowhere: no such place"])

    def test_a_picture_and_a_script(self):
        self.write("a.html", '<img src="p.png"><script src="s.js"></script>')
        self.assertEqual(len(self.found()), 2)

    def test_a_state_of_the_playground_by_its_name(self):
        self.write("playground/index.html", '<script>const namedStates = {\n  "running": "atv320;1:power=1;2",\n};</script>')
        self.write("a.html", '<a href="playground/index.html#running">a</a> <a href="playground/index.html#flying">b</a>')
        self.assertEqual(self.found(), ["a.html:1: playground/index.html#flying: no such place"])

    def test_a_link_out_of_the_site(self):
        self.write("outside.html", "x")
        self.write("site/a.html", '<a href="../outside.html">b</a>')
        site = (self.place / "site").resolve()
        self.assertEqual(list(links.broken(site, links.read(site))), ["a.html:1: ../outside.html leads out of the site"])


def page_of(title, body):
    return f'<div class="title">{title} </div><div class="contents">{body}</div>'


def heading(anchor, words):
    return f'<h2><a class="anchor" id="{anchor}"></a>\n{words}</h2>'


ERRORS_TABLE = """<tr><td><a id="errors-errc-illegal_data_address"></a><code>illegal_data_address</code> 0x02</td></tr>
<tr><td><a id="errors-errc-busy"></a><code>busy</code> 0x86</td></tr>"""
TAGS = """<tagfile><compound kind="class"><name>rtuwire::client&lt; T &gt;</name><filename>classclient</filename>
<member kind="function"><name>advance</name><anchorfile>classclient.html</anchorfile><anchor>a1</anchor></member>
<member kind="function"><name>advance</name><anchorfile>classclient.html</anchorfile><anchor>a2</anchor></member>
<member kind="function"><name>operator==</name><anchorfile>classclient.html</anchorfile><anchor>a3</anchor></member></compound>
<compound kind="file"><name>client.hpp</name><filename>client_8hpp</filename></compound></tagfile>"""


class Search(Folder):
    def test_an_error_by_name_and_number(self):
        found = list(search.errors(ERRORS_TABLE))
        words = {words or shown for shown, words, *_ in found}
        self.assertEqual(words, {"illegal_data_address", "busy", "exception 02: illegal data address", "exception code 02", "exception 0x02",
                                 "exception 2"})
        self.assertEqual({place for _, _, place, *_ in found}, {"errors.html#errors-errc-illegal_data_address", "errors.html#errors-errc-busy"})

    def test_a_heading_alone_and_behind_its_title(self):
        page = page_of("ATV12", heading("drives_atv12-scanner", "Scanner and cycle") + heading("other-place", "Elsewhere"))
        found = {words or shown: place for shown, words, place, *_ in search.headings("drives_atv12", page)}
        self.assertEqual(found, {"ATV12": "drives_atv12.html", "Scanner and cycle": "drives_atv12.html#drives_atv12-scanner",
                                 "ATV12 Scanner and cycle": "drives_atv12.html#drives_atv12-scanner"})

    def test_a_heading_with_code_is_its_words(self):
        found = [words or shown for shown, words, *_ in search.headings("a", page_of("A", heading("a-b", "The &lt;tt&gt;rtuwire&lt;/tt&gt; tool")))]
        self.assertEqual(found, ["A", "The rtuwire tool", "A The rtuwire tool"])
        self.assertEqual(pages.plain("a.md", "The `rtuwire` tool"), "The rtuwire tool")
        with self.assertRaises(pages.BrokenLink):
            pages.plain("a.md", "A `table<...>` of registers")

    def test_what_has_changed_is_found_last(self):
        ranks = {name: next(iter(search.headings(name, page_of("A", heading(f"{name}-b", "B")))))[4] for name in ("changelog", "tool")}
        self.assertLess(ranks["changelog"], ranks["tool"] - 200)

    def rows(self, *cells):
        return '<tr class="markdownTableRowOdd">' + "".join(f'<td class="x">{cell}</td>' for cell in cells) + "</tr>"

    def test_the_words_of_the_glossary(self):
        row = self.rows("slave, Modbus slave", "a <code>server</code>", '<a href="a.html#b">A</a>')
        self.assertEqual([each[:4] for each in search.glossary(row)],
                         [["slave", "", "a.html#b", "a server"], ["Modbus slave", "", "a.html#b", "a server"]])
        with self.assertRaises(ValueError):
            list(search.glossary(self.rows("slave", "server", "nowhere")))

    def test_a_word_that_leads_to_a_page_without_an_answer(self):
        self.write("a.html", "<p>A server answers.</p>")
        row = self.rows("slave, RAM", "a <code>server</code>, see TTO", '<a href="a.html#b">A</a>')
        for text in ("A server answers.", "the slave", "Flash and ram", "TTO"):
            self.write("a.html", text)
            self.assertEqual(list(search.without_answer(self.place, row)), [], text)
        self.write("a.html", "<p>Parameters and servers, <a href='slave'>and an answer</a>.</p>")
        self.assertEqual(list(search.without_answer(self.place, row)), ["a.html#b has nothing of 'slave, RAM'"])

    def test_the_names_of_the_reference_once(self):
        self.write("tags.xml", TAGS)
        found = [(shown, place, where) for shown, _, place, where, _ in search.names(self.place / "tags.xml")]
        self.assertEqual(found, [("client", "classclient.html", "class, reference"),
                                 ("advance", "classclient.html#a1", "function of client, reference")])

    def test_a_site_without_errors_fails(self):
        self.write("tags.xml", TAGS)
        self.write("errors.html", "<h1>Gallery</h1>")
        self.write("glossary.html", "<h1>Words</h1>")
        self.assertEqual(search.main(self.place, self.place / "tags.xml"), 1)


README = "# a\n\nIt is `a` & \nno more. It has\n"
TEMPLATE = "<p>{version} {sentence} {contents}{unknown}</p>\n<!-- picture -->\n<img alt=\"{picture_words}\" {picture_size}>\n<!-- end of picture -->\n"


class First(unittest.TestCase):
    MENU = [("Start & go", [("Wiring", "@ref start_wiring")])]

    def test_marks_are_replaced_and_others_stay(self):
        out = first.page(TEMPLATE, self.MENU, README, "1.2.3", "", "")
        self.assertIn("<p>1.2.3 It is a &amp; no more. <section><h3>Start &amp; go</h3>", out)
        self.assertIn('<a href="start_wiring.html">Wiring</a>', out)
        self.assertIn("{unknown}", out)
        self.assertNotIn("<img", out)

    def test_a_picture_has_its_place_before_it_comes(self):
        out = first.page(TEMPLATE, self.MENU, README, "1.2.3", "", '<svg viewBox="0 0 700.4 300"><title id="a">A terminal</title>')
        self.assertIn('<img alt="A terminal" width="700" height="300">', out)


class Social(unittest.TestCase):
    """Who shows a link to the site asks for the picture by the address that the page names, which has to be a whole one."""

    def named(self, address):
        text = (PROJECT / "docs/site/first.html").read_text(encoding="utf-8")
        out = first.page(text, [], README, "1.2.3", address, "")
        return re.findall('(?:og:image|twitter:)[^>]*', out), re.findall('<meta property="og:image" content="([^"]*)">', out)

    def test_where_an_address_is_known_the_picture_has_it(self):
        for address in ("https://example.org/wire", "https://example.org/wire/"):
            with self.subTest(address):
                self.assertEqual(self.named(address)[1], ["https://example.org/wire/social.png"])
        self.assertEqual(self.named("http://example.org")[1], ["http://example.org/social.png"])

    def test_where_none_is_known_no_picture_is_named(self):
        self.assertEqual(self.named(""), ([], []))

    def test_what_is_no_whole_address_is_refused(self):
        for address in ("example.org/wire", "/wire/", "https:///wire", "https://example.org/a page/", "ftp://example.org/"):
            with self.subTest(address), self.assertRaisesRegex(pages.BrokenLink, f"SITE_ADDRESS is '{address}'"):
                self.named(address)


class Pages(Folder):
    def staged(self, text, **made):
        self.write("README.md", text)
        self.write("docs/other.md", "# Other\n\n## A part, with `code`\n")
        return pages.Pages(self.place, made).staged("README.md")

    def test_a_link_becomes_one_of_the_site(self):
        out = self.staged("# One\n\nSee [there](docs/other.md#a-part-with-code).\n")
        self.assertIn('<a href="other.html#other-a-part-with-code">there</a>', out)

    def test_a_file_name_becomes_a_title(self):
        self.assertIn('<a href="other.html">Other</a>', self.staged("# One\n\n[docs/other.md](docs/other.md)\n"))

    def test_a_link_in_code_stays(self):
        self.assertIn("[x](docs/none.md)", self.staged("# One\n\n```\n[x](docs/none.md)\n```\n"))

    def test_a_picture_is_taken_from_the_site(self):
        self.assertIn('<img src="pictures/tool.svg" alt="The tool"/>', self.staged("# One\n\n![The tool](docs/pictures/tool.svg)\n"))

    def test_bold_becomes_a_tag_whatever_it_touches(self):
        out = self.staged('# One\n\n**`--allow-run` lets it turn.** It **goes\non**, **"so"** **(?)**; `a ** b`\n')
        self.assertIn('<b>``--allow-run`` lets it turn.</b> It <b>goes\non</b>, <b>"so"</b> <b>(?)</b>; ``a ** b``', out)
        self.assertIn("2 ** 3", self.staged("# One\n\n```\n2 ** 3\n```\n"))

    def test_bold_that_does_not_end(self):
        with self.assertRaises(pages.BrokenLink):
            self.staged("# One\n\n**never\n\nends\n")

    def test_what_the_build_makes_stands_in_the_place_of_what_is_kept(self):
        out = self.staged("# One\n\n<!-- made: it -->\n| old |\n\n```mermaid\n<!-- end -->\n```\n<!-- end -->\n\nMore\n", it="|a|\n|b|")
        self.assertIn("\n|a|\n|b|\n\nMore", out)
        self.assertNotIn("old", out)
        self.assertNotIn("mermaid", out)
        self.assertIn("|a|\nMore", self.staged("# One\n\n<!-- made: it -->\n<!-- end -->\nMore\n", it="|a|"))
        with self.assertRaises(pages.BrokenLink):
            self.staged("# One\n\n<!-- made: it -->\n| old |\n\nMore\n", it="|a|")

    def test_a_dead_link(self):
        for link in ("docs/none.md", "docs/other.md#none", "#none"):
            with self.assertRaises(pages.BrokenLink):
                self.staged(f"# One\n\n[x]({link})\n")

    def test_what_nothing_makes(self):
        with self.assertRaises(pages.BrokenLink):
            self.staged("# One\n\n<!-- made: nothing -->\n<!-- end -->\n")

    def test_a_region_is_taken_from_its_program(self):
        out = self.staged("# One\n\n<!-- snippet: examples/a.cpp part -->\n```cpp\nold\n```\nend\n")
        self.assertIn("\\snippet examples/a.cpp part", out)
        self.assertNotIn("old", out)


class Settings(Folder):
    """Doxygen walks through each folder that it is given, and follows links."""

    def test_no_folder_has_what_others_build(self):
        self.write("docs/Doxyfile", "")
        self.write("include/rtuwire/core/version.hpp", "#define RTUWIRE_VERSION 900\n")
        build = self.place / "build" / "docs"
        build.mkdir(parents=True)
        stage.write_settings(self.place, build, self.place)
        text = (build / "Doxyfile").read_text(encoding="utf-8")
        walked = [pathlib.Path(path) for row in re.findall("^(?:INPUT|EXAMPLE_PATH) = (.*)$", text, re.MULTILINE)
                  for path in row.split()]
        self.assertGreater(len(walked), 2)
        # As Wine's folder of drives, in which z: leads to the root.
        others = [self.place / "build/wine", build / "browser", build / "html", self.place / ".git"]
        self.assertEqual([path for path in walked if any(path in [each, *each.parents] for each in others)], [])


class Snippets(Folder):
    def found(self, block):
        self.write("README.md", f"<!-- snippet: a.cpp part -->\n```cpp\n{block}```\n")
        self.write("a.cpp", "int a;\n    //! [part]\n    int b;\n    //! [part]\n")
        return list(snippets.check(self.place, self.place / "README.md"))

    def test_the_same(self):
        self.assertEqual(self.found("int b;\n"), [])

    def test_another(self):
        self.assertIn("is not what a.cpp has", self.found("int c;\n")[0])

    def test_a_region_that_is_not_there(self):
        self.write("README.md", "<!-- snippet: a.cpp none -->\n```cpp\n```\n")
        self.write("a.cpp", "int a;\n")
        self.assertIn("0 regions [none]", list(snippets.check(self.place, self.place / "README.md"))[0])


class Gallery(Folder):
    def errors(self, comment, names='case errc::none: return "no";\ncase errc::bad: return "bad";\n'):
        self.write("include/rtuwire/wire/errc.hpp", f"    /// No error.\n    none = 0x00,\n{comment}    bad = 0x01,\n")
        self.write("include/rtuwire/wire/errc_name.hpp", names)
        return gallery.errors(self.place)

    def test_cause_and_remedy(self):
        found = self.errors("    /// It is bad.\n    /// Remedy: Make it\n    /// good.\n")
        self.assertEqual(found[1], ("0x01", "bad", "bad", "It is bad.", "Make it good."))
        self.assertEqual(gallery.errors_page(found).split("\n")[2:],
                         ['| <a id="errors-errc-bad"></a>`bad` 0x01 | bad | It is bad. | Make it good. |'])

    def test_no_remedy_and_no_comment(self):
        for comment in ("    /// It is bad.\n", ""):
            with self.assertRaises(ValueError):
                self.errors(comment)

    def test_a_name_that_is_missing(self):
        with self.assertRaises((ValueError, KeyError)):
            self.errors("    /// Bad.\n    /// Remedy: Good.\n", 'case errc::none: return "no";\n')

    def said(self, text):
        self.write("x.cpp", text)
        return gallery.said_by(self.place, self.place / "docs", "g++", [gallery.Refusal(self.place / "x.cpp")])

    def test_a_refusal_that_says_something_else(self):
        with self.assertRaises(ValueError):
            self.said("// EXPECT: never said\nint main() {\n#ifdef REFUSED\nstatic_assert(false, \"said\");\n#endif\n}\n")

    def test_an_act_that_is_accepted(self):
        with self.assertRaises(ValueError):
            self.said("// EXPECT: said\nint main() {}\n")

    def test_what_was_kept_is_shown_and_nothing_compiled_again(self):
        text = "// EXPECT: said\nint main() {\n#ifdef REFUSED\nstatic_assert(false, \"said\");\n#endif\n}\n"
        self.assertIn("x.cpp:4:15: error: ", self.said(text)["x"])
        kept = next((self.place / "docs/refusals").iterdir())
        self.write(f"build/gcc/refusals/{kept.name}", "x.cpp:4: said before")
        kept.unlink()
        self.assertEqual(self.said(text), {"x": "x.cpp:4: said before"})
        self.assertIn("error: ", self.said(text + "\n")["x"])

    def test_long_output_keeps_the_sentence(self):
        text = "\n".join(["x"] * 40 + ["error: said"] + ["y"] * 3)
        self.assertEqual(gallery.shortened(text, ["said"]).split("\n"), ["x"] * gallery.MOST_LINES + ["...", "error: said", "..."])


class Headers(unittest.TestCase):
    def test_what_is_internal_is_left_out(self):
        text = "#pragma once\nnamespace a {\n/// Shown.\nstruct b {};\n/// Hidden.\n/// Internal.\nstruct c {\n  int d;\n};\n} // namespace a\n"
        out = headers.without_internal(text)
        self.assertIn("struct b", out)
        self.assertNotIn("struct c", out)
        self.assertEqual(out.count("\n"), text.count("\n"))

    def test_what_completes_an_internal_name_is_left_out(self):
        first = "#pragma once\nnamespace a {\n/// Internal.\ntemplate <typename T> inline constexpr int b = 1;\n} // namespace a\n"
        second = "#pragma once\nnamespace a {\ntemplate <> inline constexpr int b<int> = 2;\n/// Shown.\ntemplate <typename T> struct c {};\n}\n"
        out = headers.without_internal(second, headers.internal_names([first, second]))
        self.assertNotIn("b<int>", out)
        self.assertIn("struct c", out)


BASE = """#pragma once
namespace a {
/// Internal.
template <typename Part> class middle : public Part {
public:
    explicit constexpr middle(int its_size) noexcept : size_{its_size}, other_{{0}} {}
    /// In the middle.
    [[nodiscard]] constexpr a::word word() const noexcept { return size_ > 0 ? word_{1} : word_{2}; }
    /// Hidden by the shown one.
    constexpr void twice() noexcept {}
    /// Internal.
    constexpr void inner() noexcept {}
protected:
    constexpr void guarded() noexcept {}
private:
    int size_;
};
/// Internal.
struct bottom {
    /// At the bottom.
    void deep(int x = 1);
    constexpr void bare() noexcept {}
};
} // namespace a
"""
SHOWN = """#pragma once
namespace a {
/// Shown.
class open : public middle<bottom> {
public:
    /// Its own.
    constexpr void twice() noexcept {}
};
/// Shown, too.
class closed : middle<bottom> {
    using base = middle<bottom>;
public:
    /// As there.
    using base::guarded, base::bare;
};
} // namespace a
"""


class Inherited(unittest.TestCase):
    def setUp(self):
        known = inherited.all_classes([BASE, SHOWN])
        self.out = inherited.with_inherited(SHOWN, known, {"open", "closed"})
        begin = self.out.index("class closed")
        self.open, self.closed = self.out[:begin], self.out[begin:]

    def test_members_of_all_bases_are_shown_in_the_class(self):
        for words in ("/** In the middle. */ [[nodiscard]] constexpr a::word word() const noexcept;",
                      "/** At the bottom. */ void deep(int x = 1);", "constexpr void bare() noexcept;"):
            self.assertIn(words, self.open)

    def test_what_no_program_can_call_is_not_shown(self):
        for name in ("guarded", "inner", "size_", "other_", "its_size", "Hidden"):
            self.assertNotIn(name, self.open)

    def test_a_private_base_shows_what_the_class_makes_public(self):
        self.assertIn("/** As there. */ constexpr void guarded() noexcept;", self.closed)
        self.assertIn("/** As there. */ constexpr void bare() noexcept;", self.closed)
        self.assertNotIn("deep", self.closed)
        self.assertNotIn("word", self.closed)

    def test_each_line_keeps_its_number(self):
        self.assertEqual(self.out.count("\n"), SHOWN.count("\n"))

    def test_the_classes_of_the_library_have_what_the_guides_call(self):
        with tempfile.TemporaryDirectory() as place:
            headers.stage(PROJECT, pathlib.Path(place))
            shown = {name: one for path in pathlib.Path(place).rglob("*.hpp")
                     for name, one in inherited.classes(path.read_text(encoding="utf-8")).items()}
        for name, called in (("basic_client", "receive sent advance converse poll_transmit poll_deadline hold trace_to"),
                             ("bus", "receive sent advance converse poll_transmit poll_deadline cancel is_ordered"),
                             ("basic_server", "receive sent advance serve poll_transmit poll_deadline"),
                             ("start", "settled reason succeeded running"), ("stop", "settled reason succeeded"),
                             ("restore", "settled reason cancel"), ("backup", "settled outcome"),
                             ("poller", "settled outcome"), ("single_request", "settled outcome")):
            words = {each.name for each in inherited.members(shown[name]) if each.access == "public"}
            self.assertLessEqual(set(called.split()), words, name)


CONSTRUCTOR = re.compile(r"(?:template\s*<.*?>\s*)?(?:requires\s*\(.*?\)\s*)?(?:(?:constexpr|explicit|consteval)\s+)*(\w+)\s*\(", re.DOTALL)


def constructors(name, one):
    """The public constructors of a class: each with its comment."""
    inside, access = one.text[one.begin + 1:one.end], "public" if one.is_struct else "private"
    code = inherited.without_starts(inherited.declarations.code_of(inside))
    for _, begin, end in inherited.declarations.statements(code):
        while label := inherited.LABEL.match(code, begin):
            access, begin = label[1], label.end()
        first = begin + len(code[begin:end]) - len(code[begin:end].lstrip())
        found = CONSTRUCTOR.match(code[first:end])
        if access == "public" and found and found[1] == name:
            yield inside[first:end], inherited.declarations.comment_before(inside, inside.rfind("\n", 0, first) + 1)


class Constructors(unittest.TestCase):
    def found(self, words):
        return [comment for _, comment in constructors("a", inherited.classes(f"class a {{\n{words}}};\n")["a"])]

    def test_public_ones_with_their_comments(self):
        self.assertEqual(self.found("    a(int);\npublic:\n    /// Of a number.\n    explicit constexpr a(long x) : x_{x} {}\n    a() = default;\n    void b();\n"),
                         ["Of a number.", ""])

    def test_the_reference_says_something_of_each(self):
        with tempfile.TemporaryDirectory() as place:
            headers.stage(PROJECT, pathlib.Path(place))
            found = [(path.name, words, comment) for path in sorted(pathlib.Path(place).rglob("*.hpp"))
                     for name, one in inherited.classes(path.read_text(encoding="utf-8")).items() for words, comment in constructors(name, one)]
        self.assertGreater(len(found), 120)
        self.assertEqual([f"{file}: {words[:100]}" for file, words, comment in found if not comment and "#endif" not in words], [],
                         "with the second branch of an #if, whose comment stands before both, left out")


class Diagrams(unittest.TestCase):
    def test_arrows_are_joined_and_loops_left_out(self):
        self.assertEqual(diagrams.joined([("a", "x", "b"), ("a", "y", "b"), ("a", "z", "a")]), [("a", "b", "x\\ny")])

    def test_a_picture_takes_the_colours_of_its_page(self):
        out = diagrams.recoloured('<path stroke="black"/><text x="1">w</text>')
        self.assertEqual(out, '<path stroke="currentColor"/><text fill="currentColor" x="1">w</text>')
