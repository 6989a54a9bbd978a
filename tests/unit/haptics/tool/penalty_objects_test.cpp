// An implicit tool among more contacts than are told of at a time.
#include "haptics/tool/implicit_penalty.h"
#include "tests/support/field_parts.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum {
namespace {

TEST_CASE("implicit penalty: among six walls the last one holds as the first one does") {
    const Vector3 size(0.2, 0.1, 0.2);
    constexpr double kBlock_m = 0.3;
    constexpr double kPress_m = 0.02;
    const auto field = test::make_field(make_box(Vector3::Constant(kBlock_m)).value(), 96);
    const auto shell = test::make_shell(make_box(size).value(), 6000);
    const std::array<Vector3, 6> directions{-Vector3::UnitY(), -Vector3::UnitX(), Vector3::UnitX(),
                                            -Vector3::UnitZ(), Vector3::UnitY(),  Vector3::UnitZ()};
    std::vector<MovingFrame> objects(directions.size());
    ImplicitPenaltyPlan plan;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const Vector3& d = directions[i];
        objects[i].pose_W =
            Pose::at(d * (0.5 * kBlock_m + 0.5 * size.cwiseProduct(d.cwiseAbs()).sum() + 4.0e-4));
        plan.objects.push_back({field, shell});
    }
    plan.settings.inertia = make_box_inertia(0.05, size);
    plan.settings.coupling.shift.stiffness_N_per_m = 500.0;
    plan.settings.coupling.turn.stiffness_Nm_per_rad = 2.0;
    for (const std::size_t against : {std::size_t{0}, directions.size() - 1}) {
        CAPTURE(against);
        ImplicitPenaltyTool tool = ImplicitPenaltyTool::build(plan).value();
        tool.place(Pose{});
        ToolFelt felt;
        for (int i = 1; i <= 400; ++i) {
            const double share = std::min(1.0, i / 200.0);
            felt = tool.move({Pose::at(share * kPress_m * directions[against]), {}}, objects,
                             1.0e-3 * i, 1.0e-3);
        }
        // There are more clusters than are told of, which is said, and none is without.
        CHECK(tool.model().n == kMostClusters);
        CHECK_FALSE(felt.effort.in_time);
        std::array<int, 6> n_of{};
        for (const ToldContact& told : tool.model().all()) {
            ++n_of.at(static_cast<std::size_t>(told.object));
        }
        CHECK(std::ranges::all_of(n_of, [](int n) { return n > 0; }));
        CHECK(tool.centre_W().norm() < 1.0e-3);
        CHECK(felt.felt_W.force.dot(-directions[against]) == Approx(500.0 * kPress_m).epsilon(0.1));
    }
}

}  // namespace
}  // namespace fulcrum
