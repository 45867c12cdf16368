#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

// A target whose inputs are messages has one.
extern "C" std::size_t __attribute__((weak))
LLVMFuzzerCustomMutator(std::uint8_t* bytes, std::size_t size, std::size_t most, unsigned seed);

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint64_t kSeed = 3;
constexpr int kVariants = 20;  // of each kept input, with a little changed
constexpr std::size_t kMostBytes = 1 << 20;

Bytes content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void change(Bytes& bytes, std::mt19937_64& engine) {
  if (LLVMFuzzerCustomMutator == nullptr) {
    bytes[engine() % bytes.size()] = static_cast<std::uint8_t>(engine());
    return;
  }
  const std::size_t size = bytes.size();
  bytes.resize(kMostBytes);
  bytes.resize(LLVMFuzzerCustomMutator(bytes.data(), size, kMostBytes, static_cast<unsigned>(engine())));
}

// In the order of their names, so that the variants are the same on every machine.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".md") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

/// Feeds the files of folders, and seeded variants of each, to the fuzz target, which aborts where an answer is wrong.
int main(int count, char** arguments) {
  if (count < 2) {
    std::cerr << "usage: replay FOLDER...\n";
    return 2;
  }
  std::mt19937_64 engine(kSeed);
  int files = 0;
  for (int folder = 1; folder < count; ++folder) {
    for (const auto& file : files_in(arguments[folder])) {
      Bytes bytes = content(file);
      std::cout << file.filename().string() << std::endl;  // flushed: the last line names the input that fails
      LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
      for (int variant = 0; variant < kVariants && !bytes.empty(); ++variant) {
        change(bytes, engine);
        LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
      }
      ++files;
    }
  }
  std::cout << files << " inputs\n";
  return files > 0 ? 0 : 1;
}
