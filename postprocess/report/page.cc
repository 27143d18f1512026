// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/report/report.h"

#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>

#include "embedded/column_list.h"
#include "embedded/page_files.h"
#include "embedded/page_scripts.h"
#include "embedded/page_styles.h"
#include "embedded/three_library.h"
#include "postprocess/compare/comparison.h"
#include "postprocess/explore/page_data.h"
#include "postprocess/fields/field_vtu.h"
#include "postprocess/records/error_budget_record.h"
#include "postprocess/records/exactness_record.h"
#include "postprocess/records/study_records.h"
#include "postprocess/tables/packing.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

constexpr const char* response_figure_name = "response";
constexpr const char* dot = " \xC2\xB7 ";

/// Text with the characters replaced that have a meaning in HTML.
std::string escaped(const std::string& text) {
  static const std::map<char, const char*> meant = {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
  std::string safe;
  for (const char letter : text)
    if (const auto found = meant.find(letter); found != meant.end())
      safe += found->second;
    else if (std::iscntrl(static_cast<unsigned char>(letter)) != 0 && letter != '\n' && letter != '\t')
      safe += "\xEF\xBF\xBD";  // U+FFFD, where a control character was: it has no place in a page
    else
      safe += letter;
  return safe;
}

std::string shown(const Cell& cell) {
  constexpr int digits = 4;
  constexpr double large = 1e3, huge = 1e9;  // whole numbers read better between them
  if (const auto* value = std::get_if<double>(&cell)) {
    if (!std::isfinite(*value)) return "";
    if (std::abs(*value) >= large && std::abs(*value) < huge) return fixed(*value, 0);
    return significant(*value, digits);
  }
  if (const auto* whole = std::get_if<int>(&cell)) return std::to_string(*whole);
  const auto* text = std::get_if<std::string>(&cell);
  return text ? escaped(*text) : "";
}

bool looks_numeric(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789.+-/ e") == std::string::npos;
}

/// Columns that a narrow screen leaves out, so that those to decide by stay in sight.
bool is_minor(const std::string& column) {
  constexpr std::string_view minor =
      "|lies between [rpm]|along the normal [mm]|moves the speed most|moves |u| most|moves the stress most|"
      "peak lies between [rpm]|node|family|direction|detuning [%]|other waves|places rubbed, leading / trailing edge|"
      "predicted by|spin [MPa]|a node moves by up to [mm]|alternating [MPa]|mean [MPa]|";
  return minor.find("|" + column + "|") != std::string_view::npos;
}

/// The style of a cell: numbers are aligned to the right, and short words stay on one line.
std::string class_of(const std::string& value) {
  constexpr std::size_t short_text = 16;
  if (looks_numeric(value)) return "n";
  if (value == "matters" || value.rfind("outside", 0) == 0) return "s bad";
  if (value == "negligible" || value == "inside") return "s good";
  return value.size() <= short_text ? "s" : "";
}

/// ` class="..."` of a cell, or nothing.
std::string class_attribute(const std::string& look, bool minor) {
  const std::string all = look + (minor ? (look.empty() ? "minor" : " minor") : "");
  return all.empty() ? all : " class=\"" + all + "\"";
}

/// What a column means; empty if columns.json does not list it.
std::string help_of(const std::string& column) {
  static const auto list = nlohmann::json::parse(embedded::column_list::columns_json, nullptr, true, true);
  return escaped(list.value(column, std::string()));
}

/// What the columns of a table mean, one after the other, for paper and where no script shows it at the column
/// itself.
std::string column_list(const std::vector<std::string>& columns) {
  std::string text;
  for (const std::string& name : columns)
    if (const std::string help = help_of(name); !help.empty())
      text += "<dt>" + escaped(name) + "</dt><dd>" + help + "</dd>\n";
  return text.empty()
             ? text
             : "<details class=\"columns\"><summary>What the columns mean</summary><dl>" + text + "</dl></details>\n";
}

/// Which columns a narrow screen shows.
enum class Screen {
  all_columns,   ///< the table scrolls
  main_columns,  ///< all but those of is_minor()
};

/// A table with a head; numbers are aligned to the right, texts to the left.
std::string html_table(const Table& table, Screen narrow = Screen::all_columns) {
  const auto minor = [&](std::size_t column) {
    return narrow == Screen::main_columns && is_minor(table.header[column]);
  };
  std::string text = "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"Table\"><table><thead><tr>";
  for (std::size_t k = 0; k < table.header.size(); ++k) {
    const std::string& name = table.header[k];
    const std::string help = help_of(name);
    text += "<th scope=\"col\"" + class_attribute("", minor(k)) + (help.empty() ? help : " title=\"" + help + "\"") +
            ">" + escaped(name) + "</th>";
  }
  text += "</tr></thead><tbody>\n";
  for (const auto& row : table.rows) {
    text += "<tr>";
    for (std::size_t k = 0; k < row.size(); ++k) {
      const std::string value = shown(row[k]);
      text += (k == 0 ? "<th scope=\"row\"" : "<td") + class_attribute(class_of(value), minor(k)) + ">" + value +
              (k == 0 ? "</th>" : "</td>");
    }
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n" + column_list(table.header);
}

/// A template without its first line, the licence, which stays with the source.
std::string without_first_line(std::string_view text) {
  return std::string(text.substr(text.find('\n') + 1));
}

/// A picture as a data URL for `src="..."`: its text with a few characters replaced, a quarter shorter than base 64.
std::string svg_url(const std::string& svg) {
  const std::size_t head = svg.find("<defs>");  // the style of dark pages goes before all that it applies to
  const std::string styled = svg.substr(0, head) + "<style>" + without_first_line(embedded::page_files::picture_css) +
                             "</style>" + (head == std::string::npos ? "" : svg.substr(head));
  std::string url = "data:image/svg+xml,";
  for (const char letter : styled) {
    const std::string_view replaced = "%#\"<>&\n\t";
    if (replaced.find(letter) == std::string_view::npos) {
      url += letter;
      continue;
    }
    char code[4];
    std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned>(static_cast<unsigned char>(letter)));
    url += code;
  }
  return url;
}

/// A file of the report's folder. The page also travels without it, so that a link could be dead.
std::string named(const std::string& file) {
  return "<code>" + file + "</code>";
}

std::string item(const std::string& text) {
  return "<li>" + escaped(text) + "</li>\n";
}

std::string paragraphs(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += "<p>" + escaped(line) + "</p>";
  return text;
}

/// Explains the stresses of the critical speeds, or why there are none.
std::string stress_note(const Study& study, const FieldResults& fields) {
  if (study.critical.empty()) return "There is no critical speed at which stress could be given.";
  if (!fields.has_stress())
    return "Stress at the peaks is left out, because it requires full fields (--fields) and a response that holds "
           "the states of the rotor.";
  const bool cycles = fields.has_cycles();
  return filled(without_first_line(embedded::page_files::stress_html),
                {{"when", cycles ? "over all recorded samples of the cycle"
                                 : "at the recorded sample with the largest contact force (the response holds no "
                                   "whole cycle)"},
                 {"patch", fixed(fields.zone_width * mm_per_m, 1)},
                 {"rim", fixed(fields.zone_width * mm_per_m, 1)}});
}

/// The first line as it is, the others as a list.
std::string in_lines(const std::string& answer) {
  std::istringstream lines(answer);
  std::string text, first;
  std::getline(lines, first);
  for (std::string line; std::getline(lines, line);) text += item(line);
  return escaped(first) + (text.empty() ? text : "<ul>" + text + "</ul>");
}

std::string answers(const std::vector<Answer>& list) {
  std::string text = "<dl>";
  for (const auto& [question, answer] : list)
    text += "<dt>" + escaped(question) + "</dt><dd>" + in_lines(answer) + "</dd>\n";
  return text + "</dl>\n";
}

std::string scene_items(const Study& study, const FieldResults& fields, const std::vector<SceneNeed>& needs) {
  const SimulatedScene& scene = study.response.scene;
  std::istringstream lines(scene.scope + "\n" + fields.scope);
  std::string text;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) text += item(line);
  text += item(counted(static_cast<std::size_t>(scene.sector_count), "sector") + ", " +
               counted(static_cast<std::size_t>(study.model.contact.size()), name_of(study.model.contact.kind)) +
               (study.model.contact.splitter_nodes > 0 ? " on a main blade and its splitter, " : " on each blade, ") +
               counted(static_cast<std::size_t>(scene.lobes), "lobe") + ", " + running_clearances(study.response) +
               "; stiffness under spin: " + study.model.stiffness_under_spin() + ".");
  for (const Treatment treatment : {Treatment::modelled, Treatment::simplified, Treatment::left_out})
    if (const std::string effects = effects_in_words(needs, treatment); !effects.empty()) text += item(effects + ".");
  return text;
}

