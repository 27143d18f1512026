// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/speed_numbers.h"

#include "cases/program/named_values.h"

namespace tiprub {

namespace {

constexpr NamedValues<MotionClass, 5> motion_names = {{
    {MotionClass::periodic, "periodic"},
    {MotionClass::subharmonic, "subharmonic"},
    {MotionClass::modulated, "modulated"},
    {MotionClass::broadband, "broadband"},
    {MotionClass::not_settled, "not settled"},
}};

constexpr NamedValues<SymmetryVerdict, 5> symmetry_names = {{
    {SymmetryVerdict::all_held, "all held"},
    {SymmetryVerdict::unchecked, "unchecked"},
    {SymmetryVerdict::holds, "holds"},
    {SymmetryVerdict::breaking, "breaking"},
    {SymmetryVerdict::undecided, "undecided"},
}};

constexpr NamedValues<OrbitReport::Outcome, 3> outcome_names = {{
    {OrbitReport::Outcome::none, "none"},
    {OrbitReport::Outcome::found, "found"},
    {OrbitReport::Outcome::marched, "marched"},
}};

constexpr NamedValues<Depth, 3> depth_names = {{
    {Depth::scanned, "scanned"},
    {Depth::full, "full"},
    {Depth::examined, "examined"},
}};

constexpr NamedValues<MotionMeasure, 2> measure_names = {{
    {MotionMeasure::motion, "motion"},
    {MotionMeasure::spectrum, "spectrum"},
}};

constexpr NamedValues<Start, 4> start_names = {{
    {Start::up, "up"},
    {Start::down, "down"},
    {Start::disturbed, "disturbed"},
    {Start::whole_wheel, "whole wheel"},
}};

}  // namespace

std::vector<SpeedText> texts_of(const SpeedResponse& speed) {
  return {{"failure", "why there is no response; empty: there is one", speed.failure},
          {"motion", "class of the motion", name_of(speed.motion)},
          {"symmetry", "whether nodal diameters left out stay small", name_in(symmetry_names, speed.audit.symmetry)},
          {"halving_measure", "what the last halving of the step was measured by",
           speed.audit.halving_measure ? name_of(*speed.audit.halving_measure) : ""},
          {"halving_failure", "why half the step gave no motion; empty: it did, or was not taken",
           speed.audit.halving_failure},
          {"depth", "how closely the speed was looked at", name_in(depth_names, speed.depth)}};
}

const char* name_of(MotionClass motion) {
  return name_in(motion_names, motion);
}

const char* name_of(MotionMeasure measure) {
  return name_in(measure_names, measure);
}

const char* name_of(Start start) {
  return name_in(start_names, start);
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

MotionMeasure measure_named(const std::string& name, const std::string& where) {
  return value_named(measure_names, name, where);
}

Start start_named(const std::string& name, const std::string& where) {
  return value_named(start_names, name, where);
}

OrbitReport::Outcome outcome_named(const std::string& name, const std::string& where) {
  return value_named(outcome_names, name, where);
}

}  // namespace tiprub
