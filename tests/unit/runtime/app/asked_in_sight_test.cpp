// What each lesson asks, with four answers to choose from, before the things that it begins with: neither caption nor choices nor a notice hides a
// hand that rests in the middle of its room, or a thing with a name.
#include "runtime/render/camera.h"
#include "runtime/render/overlay/panels.h"
#include "runtime/render/renderer.h"
#include "tests/unit/runtime/lua/lesson_folder.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

namespace fulcrum::runtime {
namespace {

using test::LessonFolder;
using PictureBox = ::fulcrum::runtime::Box;

constexpr int kChoices = 4;
constexpr double kHandRadius_m =
    0.05;  // as large as the pointing hand is at a camera's distance of 1.5 m

// Asked when what the lesson began with, the Sun, is gone.
const std::set<std::string> kAskedLater{"side_or_pole", "harder"};

/// A ball in the picture; empty where it is not seen.
PictureBox ball_seen(const Camera& camera, const Vector3& at_W, double radius_m) {
    const auto seen = camera.project(at_W);
    if (!seen) {
        return {};
    }
    const auto radius_px = static_cast<float>(radius_m * camera.px_per_m(seen->depth_m));
    return PictureBox{static_cast<float>(seen->position_px.x()),
                      static_cast<float>(seen->position_px.y()), 0.0F, 0.0F}
        .grown(radius_px);
}

/// Things that a lesson speaks of and shows from the beginning.
std::vector<PictureBox> things_seen(const LessonDescription& lesson, const Camera& camera,
                                    const Measure& page) {
    std::vector<PictureBox> things;
    for (const BodyDescription& body : lesson.bodies) {
        const bool is_named = body.movable || (body.solid && body.noun != body.name);
        const PictureBox box =
            ball_seen(camera, body.position_W, 0.5 * box_size_m(body).minCoeff());
        const bool is_whole = box.x >= 0.0F && box.y >= 0.0F && box.right() <= page.width_px &&
                              box.bottom() <= page.height_px;
        if (body.visible && is_named && body.noun != "" && is_whole) {
            things.push_back(box);
        }
    }
    return things;
}

/// As much as may stand there at once: what is asked, and its first right answer four times.
View asking(const LessonDescription& lesson, const QuestionDescription& question) {
    View view;
    view.title = lesson.title;
    view.level = 1;
    view.level_title = "Near or far?";
    view.score = 3;
    view.input_visible = true;
    view.caption = question.prompt;
    const std::vector<std::string>& right = question.examples.right;
    const std::string answer = right.empty() ? "It is harder." : right.front();
    view.choices.assign(kChoices, ViewChoice{answer, {}});
    return view;
}

TEST_CASE(
    "asked in sight: in no lesson caption, choices or a notice hide the hand or what it begins "
    "with") {
    Font font{RendererSettings{}.font_folder};
    int n_asked = 0;
    for (const char* name :
         {"gravity", "textures", "solar-system", "lever", "kite", "maze-park", "stacks"}) {
        LessonFiles files;
        files.folder = std::filesystem::path(FULCRUM_SOURCE_DIR) / "scenarios" / name;
        files.library = std::filesystem::path(FULCRUM_SOURCE_DIR) / "scripts/lib";
        const auto process = LessonProcess::start(files, LessonFolder::options());
        REQUIRE(process);
        const LessonDescription& lesson = (*process)->description();
        for (const auto& [width, height] : {std::pair{1280, 720}, {1024, 768}}) {
            const Measure page(width, height);
            const Camera camera(lesson.camera, width, height);
            const double size_m = kHandRadius_m * camera.distance_m() / 1.5;
            const PictureBox hand = ball_seen(camera, lesson.hand.centre_W, size_m);
            const std::vector<PictureBox> things = things_seen(lesson, camera, page);
            for (const QuestionDescription& question : lesson.questions) {
                View view = asking(lesson, question);
                const bool are_there = !kAskedLater.contains(question.id);
                for (const bool is_noticed : {false, true}) {
                    if (is_noticed) {
                        view.choices.clear();
                        view.banner = "Move the mouse. Turn the wheel: near and far.";
                    }
                    const PanelLayout layout = lay_out_panels(
                        view, font, page, hand, {}, are_there ? things : std::vector<PictureBox>());
                    std::vector<PictureBox> papers{layout.caption.box, layout.input.box,
                                                   layout.banner.box};
                    for (const Panel& choice : layout.choices) {
                        papers.push_back(choice.box);
                    }
                    ++n_asked;
                    for (const PictureBox& paper : papers) {
                        INFO(name << ", " << question.id << " at " << width << " x " << height
                                  << (is_noticed ? " with a notice" : "") << ", paper at "
                                  << paper.y);
                        CHECK_FALSE(paper.meets(hand));
                        CHECK(std::ranges::none_of(
                            are_there ? things : std::vector<PictureBox>(),
                            [&](const PictureBox& thing) { return paper.meets(thing); }));
                    }
                }
            }
        }
    }
    CHECK(n_asked > 100);
}

}  // namespace
}  // namespace fulcrum::runtime