/// A figure with its heading, so that a printed page keeps them together. `live`: an element that the page's scripts
/// draw into instead.
std::string figure_section(const Figure& figure, const std::filesystem::path& folder, const std::string& live = "") {
  const std::string& name = figure.drawing.name;
  return filled(without_first_line(embedded::page_files::figure_html),
                {{"name", name},
                 {"title", escaped(figure.title)},
                 {"caption", escaped(figure.caption)},
                 {"live", live},
                 {"class", live.empty() ? "" : " class=\"twin\""},
                 {"picture", svg_url(read_text(folder / "figures" / (name + ".svg")))}});
}

/// All figures except the response, which stands at the top of the page.
std::string figure_sections(const std::vector<Figure>& figures, const std::filesystem::path& folder) {
  std::string text;
  for (const Figure& figure : figures)
    if (figure.drawing.name != response_figure_name) text += figure_section(figure, folder);
  return text;
}

std::string response_section(const std::vector<Figure>& figures, const std::filesystem::path& folder) {
  for (const Figure& figure : figures)
    if (figure.drawing.name == response_figure_name)
      return figure_section(figure, folder, "<div id=\"live-response\" class=\"live-only\"></div>\n");
  return "";
}

std::string figure_links(const std::vector<Figure>& figures) {
  std::string text;
  for (const Figure& figure : figures)
    text += "<li><a href=\"#" + figure.drawing.name + "\">" + escaped(figure.title) + "</a></li>\n";
  return text;
}

