#include "runtime/render/scene/kite_models.h"

#include "runtime/scene/shape_models.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <string>

using namespace fulcrum;
using namespace fulcrum::runtime;

TEST_CASE(
    "kite models: every shape has sheets as large as it is, in two colours, and all the parts it "
    "needs") {
    for (const KiteShape shape : kKiteShapes) {
        KiteSettings design;
        design.shape = shape;
        design.height_m = 1.0;
        design.bridle_m = 1.25;
        design.knot_m = 0.85;
        const std::vector<LoadedModel> models = make_kite_models(design);
        std::set<std::string> names;
        for (const LoadedModel& model : models) {
            names.insert(model.name);
            for (const ModelPrimitive& primitive : model.primitives) {
                CHECK(!primitive.indices.empty());
                const auto n = static_cast<std::uint32_t>(primitive.positions.size() / 3);
                CHECK(
                    std::ranges::all_of(primitive.indices, [n](std::uint32_t i) { return i < n; }));
                CHECK(primitive.normals.size() == primitive.positions.size());
            }
        }
        CHECK(names == std::set<std::string>{std::string(kKiteModel), std::string(kLineModel),
                                             std::string(kTailModel), std::string(kWispModel),
                                             std::string(kReelModel)});
        float lowest = 1.0F;
        float highest = 0.0F;
        for (const ModelPrimitive& primitive : models[0].primitives) {
            for (std::size_t i = 1; i < primitive.positions.size(); i += 3) {
                lowest = std::min(lowest, primitive.positions[i]);
                highest = std::max(highest, primitive.positions[i]);
            }
        }
        CHECK(lowest == Approx(0.0F).margin(1e-6));
        CHECK(highest == Approx(1.0F).margin(1e-6));
        CHECK(models[0].primitives[0].base_colour != models[0].primitives[1].base_colour);
    }
}
