/// \file
/// Runs whittle-bench as a user would.
#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "Folder.hh"
#include "experiment/GeneratedMesh.hh"
#include "files/MeshFile.hh"

namespace bench_program {

namespace fs = std::filesystem;

/// A folder with a small ball in it, and the program run there by the shell.
class Bench {
 public:
  Bench() { whittle::files::write_mesh(folder_ / "ball.obj", whittle::bench::generated_mesh(12)); }

  /// The exit code; the output is then in `out` and `err`.
  int run(const std::string& arguments, const std::string& before = "") {
    const std::string command = "cd '" + folder().string() + "' && " + before +
                                " '" WHITTLE_BENCH_PROGRAM "' " + arguments + " > out.txt 2> err.txt";
    const int status = std::system(command.c_str());
    out = scratch::contents(folder_ / "out.txt");
    err = scratch::contents(folder_ / "err.txt");
    UNSCOPED_INFO("whittle-bench " << arguments << ": " << err);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// Starts the program, sends it a signal once results.json in `r` holds so many times, and waits for its
  /// end; after a minute the signal comes anyway. The exit code is 128 plus the signal's number where it dies
  /// of it.
  int run_and_signal(const std::string& arguments, const std::string& signal, std::size_t times) {
    const std::string command = "cd '" + folder().string() + "' && { '" WHITTLE_BENCH_PROGRAM "' " +
                                arguments +
                                " > out.txt 2> err.txt & p=$!; i=0; while [ $i -lt 600 ]; do n=$(grep -c "
                                "visited_as r/results.json 2> /dev/null); "
                                "[ ${n:-0} -ge " +
                                std::to_string(times) + " ] && break; i=$((i+1)); sleep 0.1; done; kill -s " +
                                signal + " $p; wait $p; } 2> /dev/null";
    const int status = std::system(command.c_str());
    out = scratch::contents(folder_ / "out.txt");
    err = scratch::contents(folder_ / "err.txt");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  std::vector<std::string> files_in(const std::string& name) const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / name)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

  const fs::path& folder() const { return folder_.path(); }
  std::string out, err;

 private:
  scratch::Folder folder_;
};

/// Paper 1's experiment on the ball, in a moment.
constexpr char kShort[] =
    "--model ball.obj --experiments paper1 --size 64x48 --frames-from 1 --frames-to 4 --repetitions 2 "
    "--views 1 "
    "--samples 100 --out r ";

}  // namespace bench_program
