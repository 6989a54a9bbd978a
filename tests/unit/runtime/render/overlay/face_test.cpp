// Whom the words come from: seen on the paper of what is said last, as it feels and whether it speaks.
#include "runtime/render/overlay/face.h"

#include "tests/unit/runtime/render/overlay/overlay_fixture.h"
#include "tests/unit/runtime/render/picture_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;
using runtime::ViewMood;

TEST_CASE("face: within its radius, and another for each mood and for speaking") {
    runtime::Font font = runtime::andika();
    std::vector<std::vector<std::array<float, 2>>> faces;
    for (const ViewMood mood : {ViewMood::calm, ViewMood::happy, ViewMood::thoughtful}) {
        for (const bool speaks : {false, true}) {
            if (speaks && mood == ViewMood::happy) {
                continue;  // an open mouth neither smiles more nor less
            }
            runtime::DrawList list(font);
            runtime::draw_face(list, {100.0F, 50.0F}, 20.0F, mood, speaks);
            auto& places = faces.emplace_back();
            for (const runtime::OverlayCorner& corner : list.corners()) {
                places.push_back({corner.x, corner.y});
                CHECK(std::abs(corner.x - 100.0F) < 22.0F);  // and the fringe of its edges
                CHECK(std::abs(corner.y - 50.0F) < 22.0F);
            }
        }
    }
    for (std::size_t i = 0; i < faces.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            CHECK(faces[i] != faces[j]);
        }
    }
}

TEST_CASE("face: it stands at the feedback, else at the caption, and never over words") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    const auto beside = [](const Box& paper) {
        const float reach = runtime::Measure(kWidth, kHeight).px(runtime::kPadX);
        return Box{paper.x - reach, paper.y, 2.0F * reach, paper.height};
    };
    runtime::View view = nothing();
    view.caption = "Feel how heavy it is.";
    const auto opens = [&] {
        view.speaks = false;
        const Image shut = studio->draw(view);
        view.speaks = true;
        return std::pair(shut, studio->draw(view));
    };
    const auto [shut, open] = opens();
    const Box caption = panels_of(view).caption.box;
    CHECK(changed(shut, open) > 8);
    CHECK(changed(shut, open, beside(caption)) == changed(shut, open));

    view.feedback = "Yes. A melon is the heaviest.";
    const auto [shut_below, open_below] = opens();
    const Box feedback = panels_of(view).feedback.box;
    const Box icon{feedback.x, feedback.y,
                   runtime::Measure(kWidth, kHeight).px(runtime::kPadX + runtime::kIconRoom),
                   feedback.height};
    CHECK(changed(shut_below, open_below) > 8);
    CHECK(changed(shut_below, open_below, icon) == changed(shut_below, open_below));
    view.mood = ViewMood::thoughtful;
    view.speaks = false;
    CHECK(changed(studio->draw(view), shut_below, icon) > 8);
}
