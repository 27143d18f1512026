// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged inputs for one of the readers: each must be accepted, or refused with one line that names the file.
//
// usage: tiprub_fuzz READER SEED COUNT SECONDS FOLDER BASE...
//
// READER is one of those in readers.cc. The same SEED and BASEs give the same inputs. It stops after COUNT inputs or
// SECONDS (0: no limit). The environment variables FUZZ_SEED and FUZZ_INPUTS give another SEED and COUNT, without
// limit of time. Inputs on which the reader fails are kept in FOLDER. A BASE lies in the folder of its scene
// (case.toml, sector.msh, model.h5, fields.h5, response.h5).
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "cases/program/errors.h"
#include "cases/program/text.h"
#include "tests/fuzz/inputs.h"

namespace fs = std::filesystem;

namespace tiprub::fuzz {

namespace {

constexpr unsigned hang_seconds = 60;
constexpr std::uint64_t inputs_a_child = 500;  // then a new one: libraries may leak

struct Campaign {
  std::uint64_t seed = 0, count = 0;
  double seconds = 0;            ///< no input begins later; 0: none is left out
  std::filesystem::path folder;  ///< where inputs are written; those that a reader fails on stay there
  pid_t run = getpid();          ///< in the name of the input, so that runs in one folder read their own
};

struct Tally {
  std::uint64_t inputs = 0;
  std::uint64_t accepted = 0;
  std::uint64_t refused = 0;  ///< with one line that names the file
  std::uint64_t crashes = 0;  ///< signals and sanitizer reports
  std::uint64_t hangs = 0;    ///< above a minute
  std::uint64_t wrong = 0;    ///< refused in any other way

