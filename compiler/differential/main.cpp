/// hlsc-differential: checks the compiler against native execution, case by case or with random programs.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

#include "differential/program_generator.h"
#include "differential/run_case.h"

namespace {

namespace fs = std::filesystem;
using namespace hlsc::differential;

/// A case to run and where its files go.
struct Job {
  std::string name;
  fs::path kernel, work;
  std::uint64_t seed = 0;
};

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

int run_jobs(const std::vector<Job>& jobs, int parallel) {
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
      CaseResult result = run_case(job.kernel, job.work, job.seed);
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

  CLI::App* corpus = app.add_subcommand("corpus", "run kernels, or all of a directory");
  corpus->add_option("paths", paths, "kernels or directories")->required()->check(CLI::ExistingPath);
  corpus->add_option("--seed", seed, "of arguments and pauses; 0: no pauses")->capture_default_str();

  CLI::App* fuzz = app.add_subcommand("fuzz", "run random programs");
  fuzz->add_option("--first", first, "first seed")->capture_default_str();
  fuzz->add_option("--last", last, "last seed")->capture_default_str();
  app.fallthrough();
  CLI11_PARSE(app, argc, argv);
  try {
    return run_jobs(*corpus ? corpus_jobs(paths, work, seed) : fuzz_jobs(first, last, work), parallel);
  } catch (const std::exception& failure) {
    fmt::print(stderr, "error: {}\n", failure.what());
    return 2;
  }
}