/// The files one after the other.
template <std::size_t count>
std::string joined(const std::array<std::pair<std::string_view, std::string_view>, count>& files) {
  std::string text;
  for (const auto& [name, file] : files) text += without_first_line(file);
  return text;
}

std::string record(const Study& study, const FieldResults& fields, const std::string& case_text) {
  const auto folded = [](const std::string& title, const std::string& body, const std::string& file = "") {
    return "<details><summary>" + title + "</summary>" + body +
           (file.empty() ? "" : "<p class=\"sub\">" + named(file) + "</p>") + "</details>\n";
  };
  const auto listing = [](const std::string& text) { return "<pre>" + escaped(text) + "</pre>"; };
  return folded("Every speed: how steady, how exact", html_table(speed_record(study, fields)), "speeds.csv") +
         folded("What the linear rules are worth", html_table(rule_score_record(study.rules)), "linear_rules.csv") +
         folded("What the linear rules list", html_table(linear_criterion_record(study)), "linear_criterion.csv") +
         (study.sweeps.empty()
              ? std::string()
              : folded("From rest, upwards, downwards",
                       html_table(sweep_record(study.response.speeds, study.amplitudes, study.sweeps)),
                       "sweeps.csv")) +
         (study.response.branches.empty()
              ? std::string()
              : folded("Branches of orbits", html_table(branch_record(study.response.branches)), "branches.csv")) +
         folded("How the contact drifts with speed", html_table(drift_record(study.contact, study.model.contact)),
                "contact_drift.csv") +
         folded("The case file", listing(case_text), "case.toml") +
         folded("Where the response comes from", listing(study.response.scene.provenance)) +
         folded("Where the model comes from", listing(study.model.provenance));
}

/// What moves the critical speeds; empty without error budgets.
std::string budget_section(const Study& study, const FieldResults& fields) {
  const Table table = error_budget_record(study, fields);
  return table.rows.empty()
             ? ""
             : filled(without_first_line(embedded::page_files::budget_html), {{"table", html_table(table)}});
}