  bool sound() const { return crashes + hangs + wrong == 0; }
};

/// What the children tell, in memory that outlives them.
struct Shared {
  Tally tally;
  std::uint64_t next = 0;  ///< the input that is being read
};

/// What is wrong with a refusal; nothing if it names the file.
std::string fault_of(const std::string& message, const fs::path& file) {
  const bool named = message.find(file.filename().string()) != std::string::npos;
  return named ? "" : "doesn't name the file: " + printable(message);
}

struct Verdict {
  bool accepted = true;
  std::string fault;    ///< of the first refusal that isn't as it should be
  std::string message;  ///< of the first refusal
};

Verdict read(const Reader& reader, const fs::path& file, const fs::path& beside) {
  Verdict verdict;
  const auto refuse = [&](const std::string& message, const std::string& fault) {
    if (verdict.accepted) verdict.message = message;
    if (verdict.fault.empty()) verdict.fault = fault;
    verdict.accepted = false;
  };
  for (const Reader::Part& part : reader.parts) try {
      part(file, beside);
    } catch (const std::exception& error) {
      const bool ours =
          dynamic_cast<const InputError*>(&error) != nullptr || dynamic_cast<const RunError*>(&error) != nullptr;
      refuse(error.what(),
             ours ? fault_of(error.what(), file) : std::string("no message for people: ") + error.what());
    } catch (...) {
      refuse("", "what it raised is no std::exception");
    }
  return verdict;
}

fs::path input_file(const Reader& reader, const Campaign& campaign) {
  return campaign.folder / ("input-" + std::to_string(campaign.run) + reader.end);
}

/// Keeps the input that was read last, and reports it.
void keep(const Reader& reader, const Campaign& campaign, std::uint64_t index, const std::string& fault) {
  const std::string name = reader.name + "-" + std::to_string(campaign.seed) + "-" + std::to_string(index);
  const fs::path kept = campaign.folder / (name + reader.end);
  fs::copy_file(input_file(reader, campaign), kept, fs::copy_options::overwrite_existing);
  std::fprintf(stderr, "%s: seed %llu, input %llu: %s\n", kept.c_str(),
               static_cast<unsigned long long>(campaign.seed), static_cast<unsigned long long>(index), fault.c_str());
}

void read_input(const Reader& reader, const std::vector<Base>& bases, const Campaign& campaign, Shared& shared) {
  const fs::path file = input_file(reader, campaign);
  const fs::path beside = make_input(file, reader.format, bases, campaign.seed, shared.next);
  alarm(hang_seconds);
  const Verdict verdict = read(reader, file, beside);
  alarm(0);
  ++(verdict.accepted ? shared.tally.accepted : verdict.fault.empty() ? shared.tally.refused : shared.tally.wrong);
  if (!verdict.fault.empty()) keep(reader, campaign, shared.next, verdict.fault);
}

/// The status of a child that runs `body`, as waitpid() gives it. What the child prints on stdout is dropped.
template <class Body>
int in_a_child(const Body& body) {
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0) {
    if (std::freopen("/dev/null", "w", stdout) == nullptr) _exit(2);
    _exit(body());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

void require_bases(const Reader& reader, const std::vector<Base>& bases) {
  for (const Base& base : bases) {
    const int status = in_a_child([&] {
      const Verdict verdict = read(reader, base.file, base.file.parent_path());
      if (!verdict.accepted) std::fprintf(stderr, "%s\n", verdict.message.c_str());
      return verdict.accepted ? 0 : 1;
    });
    if (status != 0) throw std::runtime_error(base.file.string() + ": is not accepted as it is");
  }
}

/// Lets a reader read changed inputs, in child processes that may die. Raises std::runtime_error if it refuses a base
/// as it is.
Tally run(const Reader& reader, const std::vector<Base>& bases, const Campaign& campaign) {
  require_bases(reader, bases);
  void* const memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::runtime_error("mmap failed");
  Shared& shared = *new (memory) Shared;
  const auto start = std::chrono::steady_clock::now();
  const auto goes_on = [&] {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    return shared.next < campaign.count && (campaign.seconds <= 0 || passed.count() < campaign.seconds);
  };
  while (goes_on()) {
    const int status = in_a_child([&] {
      for (std::uint64_t i = 0; i < inputs_a_child && goes_on(); ++i, ++shared.next)
        read_input(reader, bases, campaign, shared);
      return 0;
    });
    if (status == 0) continue;
    const bool hung = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
    ++(hung ? shared.tally.hangs : shared.tally.crashes);
    keep(reader, campaign, shared.next++,
         hung ? "takes over a minute" : "ended the process: " + std::to_string(status));
  }
  fs::remove(input_file(reader, campaign));
  Tally tally = shared.tally;
  tally.inputs = shared.next;
  munmap(memory, sizeof(Shared));
  return tally;
}

void print(const std::string& reader, const Campaign& campaign, const Tally& tally) {
  std::printf("%-10s%12s%10s%10s%10s%10s%10s%10s\n", "reader", "seed", "inputs", "accepted", "refused", "crashes",
              "hangs", "wrong");
  std::printf("%-10s%12llu", reader.c_str(), static_cast<unsigned long long>(campaign.seed));
  for (const auto count : {tally.inputs, tally.accepted, tally.refused, tally.crashes, tally.hangs, tally.wrong})
    std::printf("%10llu", static_cast<unsigned long long>(count));
  std::printf("\n");
}

}  // namespace
}  // namespace tiprub::fuzz

using namespace tiprub::fuzz;

int main(int argc, char** argv) try {
  constexpr int first_base = 6;
  if (argc <= first_base) {
    std::fprintf(stderr, "usage: tiprub_fuzz READER SEED COUNT SECONDS FOLDER BASE...\n");
    return 2;
  }
  const Reader& reader = reader_named(argv[1]);
  Campaign campaign;
  campaign.seed = std::strtoull(argv[2], nullptr, 10);
  campaign.count = std::strtoull(argv[3], nullptr, 10);
  campaign.seconds = std::strtod(argv[4], nullptr);
  campaign.folder = argv[5];
  if (const char* seed = std::getenv("FUZZ_SEED")) campaign.seed = std::strtoull(seed, nullptr, 10);
  if (const char* count = std::getenv("FUZZ_INPUTS")) {
    campaign.count = std::strtoull(count, nullptr, 10);
    campaign.seconds = 0;
  }
  fs::create_directories(campaign.folder);
  const std::vector<std::string> bases(argv + first_base, argv + argc);
  const Tally tally = run(reader, read_bases(bases), campaign);
  print(reader.name, campaign, tally);
  return tally.sound() ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "tiprub_fuzz: %s\n", error.what());
  return 2;
}
