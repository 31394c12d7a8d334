/// hlsc-differential: checks the compiler against native execution, case by case or with random programs.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

#include "differential/compile_case.h"
#include "differential/minimiser.h"
#include "differential/mutator.h"
#include "differential/program_generator.h"
#include "differential/run_case.h"
#include "differential/steering.h"

namespace {

namespace fs = std::filesystem;
using namespace hlsc::differential;

/// A case to run and where its files go.
struct Job {
  std::string name;
  fs::path kernel, work;
  std::uint64_t seed = 0;
};

using Check = std::function<CaseResult(const Job&)>;

CaseResult run_differential(const Job& job) { return run_case(job.kernel, job.work, job.seed); }
CaseResult run_messages(const Job& job) { return check_messages(job.kernel, job.work); }
/// Broken input may be refused or compiled, but never crash the compiler or keep it.
CaseResult run_broken(const Job& job) {
  CompileCheck check = compile_case(job.kernel, job.work, false);
  bool is_failure = check.outcome == Outcome::kCrash || check.outcome == Outcome::kHang ||
                    check.messages.find("internal: ") != std::string::npos;
  return {is_failure ? check.outcome == Outcome::kRefused ? Outcome::kCrash : check.outcome : Outcome::kPass,
          check.messages};
}

/// Counts by outcome; tells each failure and keeps its directory.
class Summary {
 public:
  void add(const Job& job, const CaseResult& result) {
    ++counts_[result.outcome];
    if (result.outcome == Outcome::kPass) {
      fs::remove_all(job.work);
      return;
    }
    fmt::print("{} {} (seed {}): {}\n", name_of(result.outcome), job.name, job.seed, result.detail);
    std::fflush(stdout);
  }
  /// Prints the counts; 0 when all passed.
  int finish() const {
    int total = 0, passed = 0;
    std::string others;
    for (const auto& [outcome, count] : counts_) {
      total += count;
      if (outcome == Outcome::kPass)
        passed = count;
      else
        others += fmt::format(", {} {}", count, name_of(outcome));
    }
    fmt::print("{} passed, {} failed{}\n", passed, total - passed, others);
    return passed == total && total > 0 ? 0 : 1;
  }

 private:
  std::map<Outcome, int> counts_;
};

int run_jobs(const std::vector<Job>& jobs, const Check& check, int parallel) {
  Summary summary;
  std::mutex mutex;
  std::size_t next = 0;
  auto worker = [&] {
    while (true) {
      std::unique_lock lock(mutex);
      if (next == jobs.size()) return;
      const Job job = jobs[next++];
      lock.unlock();
      fs::create_directories(job.work);
      CaseResult result = check(job);
      lock.lock();
      summary.add(job, result);
    }
  };
  std::vector<std::thread> workers;
  for (int i = 0; i < parallel; ++i) workers.emplace_back(worker);
  for (std::thread& thread : workers) thread.join();
  return summary.finish();
}

std::vector<Job> corpus_jobs(const std::vector<std::string>& paths, const fs::path& work,
                             std::uint64_t seed) {
  std::vector<fs::path> kernels;
  for (const fs::path path : paths) {
    if (!fs::is_directory(path))
      kernels.push_back(path);
    else
      for (const auto& entry : fs::directory_iterator(path))
        if (entry.path().extension() == ".cpp" || entry.path().extension() == ".c")
          kernels.push_back(entry.path());
  }
  std::sort(kernels.begin(), kernels.end());
  std::vector<Job> jobs;
  for (const fs::path& kernel : kernels)
    jobs.push_back({kernel.stem().string(), kernel, work / kernel.stem(), seed});
  return jobs;
}

std::vector<Job> fuzz_jobs(std::uint64_t first, std::uint64_t last, const fs::path& work) {
  std::vector<Job> jobs;
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    std::string name = fmt::format("fuzz_{}", seed);
    fs::create_directories(work / name);
    fs::path kernel = work / name / "fuzz.cpp";
    std::ofstream(kernel) << generate_program(seed);
    jobs.push_back({name, kernel, work / name, seed});
  }
  return jobs;
}

std::vector<Job> broken_jobs(const std::vector<Job>& sources, std::uint64_t first, std::uint64_t last,
                             const fs::path& work) {
  std::vector<Job> jobs;
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    const Job& source = sources[seed % sources.size()];
    std::string name = fmt::format("broken_{}", seed);
    fs::create_directories(work / name);
    fs::path kernel = work / name / source.kernel.filename();
    std::ofstream(kernel) << mutated(read_text(source.kernel), seed);
    jobs.push_back({name, kernel, work / name, seed});
  }
  return jobs;
}

int minimise(const std::string& program, std::uint64_t seed, const fs::path& work) {
  fs::create_directories(work);
  fs::path kernel = program;
  if (!fs::exists(kernel)) {
    seed = std::stoull(program);
    kernel = work / "fuzz.cpp";
    std::ofstream(kernel) << generate_program(seed);
  }
  fmt::print("{}", minimised(kernel, work, seed));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Checks the HLS compiler against native execution");
  app.require_subcommand(1);
  std::string work = "differential";
  int parallel = 1;
  std::uint64_t seed = 1, first = 1, last = 150;
  std::vector<std::string> paths;
  app.add_option("--work", work, "directory for the files of the cases; those that fail stay")
      ->capture_default_str();
  app.add_option("-j", parallel, "cases at a time")->capture_default_str()->check(CLI::Range(1, 64));

  auto add_paths = [&](CLI::App* command) {
    command->add_option("paths", paths, "cases, or directories of them")
        ->required()
        ->check(CLI::ExistingPath);
    return command;
  };
  auto add_seeds = [&](CLI::App* command) {
    command->add_option("--first", first, "first seed")->capture_default_str();
    command->add_option("--last", last, "last seed")->capture_default_str();
    return command;
  };
  CLI::App* corpus = add_paths(app.add_subcommand("corpus", "run kernels against native execution"));
  corpus->add_option("--seed", seed, "of arguments and pauses; 0: no pauses")->capture_default_str();
  CLI::App* fuzz = add_seeds(app.add_subcommand("fuzz", "run random programs against native execution"));
  CLI::App* messages =
      add_paths(app.add_subcommand("messages", "compare errors and warnings with those the cases state"));
  CLI::App* broken = add_seeds(add_paths(app.add_subcommand("broken", "compile cases with broken tokens")));
  std::string program;
  CLI::App* minimiser =
      app.add_subcommand("minimise", "print the smallest program that fails in the same way");
  minimiser->add_option("program", program, "seed of a random program, or a kernel")->required();
  minimiser->add_option("--seed", seed, "of a kernel's arguments and pauses")->capture_default_str();
  app.fallthrough();
  CLI11_PARSE(app, argc, argv);
  try {
    if (*corpus) return run_jobs(corpus_jobs(paths, work, seed), run_differential, parallel);
    if (*fuzz) return run_jobs(fuzz_jobs(first, last, work), run_differential, parallel);
    if (*messages) return run_jobs(corpus_jobs(paths, work, seed), run_messages, parallel);
    if (*broken)
      return run_jobs(broken_jobs(corpus_jobs(paths, work, seed), first, last, work), run_broken, parallel);
    return minimise(program, seed, work);
  } catch (const std::exception& failure) {
    fmt::print(stderr, "error: {}\n", failure.what());
    return 2;
  }
}
