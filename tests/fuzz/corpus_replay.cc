#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace {

constexpr std::uint64_t kSeed = 3;
constexpr int kVariants = 20;  // of each kept input, with a few bytes changed

std::vector<std::uint8_t> content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace

/// Feeds the files of a folder, and seeded variants of each, to the fuzz target, which aborts where an answer is wrong.
int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: steering_corpus_replay FOLDER\n";
    return 2;
  }
  std::mt19937_64 engine(kSeed);
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(arguments[1])) {
    std::vector<std::uint8_t> bytes = content(entry.path());
    std::cout << entry.path().filename().string() << std::endl;  // flushed: the last line names the input that fails
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    for (int variant = 0; variant < kVariants && !bytes.empty(); ++variant) {
      bytes[engine() % bytes.size()] = static_cast<std::uint8_t>(engine());
      LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    }
    ++files;
  }
  std::cout << files << " inputs\n";
  return files > 0 ? 0 : 1;
}
