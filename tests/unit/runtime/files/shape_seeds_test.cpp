// What the fuzzer of kept shapes begins with.
#include "haptics/geometry/shape.h"
#include "haptics/levels/level_bytes.h"
#include "haptics/voxel/shape_bytes.h"
#include "haptics/voxel/voxelise.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum {
namespace {

// With FULCRUM_WRITE_SEEDS set they are written anew first, for a new layout.
TEST_CASE("shape bytes: the fuzzer begins with shapes of today's layout") {
    const TriangleMesh box = make_box(Vector3::Ones()).value();
    const Digest key{};
    const std::vector<std::pair<std::string, Bytes>> seeds{
        {"field", encode(DistanceField::build(box, DistanceField::make_frame(box, 16, 2.0).value(),
                                              {.band_voxels = 2.0})
                             .value(),
                         key)},
        {"voxels", encode(voxelise(box, {.voxel_m = 0.4}).value(), key)},
        {"pointshell", encode(make_surface_pointshell(box, 5).value(), key)},
        {"levels",
         encode(*ContactLevels::create(make_sphere(1.0, 1).value(), {.within_m = 0.1}).value(),
                key)},
        {"solid", encode(MeasuredSolid{compute_solid_moments(box), true}, key)}};
    for (const auto& [name, bytes] : seeds) {
        const std::string path = FULCRUM_SOURCE_DIR "/tests/fuzz/corpus/shape/" + name;
        if (std::getenv("FULCRUM_WRITE_SEEDS") != nullptr) {
            std::ofstream(path, std::ios::binary)
                .write(reinterpret_cast<const char*>(bytes.data()),
                       static_cast<std::streamsize>(bytes.size()));
        }
        std::ifstream file(path, std::ios::binary);
        const std::string kept{std::istreambuf_iterator<char>(file), {}};
        INFO(name << " is of another layout; run this test once with FULCRUM_WRITE_SEEDS=1");
        CHECK(std::ranges::equal(std::as_bytes(std::span(kept)), bytes));
    }
}

}  // namespace
}  // namespace fulcrum
