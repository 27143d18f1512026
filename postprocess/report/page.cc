// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/report/page.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "embedded/page_files.h"
#include "embedded/page_scripts.h"
#include "embedded/page_styles.h"
#include "embedded/three_library.h"
#include "postprocess/compare/comparison.h"
#include "postprocess/explore/speed_data.h"
#include "postprocess/explore/wheel_data.h"
#include "postprocess/records/critical_speed_record.h"
#include "postprocess/records/exactness_record.h"
#include "postprocess/records/study_records.h"
#include "postprocess/report/html.h"
#include "postprocess/report/summary.h"
#include "postprocess/report/verdict.h"
#include "postprocess/tables/packing.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

constexpr const char* response_figure_name = "response";
constexpr const char* dot = " \xC2\xB7 ";

/// The licence stays with the source.
std::string without_first_line(std::string_view text) {
  return std::string(text.substr(text.find('\n') + 1));
}

/// To a file of the report's folder.
std::string link(const std::string& file, const std::string& words) {
  return "<a href=\"" + file + "\">" + words + "</a>";
}

/// Likewise, by its name.
std::string link(const std::string& file) {
  return link(file, std::filesystem::path(file).filename().string());
}

std::string item(const std::string& text) {
  return "<li>" + html::escaped(text) + "</li>\n";
}

std::string paragraphs(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += "<p>" + html::escaped(line) + "</p>";
  return text;
}

/// What the stresses of the critical speeds are, or why there are none.
std::string stress_note(const FieldResults& fields) {
  if (!fields.has_stress())
    return "Stress at the peaks is left out: it takes full fields (--fields) and a response that holds the rotor's "
           "state.";
  const std::string patch = fixed(fields.tip_patch * mm_per_m, 1), rim = fixed(fields.clamp_rim * mm_per_m, 1);
  return "Vibration, spin, both: the largest von Mises stress on the wheel " +
         std::string(fields.has_cycles() ? "over all recorded samples of the cycle"
                                         : "at the recorded sample with the largest contact force (the response "
                                           "holds no whole cycle)") +
         ", of the vibration alone, of the static shape under spin, of both together. Left out, and reported apart "
         "in the full table, are the tip patch, " +
         patch + " mm from the tip line, where the casing pushes at points, and the clamp's rim, " + rim +
         " mm from its edge: there the exact stress is unbounded, and grows as the mesh is refined. So it is along a "
         "root without a fillet, which is not left out." +
         (fields.has_cycles()
              ? " Mean: von Mises stress of the mean tensor over the cycle, spin included; "
                "alternating: the largest of the tensor minus that mean; Goodman: alternating over the "
                "endurance limit plus mean over the ultimate strength, 1 is the limit."
              : "");
}

std::string answers(const std::vector<Answer>& list) {
  std::vector<std::pair<std::string, std::string>> entries;
  for (const Answer& answer : list) entries.emplace_back(answer.question, answer.text);
  return html::definitions(entries);
}

std::string scene_items(const Study& study, const FieldResults& fields, const std::vector<SceneNeed>& needs) {
  const SimulatedScene& scene = study.response.scene;
  std::istringstream lines(scene.scope + "\n" + fields.scope);
  std::string text;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) text += item(line);
  text += item(counted(static_cast<std::size_t>(scene.sector_count), "sector") + ", " +
               counted(static_cast<std::size_t>(study.model.contact.size()), name_of(study.model.contact.kind)) +
               (study.model.contact.splitter_nodes > 0 ? " on a main blade and its splitter, " : " a blade, ") +
               counted(static_cast<std::size_t>(scene.lobes), "lobe") + ", " + running_clearances(study.response) +
               "; stiffness under spin: " + study.model.stiffness_under_spin() + ".");
  for (const Treatment treatment : {Treatment::modelled, Treatment::simplified, Treatment::left_out})
    if (const std::string effects = effects_in_words(needs, treatment); !effects.empty()) text += item(effects + ".");
  return text;
}

/// With its heading, so that neither stands alone on a printed page. `live`: where the page's scripts draw instead.
std::string figure_section(const Figure& figure, const std::filesystem::path& folder, const std::string& live = "") {
  const std::string &name = figure.drawing.name, file = "figures/" + name;
  return "<section><h2 id=\"" + name + "\">" + html::escaped(figure.title) + "</h2>\n" + live + "<figure" +
         (live.empty() ? "" : " class=\"twin\"") + "><img alt=\"" + html::escaped(figure.title) + ": " +
         html::escaped(figure.seen.empty() ? figure.caption : figure.seen) + "\" src=\"" +
         html::svg_url(read_text(folder / (file + ".svg"))) + "\"><figcaption>" + html::escaped(figure.caption) +
         " " + link(file + ".csv", "data") + dot + link(file + ".svg", "SVG") + dot + link(file + ".png", "PNG") +
         "</figcaption></figure></section>\n";
}

/// All but the response, which stands at the top of the page.
std::string figure_sections(const std::vector<Figure>& figures, const std::filesystem::path& folder) {
  std::string text;
  for (const Figure& figure : figures)
    if (figure.drawing.name != response_figure_name) text += figure_section(figure, folder);
  return text;
}

std::string response_section(const std::vector<Figure>& figures, const std::filesystem::path& folder) {
  const auto response = std::find_if(figures.begin(), figures.end(), [](const Figure& figure) {
    return figure.drawing.name == response_figure_name;
  });
  return response == figures.end()
             ? ""
             : figure_section(*response, folder, "<div id=\"live-response\" class=\"live-only\"></div>\n");
}

