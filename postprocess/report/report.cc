// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/report/report.h"

#include "cases/program/command_line.h"
#include "postprocess/report/exactness.h"
#include "postprocess/report/html.h"
#include "postprocess/report/result_tables.h"
#include "postprocess/report/verdict.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

/// By every model and every casing of this chain, so that no stage's file says it.
constexpr const char* left_out_always =
    "left out: friction at the tips, a casing that yields or wears, Coriolis terms, differences between the blades, "
    "heat and gas";
constexpr const char* dot = " \xC2\xB7 ";

/// To a file of the report's folder.
std::string link(const std::string& file, const std::string& words) {
  return "<a href=\"" + file + "\">" + words + "</a>";
}

/// Likewise, by its name.
std::string link(const std::string& file) {
  return link(file, std::filesystem::path(file).filename().string());
}

/// What the stresses of the critical speeds are, or why there are none.
std::string stress_note(const Study& study) {
  if (!has_stress(study))
    return "Stress at the peaks is left out: it takes full fields (--fields) and a response that holds the rotor's "
           "state.";
  return "Vibration, spin, both: the largest von Mises stress on the wheel at the recorded sample with the largest "
         "contact force, of the vibration alone, of the static shape under spin, of both together. At the contact "
         "nodes, where the casing pushes at points, at re-entrant corners and at the clamp's rim it grows as the "
         "mesh "
         "is refined.";
}

std::string summary_section(const Study& study) {
  std::string text = "<div class=\"lead\">";
  for (const std::string& line : verdict(study)) text += "<p>" + html::escaped(line) + "</p>";
  text += "</div>\n<h2 id=\"critical\">Critical speeds</h2>\n";
  if (study.critical.empty())
    text += "<p>None.</p>";
  else
    text += html::table(critical_speed_summary(study));
  return text +
         "<p class=\"sub\">Engine order, nodal diameter, wave and family are those of the wave that makes the "
         "peak; the largest wave is beside it. LE, TE: areas rubbed at the leading and trailing edge. eq. 2, "
         "aliasing: whether the rule foretells it. " +
         stress_note(study) + " In full: " + link("critical_speeds.csv") + ", " + link("linear_criterion.csv") +
         ".</p>\n";
}

std::string scene_section(const Study& study) {
  const SimulatedScene& scene = study.response.scene;
  std::string text = "<h2 id=\"scene\">What was modelled, and what was left out</h2>\n<ul>";
  std::string line;
  for (const char letter : scene.scope + "\n") {
    if (letter != '\n') {
      line += letter;
      continue;
    }
    if (!line.empty()) text += "<li>" + html::escaped(line) + "</li>\n";
    line.clear();
  }
  text += "<li>" + counted(static_cast<std::size_t>(scene.sector_count), "sector") + ", " +
          counted(static_cast<std::size_t>(study.model.contact.size()), "contact node") + " a blade, " +
          counted(static_cast<std::size_t>(scene.lobes), "lobe") + ", clearances " +
          html::escaped(scene.clearance_state) + "; stiffness under spin: " + html::escaped(study.model.prestress) +
          ".</li>\n<li>" + left_out_always + ".</li>\n";
  return text + "</ul>\n";
}

std::string exactness_section(const Study& study) {
  return "<h2 id=\"exactness\">How exact it is</h2>\n" + html::table(exactness_record(study)) +
         "<p class=\"sub\">At the worst speed. As a table: " + link("exactness.csv") +
         "; every speed: " + link("speeds.csv") + ".</p>\n";
}

std::string figure_section(const std::vector<Figure>& figures, const std::filesystem::path& folder) {
  std::string text;
  for (const Figure& figure : figures) {
    const std::string &name = figure.drawing.name, file = "figures/" + name;
    text += "<h2 id=\"" + name + "\">" + html::escaped(figure.title) + "</h2>\n<figure><img alt=\"" +
            html::escaped(figure.title) + "\" src=\"data:image/svg+xml;base64," +
            html::base64(read_text(folder / (file + ".svg"))) + "\"><figcaption>" + html::escaped(figure.caption) +
            " " + link(file + ".csv", "data") + dot + link(file + ".svg", "SVG") + dot + link(file + ".png", "PNG");
    for (const std::string& field : figure.fields) text += dot + link(field);
    text += "</figcaption></figure>\n";
  }
  return text;
}

std::string record_section(const Study& study, const ReportSource& source) {
  const auto folded = [](const std::string& title, const std::string& body, const std::string& file = "") {
    return "<details><summary>" + title + "</summary>" + body +
           (file.empty() ? "" : "<p class=\"sub\">" + link(file) + "</p>") + "</details>\n";
  };
  const auto listing = [](const std::string& text) { return "<pre>" + html::escaped(text) + "</pre>"; };
  return "<h2 id=\"record\">Record</h2>\n" +
         folded("Every speed: how steady, how exact", html::table(speed_record(study)), "speeds.csv") +
         folded("What the linear rules list", html::table(linear_criterion_record(study)), "linear_criterion.csv") +
         (study.sweeps.empty()
              ? std::string()
              : folded("From rest, upwards, downwards", html::table(sweep_record(study)), "sweeps.csv")) +
         folded("How the contact drifts with speed", html::table(drift_record(study)), "contact_drift.csv") +
         folded("The case file", listing(source.case_text), "case.toml") +
         folded("Where the response comes from", listing(study.response.scene.provenance)) +
         folded("Where the model comes from", listing(study.model.provenance)) + "<p class=\"sub\">Made by " +
         program_version("tiprub-postprocess") + ".</p>\n";
}

std::string contents(const std::vector<Figure>& figures) {
  std::string text = "<nav><a href=\"#critical\">Critical speeds</a>" + std::string(dot) +
                     "<a href=\"#scene\">Scene</a>" + dot + "<a href=\"#exactness\">How exact</a>";
  for (const Figure& figure : figures)
    text += dot + ("<a href=\"#" + figure.drawing.name + "\">" + html::escaped(figure.title) + "</a>");
  return text + dot + "<a href=\"#record\">Record</a></nav>\n";
}

}  // namespace

std::string report_page(const Study& study, const ReportSource& source, const std::vector<Figure>& figures,
                        const std::filesystem::path& folder) {
  const std::string title = source.title.empty() ? "Blade-tip rub" : source.title;
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         html::escaped(title) + "</title>\n<style>" + html::style() + "</style></head>\n<body><main>\n<h1>" +
         html::escaped(title) + "</h1>\n<p class=\"sub\">Blade tips against the casing, " +
         rpm_text(study.range.low) + " to " + rpm_text(study.range.high) + "</p>\n" + summary_section(study) +
         contents(figures) + scene_section(study) + exactness_section(study) + figure_section(figures, folder) +
         record_section(study, source) + "</main>\n<script>" + html::script() + "</script></body></html>\n";
}

}  // namespace tiprub
