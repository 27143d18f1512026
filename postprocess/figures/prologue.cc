// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/prologue.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

#include "postprocess/tables/table.h"

namespace tiprub {

namespace {

constexpr int value_digits = 12;
constexpr int table_digits = 8;  // more than a picture can show
constexpr const char* array_start = "array ";

/// With a point or an exponent, since gnuplot divides whole numbers as such.
std::string number(double value) {
  if (!std::isfinite(value)) return "NaN";
  const std::string text = significant(value, value_digits);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

/// "name = 3", or an array, which has at least one element in gnuplot.
struct Assignment {
  const std::string& name;

  std::string operator()(int value) const { return name + " = " + std::to_string(value) + "\n"; }
  std::string operator()(double value) const { return name + " = " + number(value) + "\n"; }
  std::string operator()(const std::string& text) const { return name + " = " + gnuplot_text(text) + "\n"; }
  std::string operator()(const DrawnRange& range) const {
    const DrawnRange drawn = range.widened();
    return name + "_low = " + number(drawn.low) + "\n" + name + "_high = " + number(drawn.high) + "\n";
  }
  std::string operator()(const std::vector<double>& values) const { return list(values, number); }
  std::string operator()(const std::vector<std::string>& texts) const { return list(texts, gnuplot_text); }

  template <typename Value, typename Written>
  std::string list(const std::vector<Value>& values, const Written& written) const {
    if (values.empty()) return array_start + name + "[1]\n";
    std::string text = array_start + name + "[" + std::to_string(values.size()) + "] = [";
    for (std::size_t i = 0; i < values.size(); ++i) text += (i > 0 ? ", " : "") + written(values[i]);
    return text + "]\n";
  }
};

void write_sheet(std::ostream& out, const Eigen::MatrixXd& rows) {
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    for (Eigen::Index k = 0; k < rows.cols(); ++k)
      out << (std::isfinite(rows(i, k)) ? significant(rows(i, k), table_digits) : "NaN")
          << (k + 1 < rows.cols() ? ',' : '\n');
}

std::string data_block(const ScriptTable& table) {
  std::ostringstream out;
  out << "$" << table.name << " << EOD\n";
  Eigen::Index rows = 0;
  for (std::size_t i = 0; i < table.sheets.size(); ++i) {
    if (i > 0) out << "\n\n";
    write_sheet(out, table.sheets[i]);
    rows += table.sheets[i].rows();
  }
  out << "EOD\n" << table.name << "_rows = " << rows << "\n";
  return out.str();
}

}  // namespace

DrawnRange DrawnRange::widened() const {
  constexpr double narrowest = 1e-4, smallest = 1e-12;
  const double least = std::max(narrowest * std::max(std::abs(low), std::abs(high)), smallest);
  if (high - low >= least) return *this;
  return low == 0 ? DrawnRange{0, least} : DrawnRange{low - 0.5 * least, high + 0.5 * least};
}

std::string gnuplot_text(const std::string& text) {
  std::string quoted = "'";
  for (const char letter : text) {
    if (std::strchr("_^{}@&~\\", letter) != nullptr && letter != '\0') quoted += '\\';
    if (letter == '\'')
      quoted += R"('."\047".')";  // neither doubled nor as it is: gnuplot 5.4 loses count of either
    else
      quoted += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
  }
  return quoted + "'";
}

std::string prologue(const Drawing& drawing) {
  // Names of files are ours, letters and underscores: nothing to protect.
  std::string text = "name = '" + drawing.name + "'\nscript = '" + drawing.script +
                     "'\nwidth = " + std::to_string(drawing.width) + "\nheight = " + std::to_string(drawing.height) +
                     "\n";
  for (const auto& [name, value] : drawing.values) text += std::visit(Assignment{name}, value);
  for (const ScriptTable& table : drawing.tables) text += data_block(table);
  return text + "load 'scripts/draw.gp'\n";
}

}  // namespace tiprub
