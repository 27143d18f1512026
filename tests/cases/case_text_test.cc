// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are no case are refused with one line, before the TOML reader sees them.
#include "cases/program/case_file.h"

#include <sys/stat.h>

#include <functional>

#include "tests/cases/temporary_folder.h"

namespace tiprub {
namespace {

using namespace std::string_literals;

class CaseTexts : public TemporaryFolder {
 protected:
  template <class Error>
  static std::string complaint(const std::function<void()>& work) {
    try {
      work();
    } catch (const Error& error) {
      return error.what();
    }
    return "nothing was refused";
  }
  std::string refusal(const std::string& text) {
    write(path("case.toml"), text);
    const std::string message = complaint<InputError>(
        [&] { CaseFile(path("case.toml")).table("mesh").integer("count", 1, Range::any(), ""); });
    EXPECT_EQ(message.substr(0, path("case.toml").string().size()), path("case.toml").string()) << message;
    return message.substr(std::min(message.size(), path("case.toml").string().size()));
  }
};

TEST_F(CaseTexts, MustBeFiles) {
  mkfifo(path("pipe").c_str(), 0600);
  const auto reading = [&](const std::filesystem::path& file) {
    return complaint<RunError>([&] { const CaseFile read(file); });
  };
  EXPECT_EQ(reading(path("none.toml")), path("none.toml").string() + ": can't be read: No such file or directory");
  EXPECT_EQ(reading(path("")), path("").string() + ": can't be read: it is a folder; name a case file");
  EXPECT_EQ(reading(path("pipe")), path("pipe").string() + ": can't be read: it is no file; name a case file");
  EXPECT_EQ(reading("/dev/zero"), "/dev/zero: can't be read: it is no file; name a case file");
}

/// Symptom: with the files in the wrong order, a model was said to be larger than 4 MiB.
TEST_F(CaseTexts, AreNoModels) {
  write(path("model.h5"), "\x89HDF\r\n\x1a\n and more");
  EXPECT_EQ(complaint<InputError>([&] { const CaseFile read(path("model.h5")); }),
            path("model.h5").string() + ": is an HDF5 file; name a case file here");
}

TEST_F(CaseTexts, MustNotBeHuge) {
  write(path("case.toml"), "");
  std::filesystem::resize_file(path("case.toml"), std::uintmax_t(1) << 40);
  EXPECT_EQ(complaint<InputError>([&] { const CaseFile read(path("case.toml")); }),
            path("case.toml").string() + ": is larger than 4 MiB; name a case file");
}

TEST_F(CaseTexts, MustBeUtf8) {
  EXPECT_EQ(refusal("title = \"\"\n[me\xffsh]\n"),
            ":2:4: the byte \\xff is no letter of UTF-8; is this a case file, saved as UTF-8?");
  EXPECT_EQ(refusal("[mesh]\0\n"s),
            ":1:7: the byte \\x00 is no letter of UTF-8; is this a case file, saved as UTF-8?");
  EXPECT_EQ(refusal("\xff\xfe[\0"s), ": is written in UTF-16; save it as UTF-8");
  write(path("case.toml"), "\xef\xbb\xbf[mesh]\ncount = 2\n");  // a byte order mark, as some editors leave it
  EXPECT_EQ(CaseFile(path("case.toml")).table("mesh").integer("count", 1, Range::any(), ""), 2);
}

std::string repeated(const std::string& word, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += word;
  return text;
}

/// The TOML reader took stack for each part of a key, without end: a segmentation fault.
TEST_F(CaseTexts, MustNotNestWithoutEnd) {
  const std::string refused = "a key of more than 16 parts; no case has one";
  EXPECT_EQ(refusal("[" + repeated("a.", 50000) + "a]\n"), ":1:33: " + refused);
  EXPECT_EQ(refusal("\n" + repeated("a . ", 50000) + "a = 1\n"), ":2:63: " + refused);
  EXPECT_NE(refusal("[mesh]\n" + repeated("\"a,b\".", 50000) + "a = 1\n").find(refused), std::string::npos);
  EXPECT_NE(refusal("x = { s = '''\nit's''''', " + repeated("a.", 50000) + "a = 1, t = '' }\n").find(refused),
            std::string::npos);
  EXPECT_NE(refusal("x = \"\\\"\"\n" + repeated("a.", 50000) + "a = \"\"").find(refused), std::string::npos);
  for (const std::string part : {"[", "{a=", "{a.a.a.a.a.a.a.a="})
    EXPECT_NE(refusal("x = " + repeated(part, 50000)).find("not TOML: "), std::string::npos) << part;
  EXPECT_EQ(complaint<InputError>([&] {
              write(path("case.toml"), "");
              CaseFile(path("case.toml"), {repeated("a.", 50000) + "a=1"});
            }).find("--set "),
            0U);
}

TEST_F(CaseTexts, MayHoldDotsElsewhere) {
  const std::string dots = repeated("a.", 40);
  const std::string numbers = repeated("1.5, ", 40);
  write(path("case.toml"), "title = \"" + dots + "\" # " + dots + "\n[mesh]\nlist = [" + numbers + "]\ntext = '''" +
                               dots + "\n" + dots + "'''\ndate = 1979-05-27T00:32:00.999\n");
  EXPECT_EQ(CaseFile(path("case.toml")).title(), dots);
}

/// "error: stod".
TEST_F(CaseTexts, MayHoldSubnormalNumbers) {
  write(path("case.toml"), "[mesh]\nsmall = 1e-310\n");
  CaseTable table = CaseFile(path("case.toml")).table("mesh");
  EXPECT_EQ(table.number("small", std::nullopt, Range::any(), ""), 1e-310);
  EXPECT_NE(table.resolved(), "");
  EXPECT_NE(refusal("[mesh]\ncount = 1e-310\n").find("not a whole number"), std::string::npos);
}

TEST_F(CaseTexts, ResolveToTheSameForAnotherSpelling) {
  const auto resolved = [&](const std::string& text) {
    write(path("case.toml"), text);
    return CaseFile(path("case.toml")).resolved("mesh", [](CaseTable& table) {
      table.number("length", 2.0, Range::any(), "m");
      table.text("name", "none");
      table.close();
    });
  };
  EXPECT_EQ(resolved("[mesh]\n"), "[mesh]\nlength = 2  # m\nname = \"none\"\n");
  EXPECT_EQ(resolved(" [ 'mesh' ] # remark\n\t\"length\"=20e-1\n"), resolved("[mesh]\n"));
  EXPECT_EQ(resolved("mesh = {name = \"a\\nb\\\"\"}"), "[mesh]\nlength = 2  # m\nname = \"a\\nb\\\"\"\n");
}

/// A copy of a case is compared with another one by values.
TEST(WrittenKeys, AreTheSameForEverySpelling) {
  const std::string plain =
      "[reduce]\ndensity = 4430.0\nyoung_modulus = 114e9\n[casing]\nclearance = [[0.0, 2e-4]]\n";
  const std::string other =
      "title = 'range [9000 .. 50000'\n[\"reduce\"]\n\"density\" = 4_430  # kg/m^3\nyoung_modulus = 1.14e+11\n"
      "casing.clearance = 1\n[casing]\nclearance = [\n  [0, 0.0002],\n]\n";
  const auto written = written_keys(plain);
  EXPECT_EQ(written.at("reduce.density"), "4430");
  EXPECT_EQ(written.at("casing.clearance"), "[[0, 0.0002]]");
  const std::vector<DifferingKey> differing = differing_keys(plain, other);
  for (const DifferingKey& key : differing)
    EXPECT_TRUE(key.key == "title" || key.key == "reduce.casing.clearance") << key.key;
  EXPECT_EQ(differing.size(), 2U);
}

/// Symptom: a bracket in a title hid that the density was another one; and 4430 was told to differ from 4430.0.
TEST(WrittenKeys, TellWhatAFileWasMadeWith) {
  const std::string made = "[reduce]\ndensity = 4430.0\nmodes = 3\n";
  const auto otherwise = [&](const std::string& text) {
    return made_otherwise("model.h5", made, text, {"reduce."}, "so be it").lines;
  };
  EXPECT_EQ(otherwise("title = 'a]'\n[reduce]\n\"density\" = 7800\n"),
            "\nmodel.h5 was made with reduce.density = 4430, and the case has 7800; so be it");
  EXPECT_EQ(otherwise("[reduce]\ndensity = 4430\n[mesh]\nmodes = 4\n"), "");
}

TEST(WrittenKeys, HoldTheSettingsOfTheCommandLine) {
  const auto written =
      written_keys("[mesh]\na = 1\nb = 2\n# --set mesh.a = 3\n# --set mesh.b=\n# --set mesh.c=\"x]\"\n");
  EXPECT_EQ(written, (std::map<std::string, std::string>{{"mesh.a", "3"}, {"mesh.c", "\"x]\""}}));
  EXPECT_TRUE(written_keys("this is no case").empty());
}

}  // namespace
}  // namespace tiprub
