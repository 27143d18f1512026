// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/campaign.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <stdexcept>

#include "cases/program/errors.h"
#include "cases/program/printable.h"

namespace fs = std::filesystem;

namespace tiprub::fuzz {

namespace {

constexpr unsigned hang_seconds = 60;
constexpr std::uint64_t inputs_a_child = 500;  // then a new one: libraries may leak

/// What the children tell, in memory that outlives them.
struct Shared {
  Tally tally;
  std::uint64_t next = 0;  ///< the input that is being read
};

/// What is wrong with a refusal; nothing if it names the file. The programs print it as one line, whatever it holds.
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
    } catch (const InputError& error) {
      refuse(error.what(), fault_of(error.what(), file));
    } catch (const RunError& error) {
      refuse(error.what(), fault_of(error.what(), file));
    } catch (const std::exception& error) {
      refuse(error.what(), std::string("no message for people: ") + error.what());
    } catch (...) {
      refuse("", "what it raised is no std::exception");
    }
  return verdict;
}

fs::path input_file(const Reader& reader, const Campaign& campaign) {
  return campaign.folder / ("input" + reader.end);
}

/// Keeps the input that is being read, and says so.
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

/// The result of a child that does `body`, as waitpid() has it. What is meant for stdout is nobody's.
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

}  // namespace

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
  Tally tally = shared.tally;
  tally.inputs = shared.next;
  munmap(memory, sizeof(Shared));
  return tally;
}

}  // namespace tiprub::fuzz
