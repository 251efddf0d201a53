/// \file
/// Runs a fuzz target over a kept corpus, with any compiler.
///   replay FOLDER ...  each file as it is and cut at every percent of its length, at every byte of short
///   ones
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(int argc, char** argv) {
  std::vector<fs::path> files;
  for (int i = 1; i < argc; ++i)
    for (const auto& entry : fs::directory_iterator(argv[i])) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// Runs the target on bytes of their own, so that the address sanitizer sees a read behind their end.
void run(const std::vector<std::uint8_t>& bytes, std::size_t length) {
  const std::vector<std::uint8_t> cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
  LLVMFuzzerTestOneInput(cut.data(), cut.size());
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t runs = 0;
  for (const fs::path& path : files_in(argc, argv)) {
    std::printf("%s\n", path.filename().c_str());  // the last one is the one that fails
    std::fflush(stdout);
    std::ifstream in(path, std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
    const std::size_t cuts = std::min<std::size_t>(bytes.size(), 100);
    for (std::size_t cut = 0; cut <= cuts; ++cut, ++runs)
      run(bytes, cuts == 0 ? 0 : bytes.size() * cut / cuts);
  }
  std::printf("%zu runs\n", runs);
  return runs > 0 ? 0 : 1;
}
