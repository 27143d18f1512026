// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/case_file.h"

#include <functional>
#include <ostream>

#include "tests/cases/temporary_folder.h"

namespace tiprub {
namespace {

enum class Colour { red, green };

/// Reads a table with one key of each kind.
void read_all(CaseTable& table) {
  table.number("length", std::nullopt, Range::positive(), "m");
  table.integer("count", 3, Range::between(1, 9), "");
  table.flag("open", false);
  table.text("name", "none");
  table.choice("colour", Colour::red, {{Colour::red, "red"}, {Colour::green, "green"}});
  table.numbers("speeds", {{1.0}}, Range::at_least(0.0), "rpm");
  table.points("curve", {{{0.0, 1.0}}}, Range::positive(), "m");
  CaseTable inner = table.table("inner");
  inner.number("depth", 1.0, Range::any(), "m");
  table.close();
}

/// A case, and the message about it after the file's name.
struct Wrong {
  std::string name;
  std::string text;
  std::string message;
};
void PrintTo(const Wrong& wrong, std::ostream* out) {
  *out << wrong.name;
}

class WrongCase : public TemporaryFolder, public ::testing::WithParamInterface<Wrong> {};

TEST_P(WrongCase, IsRefusedAtItsPlace) {
  write(path("case.toml"), GetParam().text);
  try {
    CaseTable table = CaseFile(path("case.toml")).table("mesh");
    read_all(table);
    FAIL() << "nothing was refused";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.substr(0, path("case.toml").string().size()), path("case.toml").string());
    EXPECT_EQ(message.substr(path("case.toml").string().size()).substr(0, GetParam().message.size()),
              GetParam().message);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Message, WrongCase,
    ::testing::Values(
        Wrong{"unknown_key", "[mesh]\nlength = 1.0\n  lenght = 2.0\n",
              ":3:3: unknown key \"lenght\" in [mesh] (did you mean length?); known: length, count, open, name, "
              "colour, speeds, curve, inner"},
        Wrong{"unknown_inner_key", "[mesh]\nlength = 1.0\n[mesh.inner]\nwidth = 2.0\n",
              ":4:1: unknown key \"width\" in [mesh.inner]; known: depth"},
        Wrong{"missing", "\n[mesh]\ncount = 2\n", ":2:1: [mesh] has no length, and it has no default; add it"},
        Wrong{"text_for_number", "[mesh]\nlength = \"long\"\n", ":2:10: [mesh] length is not a number"},
        Wrong{"not_positive", "[mesh]\nlength = 0.0\n", ":2:10: [mesh] length = 0 must be more than 0 [m]"},
        Wrong{"nan", "[mesh]\nlength = nan\n", ":2:10: [mesh] length = nan must be a finite number"},
        Wrong{"infinite", "[mesh]\nlength = inf\n", ":2:10: [mesh] length = inf must be a finite number"},
        Wrong{"out_of_range", "[mesh]\nlength = 1\ncount = 12\n",
              ":3:9: [mesh] count = 12 must be at least 1 and at most 9"},
        Wrong{"broken_count", "[mesh]\nlength = 1\ncount = 2.5\n", ":3:9: [mesh] count is not a whole number"},
        Wrong{"flag_as_number", "[mesh]\nlength = 1\nopen = 1\n", ":3:8: [mesh] open must be true or false"},
        Wrong{"bare_text", "[mesh]\nlength = 1\nname = 3\n", ":3:8: [mesh] name must be a text in quotes"},
        Wrong{"unknown_choice", "[mesh]\nlength = 1\ncolour = \"blue\"\n",
              ":3:10: [mesh] colour = \"blue\" must be one of: red, green"},
        Wrong{"no_list", "[mesh]\nlength = 1\nspeeds = 3\n", ":3:10: [mesh] speeds must be a list of numbers"},
        Wrong{"empty_list", "[mesh]\nlength = 1\nspeeds = []\n", ":3:10: [mesh] speeds must be a list of numbers"},
        Wrong{"value_in_list", "[mesh]\nlength = 1\nspeeds = [1.0, -2.0]\n",
              ":3:16: [mesh] speeds = -2 must be at least 0 [rpm]"},
        Wrong{"no_pairs", "[mesh]\nlength = 1\ncurve = [1.0, 2.0]\n",
              ":3:10: [mesh] curve must be a list of [x, y] pairs"},
        Wrong{"not_increasing", "[mesh]\nlength = 1\ncurve = [[0.0, 1.0], [0.5, 2.0], [0.5, 3.0]]\n",
              ":3:34: [mesh] curve must be a list of [x, y] pairs with x increasing; 0.5 follows 0.5"},
        Wrong{"ordinate_out_of_range", "[mesh]\nlength = 1\ncurve = [[0.0, -1.0]]\n",
              ":3:16: [mesh] curve = -1 must be more than 0 [m]"},
        Wrong{"no_table_inside", "[mesh]\nlength = 1\ninner = 3\n", ":3:9: [mesh.inner] must be a table"},
        Wrong{
            "unknown_table", "[mash]\nlength = 1\n",
            ":1:1: \"mash\" is not known here; known: title (a text), and the tables mesh, reduce, casing, simulate, "
            "postprocess, material"},
        Wrong{"stray_key", "length = 1\n", ":1:10: \"length\" is not known here; known: title (a text)"},
        Wrong{"title_as_number", "title = 1\n[mesh]\n", ":1:9: \"title\" is not known here"},
        Wrong{"no_table", "title = \"nothing\"\n", ": has no [mesh] table; add it"},
        Wrong{"not_toml", "[mesh]\nlength = = 1\n", ":2:10: not TOML: "},
        Wrong{"same_key_twice", "[mesh]\nlength = 1\nlength = 2\n", ":3:"}),
    [](const auto& wrong) { return wrong.param.name; });

class GoodCase : public TemporaryFolder {
 protected:
  CaseFile file(const std::string& text) const {
    write(path("case.toml"), text);
    return CaseFile(path("case.toml"));
  }
};

TEST_F(GoodCase, GivesItsValues) {
  const CaseFile scene = file(
      "title = \"one\"\n[mesh]\nlength = 2\ncount = 4\nopen = true\nname = \"x\"\n"
      "colour = \"green\"\nspeeds = [1, 2.5]\ncurve = [[0, 1], [1, 2]]\ninner = {depth = 7}\n");
  EXPECT_EQ(scene.title(), "one");
  EXPECT_EQ(scene.source(), read(path("case.toml")));
  CaseTable table = scene.table("mesh");
  EXPECT_EQ(table.number("length", std::nullopt, Range::positive(), "m"), 2.0);
  EXPECT_EQ(table.integer("count", 1, Range::any(), ""), 4);
  EXPECT_TRUE(table.flag("open", false));
  EXPECT_EQ(table.text("name", std::nullopt), "x");
  const auto colour = table.choice<Colour>("colour", std::nullopt, {{Colour::red, "red"}, {Colour::green, "green"}});
  EXPECT_EQ(colour, Colour::green);
  EXPECT_EQ(table.numbers("speeds", std::nullopt, Range::any(), "rpm"), (std::vector<double>{1.0, 2.5}));
  const auto curve = table.points("curve", std::nullopt, Range::any(), "m");
  EXPECT_EQ(curve, (std::vector<std::array<double, 2>>{{0.0, 1.0}, {1.0, 2.0}}));
  EXPECT_EQ(table.table("inner").number("depth", 1.0, Range::any(), "m"), 7.0);
  EXPECT_NO_THROW(table.close());
}

TEST_F(GoodCase, TakesListsFromFilesBesideIt) {
  write(path("speeds.csv"), "speed_rpm\n# first run\n1\n2.5\r\n");
  write(path("curve.csv"), "\"frequency\", ratio\n0, 1\n1,2 # measured\n");
  CaseTable table = file("[mesh]\nspeeds = \"speeds.csv\"\ncurve = \"curve.csv\"\n").table("mesh");
  EXPECT_EQ(table.numbers("speeds", std::nullopt, Range::any(), "rpm"), (std::vector<double>{1.0, 2.5}));
  const auto curve = table.points("curve", std::nullopt, Range::any(), "m");
  EXPECT_EQ(curve, (std::vector<std::array<double, 2>>{{0.0, 1.0}, {1.0, 2.0}}));
  EXPECT_EQ(table.resolved(), "speeds = [1, 2.5]  # rpm\ncurve = [[0, 1], [1, 2]]  # m\n");  // not the files' names
}

/// Symptom: the mesh that a case names was overwritten by what was made of it.
TEST_F(GoodCase, TellsTheFilesThatWereRead) {
  write(path("speeds.csv"), "1\n2.5\n");
  write(path("blade.txt"), "section");
  CaseTable table =
      file("[mesh]\nblade = \"blade.txt\"\nlength = 1\n[mesh.inner]\nspeeds = \"speeds.csv\"\n").table("mesh");
  EXPECT_TRUE(table.files().empty());
  table.file("blade", "a blade file");
  table.table("inner").numbers("speeds", std::nullopt, Range::any(), "rpm");
  EXPECT_EQ(table.files(), (std::vector{path("blade.txt"), path("speeds.csv")}));
}

/// What a file that a list is taken from holds, and the message about it after its name.
class WrongList : public TemporaryFolder, public ::testing::WithParamInterface<Wrong> {};

TEST_P(WrongList, IsRefusedAtItsLine) {
  write(path("case.toml"), "[mesh]\nlength = 1\ncurve = \"curve.csv\"\n");
  write(path("curve.csv"), GetParam().text);
  try {
    CaseTable table = CaseFile(path("case.toml")).table("mesh");
    read_all(table);
    FAIL() << "nothing was refused";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), path("curve.csv").string() + GetParam().message);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Message, WrongList,
    ::testing::Values(
        Wrong{"empty", "x, y\n", ": has no line of numbers"},
        Wrong{"three_columns", "x, y\n0, 1, 2\n", ":2: has 3 words, and must have 2: curve: x, y"},
        Wrong{"decimal_comma", "0,5 1,0\n", ":1: has 4 words, and must have 2: curve: x, y"},
        Wrong{"word", "0, 1\n1, much\n", ":2: \"much\" stands for curve: x, y, which must be a finite number"},
        Wrong{"not_a_heading", "nan, 1\n", ":1: \"nan\" stands for curve: x, y, which must be a finite number"},
        Wrong{"out_of_range", "0, 1\n1, -1\n", ":2: [mesh] curve = -1 must be more than 0 [m]"},
        Wrong{"not_increasing", "0, 1\n\n0, 2\n",
              ":3: [mesh] curve must be a list of [x, y] pairs with x increasing; 0 follows 0"}),
    [](const auto& wrong) { return wrong.param.name; });

TEST_F(GoodCase, NotesTheDigestOfAFile) {
  const auto read = [&](const std::string& text) {
    write(path("profile.csv"), text);
    CaseTable table = file("[mesh]\nprofile = \"profile.csv\"\n").table("mesh");
    table.file("profile", "a profile");
    return std::pair(table.settings(), table.resolved());
  };
  EXPECT_EQ(read("one"), read("one"));
  EXPECT_NE(read("one").first, read("other").first);  // or a sweep would take over speeds of another profile
  EXPECT_NE(read("one").second, read("other").second);
}

TEST_F(GoodCase, FallsBackToDefaultsAndTellsThem) {
  const CaseFile scene = file("[mesh]\nlength = 0.1\n");
  CaseTable table = scene.table("mesh");
  read_all(table);
  EXPECT_FALSE(table.has("count"));
  EXPECT_EQ(table.resolved(),
            "length = 0.1  # m\ncount = 3\nopen = false\nname = \"none\"\ncolour = \"red\"  # one of red, green\n"
            "speeds = [1]  # rpm\ncurve = [[0, 1]]  # m\n[mesh.inner]\ndepth = 1  # m\n");
}

TEST_F(GoodCase, KeepsEveryDigitInWhatItTells) {
  CaseTable table = file("[mesh]\nlength = 0.1234567890123456\n").table("mesh");
  table.number("length", std::nullopt, Range::any(), "");
  EXPECT_EQ(std::stod(table.resolved().substr(9)), 0.1234567890123456);
}

TEST_F(GoodCase, TellsWhatIsWrittenWhateverTheSpelling) {
  const std::string one = file("[mesh]\nlength = 0.1e-3  # m\ncount = 2\n").table("mesh").written();
  EXPECT_EQ(one, "count = 2\nlength = 0.0001\n");
  EXPECT_EQ(file("[ mesh ]\n  \"count\"=2\n  length = 1e-4\n").table("mesh").written(), one);
}

TEST_F(GoodCase, RejectsAValueBesideAnotherAtItsPlace) {
  CaseTable table = file("[mesh]\ninner_radius = 2.0\n").table("mesh");
  try {
    table.reject("inner_radius", "must be less than outer_radius");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), path("case.toml").string() + ":2:16: [mesh] inner_radius must be less than outer_radius");
  }
}

