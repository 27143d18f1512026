// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/speed_numbers.h"

#include <array>
#include <utility>

#include "cases/program/errors.h"

namespace tiprub {

namespace {

constexpr std::array<std::pair<MotionClass, const char*>, 5> motion_names = {{
    {MotionClass::periodic, "periodic"},
    {MotionClass::subharmonic, "subharmonic"},
    {MotionClass::modulated, "modulated"},
    {MotionClass::broadband, "broadband"},
    {MotionClass::not_settled, "not settled"},
}};

constexpr std::array<std::pair<SymmetryVerdict, const char*>, 5> symmetry_names = {{
    {SymmetryVerdict::all_held, "all held"},
    {SymmetryVerdict::unchecked, "unchecked"},
    {SymmetryVerdict::holds, "holds"},
    {SymmetryVerdict::breaking, "breaking"},
    {SymmetryVerdict::undecided, "undecided"},
}};

constexpr std::array<std::pair<OrbitReport::Outcome, const char*>, 3> outcome_names = {{
    {OrbitReport::Outcome::none, "none"},
    {OrbitReport::Outcome::found, "found"},
    {OrbitReport::Outcome::marched, "marched"},
}};

constexpr std::array<std::pair<Depth, const char*>, 3> depth_names = {{
    {Depth::scanned, "scanned"},
    {Depth::full, "full"},
    {Depth::examined, "examined"},
}};

template <class Names, class Value>
const char* name_in(const Names& names, Value value) {
  for (const auto& [known, name] : names)
    if (known == value) return name;
  return "";
}

template <class Names>
auto value_named(const Names& names, const std::string& name, const std::string& where) {
  for (const auto& [value, known] : names)
    if (name == known) return value;
  throw RunError(where + " \"" + name + "\" is not known");
}

}  // namespace

std::vector<SpeedText> texts_of(const SpeedResponse& speed) {
  return {{"failure", "why there is no response; empty: there is one", speed.failure},
          {"motion", "class of the motion", name_of(speed.motion)},
          {"symmetry", "whether nodal diameters left out stay small", name_in(symmetry_names, speed.audit.symmetry)},
          {"halving_measure", "what the last halving of the step was measured by", speed.audit.halving_measure},
          {"depth", "how closely the speed was looked at", name_in(depth_names, speed.depth)}};
}

const char* name_of(MotionClass motion) {
  return name_in(motion_names, motion);
}

const char* name_of(OrbitReport::Outcome outcome) {
  return name_in(outcome_names, outcome);
}

MotionClass motion_named(const std::string& name, const std::string& where) {
  return value_named(motion_names, name, where);
}

SymmetryVerdict symmetry_named(const std::string& name, const std::string& where) {
  return value_named(symmetry_names, name, where);
}

Depth depth_named(const std::string& name, const std::string& where) {
  return value_named(depth_names, name, where);
}

OrbitReport::Outcome outcome_named(const std::string& name, const std::string& where) {
  return value_named(outcome_names, name, where);
}

}  // namespace tiprub