std::string figure_links(const std::vector<Figure>& figures) {
  std::string text;
  for (const Figure& figure : figures)
    text += "<li><a href=\"#" + figure.drawing.name + "\">" + html::escaped(figure.title) + "</a></li>\n";
  return text;
}

/// Small files, each with one task, one after the other.
template <std::size_t count>
std::string joined(const std::array<std::pair<std::string_view, std::string_view>, count>& files) {
  std::string text;
  for (const auto& [name, file] : files) text += without_first_line(file);
  return text;
}

std::string record(const Study& study, const ReportSource& source) {
  const auto folded = [](const std::string& title, const std::string& body, const std::string& file = "") {
    return "<details><summary>" + title + "</summary>" + body +
           (file.empty() ? "" : "<p class=\"sub\">" + link(file) + "</p>") + "</details>\n";
  };
  const auto listing = [](const std::string& text) { return "<pre>" + html::escaped(text) + "</pre>"; };
  return folded("Every speed: how steady, how exact", html::table(speed_record(study)), "speeds.csv") +
         folded("What the linear rules are worth", html::table(rule_score_record(study.rules)), "linear_rules.csv") +
         folded("What the linear rules list", html::table(linear_criterion_record(study)), "linear_criterion.csv") +
         (study.sweeps.empty()
              ? std::string()
              : folded("From rest, upwards, downwards",
                       html::table(sweep_record(study.response.speeds, study.amplitudes, study.sweeps)),
                       "sweeps.csv")) +
         (study.response.branches.empty()
              ? std::string()
              : folded("Branches of orbits", html::table(branch_record(study.response.branches)), "branches.csv")) +
         folded("How the contact drifts with speed", html::table(drift_record(study.contact, study.model.contact)),
                "contact_drift.csv") +
         folded("The case file", listing(source.case_text), "case.toml") +
         folded("Where the response comes from", listing(study.response.scene.provenance)) +
         folded("Where the model comes from", listing(study.model.provenance));
}

/// Critical speeds beside those of another report, where one was given.
std::string comparison_section(const ReportContents& contents) {
  if (!contents.other) return "";
  return "<section><h2 id=\"compared\">Compared with " + html::escaped(contents.other->name) + "</h2>\n" +
         html::table(comparison_record(contents.numbers, *contents.other)) +
         "<p class=\"sub\">Critical speeds that the same wave makes side by side, the others alone; shifts and "
         "changes from "
         "there to here. As a table: " +
         link("comparison.csv") +
         ". The other response is in the views above, and its maps can be chosen there; as pictures: " +
         link("#comparison", "both responses") + ", " + link("#comparison_map", "both maps") + ".</p></section>\n";
}

/// The wheel in 3-D, where there is one to draw: its place in the page.
std::string wheel_section(const std::optional<FieldStudy>& fields) {
  if (!fields) return "";
  std::vector<std::string> files = {"modes_wheel.vtu", "modes_sector.vtu"};
  if (fields->has_instant) files.insert(files.end(), {"contact_wheel.vtu", "contact_sector.vtu"});
  if (moving_at_instant(*fields)) files.emplace_back("motion_sector.pvd");
  std::string links;
  for (const std::string& file : files) links += (links.empty() ? "" : dot) + link("fields/" + file);
  const std::string peaks =
      fields->peaks.empty() ? "" : " Where the stress is largest, in full: " + link("stress_peaks.csv") + ".";
  return html::filled(without_first_line(embedded::page_files::wheel_html),
                      {{"vtu_links", links}, {"stress_peaks_link", peaks}});
}

/// Its data, with the library that draws it.
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
  const auto& [study, source, full_fields, fields, needs, figures, numbers, other, run] = contents;
  const bool none = study.critical.empty();
  return html::filled(
      without_first_line(embedded::page_files::page_html),
      {{"title", html::escaped(source.title.empty() ? "Blade-tip rub" : source.title)},
       {"style", joined(embedded::page_styles::files)},
       {"script", joined(embedded::page_scripts::files)},
       {"speed_low", rpm_text(study.range.low)},
       {"speed_high", rpm_text(study.range.high)},
       {"verdict", answers(verdict(study, fields, needs))},
       {"brief_scene", answers(scene_in_brief(study))},
       {"response", response_section(figures, folder)},
       {"summary", paragraphs(summary(study, fields))},
       {"critical_speeds", none ? "<p>None.</p>" : html::table(critical_speed_motions(study))},
       {"critical_stresses", none || !fields.has_stress() ? "" : html::table(critical_speed_stresses(study, fields))},
       {"stress_note", stress_note(fields)},
       {"figure_links", figure_links(figures)},
       {"scene", scene_items(study, fields, needs)},
       {"exactness", html::table(exactness_record(study))},
       {"needs", html::table(scene_needs_record(needs))},
       {"figures", figure_sections(figures, folder)},
       {"record", record(study, source)},
       {"speed_data", speed_data(study, other)},
       {"comparison", comparison_section(contents)},
       {"wheel_section", wheel_section(full_fields)},
       {"wheel_link", full_fields ? "<li class=\"live-only\"><a href=\"#in-motion\">3-D</a></li>" : ""},
       {"wheel_data", wheel_data_section(contents)},
       {"run", answers(run.in_words())}});
}

}  // namespace tiprub