/// Bands and worst peaks of this report and of others, and the critical speeds beside those of each; empty if there
/// are no others.
std::string comparison_section(const ReportContents& contents) {
  if (contents.others.empty()) return "";
  std::string each;
  for (const ReportNumbers& other : contents.others)
    each += (contents.others.size() > 1 ? "<h3>" + escaped(other.name) + "</h3>\n" : "") + "<p>" +
            escaped(comparison_in_words(contents.numbers, other)) + "</p>\n" +
            html_table(comparison_record(contents.numbers, other));
  return filled(without_first_line(embedded::page_files::compared_html),
                {{"others", escaped(listed(contents.others, ", ", &ReportNumbers::name))},
                 {"reports", html_table(reports_record(contents.numbers, contents.others))},
                 {"each", each}});
}

/// The place of the 3-D wheel in the page; empty without full fields.
std::string wheel_section(const std::optional<FieldStudy>& fields) {
  if (!fields) return "";
  std::vector<std::string> files = {"modes_wheel.vtu", "modes_sector.vtu"};
  if (fields->has_instant) files.insert(files.end(), {"contact_wheel.vtu", "contact_sector.vtu"});
  if (moving_at_instant(*fields)) files.emplace_back("motion_sector.pvd");
  const std::string links = listed(files, dot, [](const std::string& file) { return named("fields/" + file); });
  const std::string peaks =
      fields->peaks.empty() ? "" : " Where the stress is largest, in full: " + named("stress_peaks.csv") + ".";
  return filled(without_first_line(embedded::page_files::wheel_html),
                {{"vtu_links", links}, {"stress_peaks_link", peaks}});
}

/// The data of the 3-D wheel, with the library that draws it.
std::string wheel_data_section(const ReportContents& contents) {
  if (!contents.fields) return "";
  const auto& [three, controls] = embedded::three_library::files;
  const auto data = [](const std::string& id, const std::string& text) {
    return "<script type=\"text/plain\" id=\"" + id + "\">" + text + "</script>\n";
  };
  return data("wheel-data", wheel_data(contents.study.response, contents.study.model.contact, *contents.fields)) +
         std::string(embedded::page_files::three_licence_html) +
         data("three-library", base64(deflated(std::string(three.second) + "\n" + std::string(controls.second))));
}

}  // namespace

std::string report_page(const ReportContents& contents, const std::filesystem::path& folder) {
  const auto& [study, title, case_text, full_fields, fields, needs, figures, numbers, others, run] = contents;
  const bool none = study.critical.empty();
  return filled(
      without_first_line(embedded::page_files::page_html),
      {{"title", escaped(title.empty() ? "Blade-tip rub" : title)},
       {"style", joined(embedded::page_styles::files)},
       {"script", joined(embedded::page_scripts::files)},
       {"made_by", escaped(run.in_words().front().text)},
       {"speed_low", rpm_text(study.range.low)},
       {"speed_high", rpm_text(study.range.high)},
       {"decision", none ? "" : html_table(critical_speed_budgets(study, fields), Screen::main_columns)},
       {"verdict", answers(verdict(study, fields, needs))},
       {"brief_scene", answers(scene_in_brief(study))},
       {"response", response_section(figures, folder)},
       {"summary", paragraphs(summary(study))},
       {"critical_speeds", none ? "<p>None.</p>" : html_table(critical_speed_motions(study), Screen::main_columns)},
       {"critical_stresses",
        none || !fields.has_stress() ? "" : html_table(critical_speed_stresses(study, fields), Screen::main_columns)},
       {"stress_note", stress_note(study, fields)},
       {"budget", budget_section(study, fields)},
       {"figure_links", figure_links(figures)},
       {"scene", scene_items(study, fields, needs)},
       {"exactness", html_table(exactness_record(study))},
       {"needs", html_table(scene_needs_record(needs))},
       {"figures", figure_sections(figures, folder)},
       {"record", record(study, fields, case_text)},
       {"speed_data", speed_data(study, fields, others)},
       {"comparison", comparison_section(contents)},
       {"wheel_section", wheel_section(full_fields)},
       {"wheel_link", full_fields ? "<li class=\"live-only\"><a href=\"#in-motion\">3-D</a></li>" : ""},
       {"wheel_data", wheel_data_section(contents)},
       {"run", answers(run.in_words())}});
}

}  // namespace tiprub::postprocess
