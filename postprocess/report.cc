// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/report.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "cases/command_line.h"
#include "postprocess/figure_style.h"
#include "postprocess/html.h"
#include "postprocess/result_tables.h"
#include "postprocess/units.h"

namespace tiprub {

namespace {

constexpr double percent = 100.0;

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string wave_sentence(const CriticalSpeed& critical) {
  const WaveLabel& wave = critical.rising;
  return "family " + std::to_string(wave.family + 1) + " on nodal diameter " +
         std::to_string(std::abs(wave.signed_nodal_diameter)) + ", driven by " +
         style::engine_order_name(wave.engine_order) + " as a " + name_of(wave.direction) + " wave";
}

std::string critical_sentence(const Study& study) {
  const std::string range = rpm_text(study.range.low) + " and " + rpm_text(study.range.high);
  if (study.critical.empty())
    return "No critical speed between " + range + ": the amplitude has no peak that stands out.";
  const auto worst =
      std::max_element(study.critical.begin(), study.critical.end(),
                       [](const CriticalSpeed& a, const CriticalSpeed& b) { return a.amplitude < b.amplitude; });
  return counted(study.critical.size(), "critical speed") + " between " + range + ". The worst is " +
         rpm_text(worst->speed) + " with " + fixed(worst->amplitude * mm_per_m, 3) + " mm: " + wave_sentence(*worst) +
         ".";
}

std::string edge_sentence(const Study& study) {
  std::string text;
  for (const Eigen::Index end : rising_ends(study.amplitudes.largest, study.parameters.prominence))
    text += (text.empty() ? "The amplitude still rises towards " : " and ") +
            rpm_text(study.response.speeds[static_cast<std::size_t>(end)].speed) + " (" +
            fixed(study.amplitudes.largest[end] * mm_per_m, 3) + " mm)";
  return text.empty() ? "" : text + ": a peak may lie outside the simulated speeds.";
}

std::string rule_sentence(const Study& study) {
  if (study.critical.empty()) return "";
  const auto part = [](const RuleScore& score) {
    return "misses " + std::to_string(score.misses) + " of " + std::to_string(score.hits + score.misses) +
           " and raises " + counted(static_cast<std::size_t>(score.false_alarms), "false alarm");
  };
  return "The linear rule (eq. 2) " + part(study.equation_2_score) + "; with aliasing it " +
         part(study.aliasing_score) + " (same wave, within " +
         fixed(percent * study.parameters.prediction_tolerance, 1) + " % of the speed).";
}

std::string steadiness_sentence(const Study& study) {
  std::size_t periodic = 0, subharmonic = 0;
  double change = 0, closing = 0;
  for (const SpeedResponse& at : study.response.speeds) {
    periodic += at.motion == MotionClass::periodic;
    subharmonic += at.motion == MotionClass::subharmonic;
    if (at.motion != MotionClass::irregular) change = std::max(change, at.change);
    closing = std::max(closing, std::abs(at.energy.closing_error));
  }
  const std::size_t all = study.response.speeds.size();
  return counted(all, "speed") + " computed: " + std::to_string(periodic) + " periodic, " +
         std::to_string(subharmonic) + " subharmonic, " + std::to_string(all - periodic - subharmonic) +
         " irregular, " + std::to_string(study.failed.size()) + " failed. Those that repeat are steady to " +
         scientific(change, 1) + " a period; the energy balance closes to " + scientific(closing, 1) + ".";
}

/// "12,000 to 12,400, 13,000 rpm": the speeds for which a property holds, neighbours drawn together.
template <class Property>
std::string runs_of_speeds(const Study& study, const Property& holds) {
  const auto& speeds = study.response.speeds;
  std::string text;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    if (!holds(speeds[i]) || (i > 0 && holds(speeds[i - 1]))) continue;
    std::size_t last = i;
    while (last + 1 < speeds.size() && holds(speeds[last + 1])) ++last;
    text += (text.empty() ? "" : ", ") + fixed(speeds[i].speed * rpm_per_rad_s, 0) +
            (last > i ? " to " + fixed(speeds[last].speed * rpm_per_rad_s, 0) : "");
  }
  return text.empty() ? text : text + " rpm";
}

std::string unusual_sentence(const Study& study) {
  std::string text;
  const auto add = [&](const std::string& what, const std::string& where) {
    if (!where.empty()) text += (text.empty() ? "" : " ") + what + ": " + where + ".";
  };
  add("Motion that never repeats",
      runs_of_speeds(study, [](const SpeedResponse& at) { return at.motion == MotionClass::irregular; }));
  add("Subharmonic motion",
      runs_of_speeds(study, [](const SpeedResponse& at) { return at.motion == MotionClass::subharmonic; }));
  add("A nodal diameter that was left out would grow (run these with nodal_diameters = \"all\")",
      runs_of_speeds(study, [](const SpeedResponse& at) { return at.audit.symmetry == SymmetryVerdict::breaking; }));
  return text;
}

std::string sweep_sentence(const Study& study) {
  if (study.sweeps.empty()) return "";
  std::size_t apart = 0;
  const SweepComparison* largest = nullptr;
  const auto change = [&](const SweepComparison& at) {
    double most = 0;
    for (const auto& swept : {at.up, at.down})
      if (swept && swept->differs)
        most = std::max(most, std::abs(swept->amplitude - study.amplitudes.largest[at.index]));
    return most;
  };
  for (const SweepComparison& at : study.sweeps) {
    if (!at.differs()) continue;
    ++apart;
    if (largest == nullptr || change(at) > change(*largest)) largest = &at;
  }
  if (largest == nullptr) return "Sweeps up and down settle to the same motions as from rest, wherever both settle.";
  return "At " + counted(apart, "speed") +
         " more than one settled motion exists: sweeps differ from the response from rest, most at " +
         rpm_text(study.response.speeds[static_cast<std::size_t>(largest->index)].speed) + ", by " +
         fixed(change(*largest) * mm_per_m, 3) + " mm of amplitude.";
}

std::string share_sentence(const Study& study) {
  constexpr double invisible = 5e-5;
  const Eigen::VectorXd shares = energy_shares(study.map);
  std::string text;
  for (Eigen::Index n = 0; n < shares.size(); ++n)
    text += (n > 0 ? ", " : "") + std::to_string(n) + ": " +
            (shares[n] < invisible ? std::string("0") : fixed(percent * shares[n], 2));
  return "Share of the motion by nodal diameter, over all speeds [%]: " + text + ".";
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
         stress_note(study) +
         " In full: <a href=\"critical_speeds.csv\">critical_speeds.csv</a>, "
         "<a href=\"linear_criterion.csv\">linear_criterion.csv</a>.</p>\n";
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
          ".</li>\n";
  return text + "</ul>\n";
}

std::string figure_section(const std::vector<Figure>& figures, const std::filesystem::path& folder) {
  std::string text;
  for (const Figure& figure : figures) {
    const std::string& name = figure.drawing.name;
    const std::string file = "figures/" + name;
    text += "<h2 id=\"" + name + "\">" + html::escaped(figure.title) + "</h2>\n<figure><img alt=\"" +
            html::escaped(figure.title) + "\" src=\"data:image/svg+xml;base64," +
            html::base64(read_text(folder / (file + ".svg"))) + "\"><figcaption>" + html::escaped(figure.caption) +
            " <a href=\"" + file + ".csv\">data</a> \xC2\xB7 <a href=\"" + file +
            ".svg\">SVG</a> \xC2\xB7 <a href=\"" + file + ".png\">PNG</a></figcaption></figure>\n";
  }
  return text;
}

std::string record_section(const Study& study, const ReportSource& source) {
  const auto folded = [](const std::string& title, const std::string& body) {
    return "<details><summary>" + title + "</summary>" + body + "</details>\n";
  };
  const auto listing = [](const std::string& text) { return "<pre>" + html::escaped(text) + "</pre>"; };
  return "<h2 id=\"record\">Record</h2>\n" +
         folded("Every speed: how steady, how exact", html::table(speed_record(study))) +
         folded("What the linear rules list", html::table(linear_criterion_record(study))) +
         (study.sweeps.empty() ? std::string()
                               : folded("From rest, upwards, downwards", html::table(sweep_record(study)))) +
         folded("How the contact drifts with speed", html::table(drift_record(study))) +
         folded("The case file", listing(source.case_text)) +
         folded("Where the response comes from", listing(study.response.scene.provenance)) +
         folded("Where the model comes from", listing(study.model.provenance)) +
         "<p class=\"sub\">All speeds: <a href=\"speeds.csv\">speeds.csv</a>. Made by " +
         program_version("tiprub-postprocess") + ".</p>\n";
}

std::string contents(const std::vector<Figure>& figures) {
  std::string text = "<nav><a href=\"#critical\">Critical speeds</a> \xC2\xB7 <a href=\"#scene\">Scene</a>";
  for (const Figure& figure : figures)
    text += " \xC2\xB7 <a href=\"#" + figure.drawing.name + "\">" + html::escaped(figure.title) + "</a>";
  return text + " \xC2\xB7 <a href=\"#record\">Record</a></nav>\n";
}

}  // namespace

std::vector<std::string> verdict(const Study& study) {
  std::vector<std::string> lines;
  for (const std::string& line :
       {critical_sentence(study), edge_sentence(study), rule_sentence(study), steadiness_sentence(study),
        unusual_sentence(study), sweep_sentence(study), share_sentence(study)})
    if (!line.empty()) lines.push_back(line);
  return lines;
}

std::string report_page(const Study& study, const ReportSource& source, const std::vector<Figure>& figures,
                        const std::filesystem::path& folder) {
  const std::string title = source.title.empty() ? "Blade-tip rub" : source.title;
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         html::escaped(title) + "</title>\n<style>" + html::style() + "</style></head>\n<body><main>\n<h1>" +
         html::escaped(title) + "</h1>\n<p class=\"sub\">Blade tips against the casing, " +
         rpm_text(study.range.low) + " to " + rpm_text(study.range.high) + "</p>\n" + summary_section(study) +
         contents(figures) + scene_section(study) + figure_section(figures, folder) + record_section(study, source) +
         "</main>\n<script>" + html::script() + "</script></body></html>\n";
}

}  // namespace tiprub
