// Feeds a fuzz target the seeds in a folder and a fixed set of mutations of them, without
// libFuzzer: the same inputs with every compiler and on every machine.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int kMutationsPerSeed = 40;  // keeps each target's test in seconds, with sanitizers too
constexpr std::uint32_t kRandomSeed = 20240229;

void feed(const Bytes& input) {
    (void)LLVMFuzzerTestOneInput(input.data(), input.size());
}

// Numbers that parsers trip over, as one byte and as little-endian words.
void overwrite_with_extreme(Bytes& input, std::mt19937& random) {
    static constexpr std::uint32_t kExtremes[] = {
        0U,          1U,          0x7FU,       0x80U,       0xFFU,
        0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU, 0x7F800000U, 0x7FC00000U};
    const std::size_t at = random() % input.size();
    const std::uint32_t value = kExtremes[random() % std::size(kExtremes)];
    const std::size_t width = std::min<std::size_t>(random() % 2 == 0 ? 1 : 4, input.size() - at);
    for (std::size_t i = 0; i < width; ++i) {
        input[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
    }
}

// One to four small changes: a flipped bit, an extreme number, a piece cut out, a piece repeated,
// the end cut off.
Bytes mutate(Bytes input, std::mt19937& random) {
    const std::uint32_t n_changes = 1 + random() % 4;
    for (std::uint32_t change = 0; change < n_changes && !input.empty(); ++change) {
        const std::size_t at = random() % input.size();
        const auto here = input.begin() + static_cast<std::ptrdiff_t>(at);
        const auto length = static_cast<std::ptrdiff_t>(
            1 + random() % std::min<std::size_t>(64, input.size() - at));
        switch (random() % 5) {
            case 0:
                *here = static_cast<std::uint8_t>(*here ^ (1U << (random() % 8)));
                break;
            case 1:
                overwrite_with_extreme(input, random);
                break;
            case 2:
                input.erase(here, here + length);
                break;
            case 3: {
                const Bytes piece(here, here + length);
                input.insert(here, piece.begin(), piece.end());
                break;
            }
            default:
                input.resize(at);
        }
    }
    return input;
}

std::vector<std::filesystem::path> seeds_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> seeds;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            seeds.push_back(entry.path());
        }
    }
    std::sort(seeds.begin(), seeds.end());
    return seeds;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2 || !std::filesystem::is_directory(argv[1])) {
        std::fprintf(
            stderr,
            "usage: replay_NAME FOLDER, a folder of seeds; tests/fuzz/corpus/NAME must exist\n");
        return 2;
    }
    std::mt19937 random(kRandomSeed);
    feed({});
    const auto seeds = seeds_in(argv[1]);
    for (const auto& path : seeds) {
        std::ifstream file(path, std::ios::binary);
        const Bytes seed{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
        std::printf("%s\n", path.c_str());
        std::fflush(stdout);
        feed(seed);
        for (int i = 0; i < kMutationsPerSeed; ++i) {
            feed(mutate(seed, random));
        }
    }
    std::printf("%zu seeds, each with %d mutations\n", seeds.size(), kMutationsPerSeed);
    return seeds.empty() ? 2 : 0;
}
