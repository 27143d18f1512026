// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged inputs for one of the readers: each must be accepted, or refused with one line that names the file.
//
// usage: tiprub_fuzz READER SEED COUNT SECONDS FOLDER BASE...
//
// READER is one of those in readers.cc; the same SEED and bases give the same
// inputs. It stops after COUNT inputs or SECONDS (0: no limit). Inputs that a reader fails on are kept in FOLDER. A
// BASE lies in the folder of its scene (case.toml, sector.msh, model.h5, fields.h5, response.h5).
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "tests/fuzz/campaign.h"

namespace {

void print(const std::string& reader, const tiprub::fuzz::Tally& tally) {
  std::printf("%-10s%10s%10s%10s%10s%10s%10s\n", "reader", "inputs", "accepted", "refused", "crashes", "hangs",
              "wrong");
  std::printf("%-10s", reader.c_str());
  for (const auto count : {tally.inputs, tally.accepted, tally.refused, tally.crashes, tally.hangs, tally.wrong})
    std::printf("%10llu", static_cast<unsigned long long>(count));
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) try {
  constexpr int first_base = 6;
  if (argc <= first_base) {
    std::fprintf(stderr, "usage: tiprub_fuzz READER SEED COUNT SECONDS FOLDER BASE...\n");
    return 2;
  }
  const tiprub::fuzz::Reader& reader = tiprub::fuzz::reader(argv[1]);
  tiprub::fuzz::Campaign campaign;
  campaign.seed = std::strtoull(argv[2], nullptr, 10);
  campaign.count = std::strtoull(argv[3], nullptr, 10);
  campaign.seconds = std::strtod(argv[4], nullptr);
  campaign.folder = argv[5];
  std::filesystem::create_directories(campaign.folder);
  const std::vector<std::string> bases(argv + first_base, argv + argc);
  const tiprub::fuzz::Tally tally = run(reader, tiprub::fuzz::read_bases(bases), campaign);
  print(reader.name, tally);
  return tally.sound() ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "tiprub_fuzz: %s\n", error.what());
  return 2;
}
