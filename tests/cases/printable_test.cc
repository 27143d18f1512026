// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/text.h"

#include <gtest/gtest.h>

namespace tiprub {
namespace {

using namespace std::string_literals;

TEST(Printable, EscapesWhatATerminalObeys) {
  EXPECT_EQ(printable("a\nb\t\x1b[31mred\r\x7f"), "a\\nb\\t\\x1b[31mred\\r\\x7f");
  EXPECT_EQ(printable("nothing\0at all"s), "nothing\\x00at all");
  EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b");  // C1's CSI
  EXPECT_EQ(printable("one\ntwo\x1b", LineBreaks::kept), "one\ntwo\\x1b");
}

TEST(Printable, EscapesWhatTurnsOrHidesText) {
  EXPECT_EQ(printable("a\u202egnp.exe"), "a\\xe2\\x80\\xaegnp.exe");
  for (const std::string hidden :
       {"\u061c", "\u200b", "\u200f", "\u2028", "\u2066", "\u2069", "\ufeff", "\U000e0041"})
    EXPECT_EQ(printable(hidden).substr(0, 2), "\\x") << hidden;
}

TEST(Printable, ShortensLongTextsBetweenLetters) {
  EXPECT_EQ(shortened("brief", 5), "brief");
  EXPECT_EQ(shortened("aaaabbbbcccc", 8), "aaaa ... cccc");
  EXPECT_EQ(shortened("aaaäbbbbäccc", 8), "aaa ... ccc");
}

TEST(Printable, KeepsUtf8Whole) {
  for (const std::string text : {"Gehäuse 0,13 µm", "蜗壳", "🌀", "\u00a0", ""}) EXPECT_EQ(printable(text), text);
}

TEST(Printable, EscapesBytesThatAreNoLetters) {
  EXPECT_EQ(printable("\x9b"), "\\x9b");
  EXPECT_EQ(printable("a\xc3"), "a\\xc3");
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");           // overlong
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a surrogate
  EXPECT_EQ(printable("\xf5z"), "\\xf5z");
}

TEST(Printable, QuotesEndAtTheLastQuote) {
  EXPECT_EQ(in_quotes("a\" b\\\n"), "\"a\\\" b\\\\\\n\"");
}

}  // namespace
}  // namespace tiprub