/// Symptom: a wrong value in a table was reported with the line of the case that names the table.
TEST_F(GoodCase, RejectsARowOfAListWhereItStands) {
  write(path("curve.csv"), "x, y\n0, 1\n\n1, 20\n");
  const auto message = [&](const std::string& curve, std::optional<std::size_t> row) -> std::string {
    CaseTable table = file("[mesh]\ncurve = " + curve + "\n").table("mesh");
    table.points("curve", std::nullopt, Range::any(), "m");
    try {
      table.reject("curve", "is too long", row);
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(message("\"curve.csv\"", 1), path("curve.csv").string() + ":4: [mesh] curve is too long");
  EXPECT_EQ(message("\"curve.csv\"", std::nullopt),
            path("case.toml").string() + ":2:9: [mesh] curve = \"curve.csv\" is too long");
  EXPECT_EQ(message("[[0, 1],\n[1, 20]]", 1), path("case.toml").string() + ":3:5: [mesh] curve is too long");
}

TEST_F(GoodCase, ASettingWithoutAValueRemovesItsKey) {
  write(path("case.toml"), "[mesh]\nlength = 2\n[mesh.inner]\ndepth = 3\n");
  const CaseFile scene(path("case.toml"), {"mesh.length=", "mesh.inner.depth = "});
  EXPECT_FALSE(scene.table("mesh").has("length"));
  EXPECT_EQ(scene.table("mesh").table("inner").number("depth", 1.0, Range::any(), "m"), 1.0);
  EXPECT_TRUE(scene.source().ends_with("# --set mesh.length=\n# --set mesh.inner.depth = \n"));
}

TEST_F(GoodCase, SettingsReplaceAndJoinItsKeys) {
  write(path("case.toml"), "[mesh]\nlength = 2\nname = \"x\"");
  const CaseFile scene(path("case.toml"), {"mesh.length=3.5", "mesh.speeds = [1, 2]", "mesh.inner.depth=7",
                                           "mesh.length=4", "simulate.sweep=\"up\""});
  CaseTable table = scene.table("mesh");
  EXPECT_EQ(table.number("length", std::nullopt, Range::positive(), "m"), 4.0);
  EXPECT_EQ(table.text("name", std::nullopt), "x");
  EXPECT_EQ(table.numbers("speeds", std::nullopt, Range::any(), "rpm"), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(table.table("inner").number("depth", 1.0, Range::any(), "m"), 7.0);
  EXPECT_NO_THROW(table.close());
  EXPECT_EQ(scene.table("simulate").text("sweep", std::nullopt), "up");
  EXPECT_EQ(scene.source(),
            "[mesh]\nlength = 2\nname = \"x\"\n# --set mesh.length=3.5\n# --set mesh.speeds = [1, 2]\n"
            "# --set mesh.inner.depth=7\n# --set mesh.length=4\n# --set simulate.sweep=\"up\"\n");
}

TEST_F(GoodCase, WrongSettingsAreRefusedByTheirText) {
  write(path("case.toml"), "[mesh]\nlength = 2\n");
  const auto message = [&](const std::string& setting) -> std::string {
    try {
      CaseTable table = CaseFile(path("case.toml"), {setting}).table("mesh");
      read_all(table);
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing was refused";
  };
  const std::string shape = ": must be TABLE.KEY=VALUE, in one line";
  for (const std::string setting : {"length", "length=2", "mesh.=2", ".length=2", "mesh..length=2", "mesh.length",
                                    "[mesh]", "# mesh.length=2", "mesh.length=1\nmesh.count=2"})
    EXPECT_EQ(message(setting), "--set " + setting + shape);
  const std::string bare = message("mesh.name=long");
  EXPECT_EQ(bare.substr(0, 45), "--set mesh.name=long: long is no TOML value (") << bare;
  EXPECT_NE(bare.find("; a text needs quotes: --set 'mesh.name=\"long\"'"), std::string::npos) << bare;
  const std::string absent = ": removes a key that the case does not have; give it a value, or leave this out";
  for (const std::string setting : {"mesh.name=", "mesh.inner.depth= ", "reduce.name="})
    EXPECT_EQ(message(setting), "--set " + setting + absent);
  EXPECT_EQ(message("mesh.lenght=2"),
            "--set mesh.lenght=2: unknown key \"lenght\" in [mesh] (did you mean length?); known: length, count, "
            "open, name, colour, speeds, "
            "curve, inner");
  EXPECT_EQ(message("mesh.inner.width=2"),
            "--set mesh.inner.width=2: unknown key \"width\" in [mesh.inner]; known: depth");
  EXPECT_EQ(message("mesh.length=-1"), "--set mesh.length=-1: [mesh] length = -1 must be more than 0 [m]");
  EXPECT_EQ(message("mesh.speeds=[1, -2]"), "--set mesh.speeds=[1, -2]: [mesh] speeds = -2 must be at least 0 [rpm]");
  EXPECT_EQ(message("mash.length=1").substr(0, 46), "--set mash.length=1: \"mash\" is not known here;");
}

TEST_F(GoodCase, ATableMadeBySettingsNeedsItsKeysToo) {
  write(path("case.toml"), "title = \"x\"\n");
  try {
    CaseTable table = CaseFile(path("case.toml"), {"mesh.count=2"}).table("mesh");
    read_all(table);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "--set mesh.count=2: [mesh] has no length, and it has no default; add it");
  }
}

TEST_F(GoodCase, AFileThatCannotBeReadIsNoWrongInput) {
  EXPECT_THROW(CaseFile(path("none.toml")), RunError);
  EXPECT_THROW(CaseFile{folder_}, RunError);
}

// A relative name is one beside the case file; its digest tells make that it has changed.
TEST_F(GoodCase, ReadsAFileBesideItAndTellsItsDigest) {
  write(path("other.toml"), "[mesh]\nblade = \"blade.txt\"\nmissing = \"none.txt\"\n");
  const auto told = [&](const std::string& text) {
    write(path("blade.txt"), text);
    CaseTable table = CaseFile(path("other.toml")).table("mesh");
    const NamedText file = table.file("blade", "a blade file");
    EXPECT_EQ(file.text, text);
    EXPECT_EQ(file.name, path("blade.txt").string());
    return table.resolved();
  };
  EXPECT_EQ(told("section").find("blade = \"blade.txt\"  # digest "), 0U);
  EXPECT_NE(told("section"), told("sections"));
  EXPECT_EQ(told("section"), told("section"));
  CaseTable table = CaseFile(path("other.toml")).table("mesh");
  EXPECT_THROW(table.file("missing", "a blade file"), RunError);
  const std::string mesh(5 << 20, '\xff');  // symptom: meshes above 4 MiB were refused
  write(path("blade.txt"), mesh);
  EXPECT_THROW(table.file("blade", "a blade file"), InputError);
  EXPECT_EQ(table.large_file("blade", "a mesh").text, mesh);
}

TEST(Range, HoldsItsEndsUnlessSaid) {
  EXPECT_FALSE(Range::positive().holds(0.0));
  EXPECT_TRUE(Range::at_least(0.0).holds(0.0));
  EXPECT_TRUE(Range::between(1.0, 2.0).holds(2.0));
  EXPECT_FALSE(Range::between(1.0, 2.0).holds(2.0000001));
  EXPECT_FALSE(Range::any().holds(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace
}  // namespace tiprub
