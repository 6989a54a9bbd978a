// A burst is a function of its place and age, and leaves nothing behind.
#include "runtime/render/overlay/bursts.h"

#include "tests/unit/runtime/render/overlay/overlay_fixture.h"
#include "tests/unit/runtime/render/picture_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

constexpr float kReach = runtime::kBurstReach + runtime::kBurstFall + 12.0F;  // and a star's own

std::vector<runtime::OverlayCorner> drawn(const std::vector<runtime::ViewBurst>& bursts) {
    runtime::Font font = runtime::andika();
    runtime::DrawList list(font);
    const Camera camera(CameraDescription{}, 1280, 720);
    runtime::draw_bursts(bursts, camera, runtime::Measure(1280, 720), list);
    return list.corners();
}

int strongest(const std::vector<runtime::OverlayCorner>& corners) {
    int most = 0;
    for (const auto& corner : corners) {
        most = std::max<int>(most, corner.rgba[3]);
    }
    return most;
}

/// From where the burst is seen to its furthest corner.
float reach(const std::vector<runtime::OverlayCorner>& corners, const Vector3& at_W) {
    const auto seen = Camera(CameraDescription{}, 1280, 720).project(at_W);
    float most = 0.0F;
    for (const auto& corner : corners) {
        most = std::max(most, std::hypot(corner.x - static_cast<float>(seen->position_px.x()),
                                         corner.y - static_cast<float>(seen->position_px.y())));
    }
    return most;
}

}  // namespace

TEST_CASE("bursts: they fly apart from their place, fade, and are over") {
    const Vector3 at_W(0.1, 0.4, 0.0);
    float last_reach = 0.0F;
    int last_alpha = 256;
    for (const double part : {0.02, 0.2, 0.45, 0.7, 0.95}) {
        const auto corners = drawn({{at_W, part * runtime::kBurstLasts_s}});
        INFO(part << " of its time");
        REQUIRE_FALSE(corners.empty());
        CHECK(reach(corners, at_W) > last_reach);
        CHECK(reach(corners, at_W) < kReach);
        CHECK(strongest(corners) < last_alpha);
        last_reach = reach(corners, at_W);
        last_alpha = strongest(corners);
    }
    CHECK(last_alpha < 40);
    CHECK(drawn({{at_W, runtime::kBurstLasts_s}}).empty());
    CHECK(drawn({{at_W, -0.1}}).empty());
    CHECK(drawn({{Vector3(0.0, 0.0, 1e3), 0.1}}).empty());  // behind the eye
    CHECK(drawn({{at_W, 0.1}, {at_W, 0.3}}).size() ==
          drawn({{at_W, 0.1}}).size() + drawn({{at_W, 0.3}}).size());
}

TEST_CASE("bursts: a picture shows them about their place, the same each time") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    runtime::View view = nothing();
    const Image bare = studio->draw(view);
    view.bursts = {{Vector3(0.0, 0.4, 0.0), 0.2}};
    const Image image = studio->draw(view);
    const int all = changed(bare, image);
    CHECK(all > 100);
    CHECK(studio->draw(view).rgba == image.rgba);
    const auto seen = Camera(view.camera, kWidth, kHeight).project(view.bursts[0].at_W);
    const float half = runtime::Measure(kWidth, kHeight).px(kReach);
    CHECK(changed(bare, image,
                  {static_cast<float>(seen->position_px.x()) - half,
                   static_cast<float>(seen->position_px.y()) - half, 2.0F * half, 2.0F * half}) ==
          all);
}
