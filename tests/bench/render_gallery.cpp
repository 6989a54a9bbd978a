// Draws typical views to PNG files in a folder, for looking at, and prints how long a frame takes.
//
//   bench_render_gallery FOLDER [MODELS]    MODELS: where the .glb files lie
//   CSV on stdout: view, width, height, median and 90th percentile of a frame in ms, frames a
//   second, and processor time a frame in ms over all threads (steadier on a busy machine)
#include "haptics/base/clock.h"
#include "runtime/render/egl/offscreen.h"
#include "runtime/render/image.h"
#include "runtime/render/renderer.h"
#include "runtime/scene/gltf/gltf_model.h"
#include "tests/bench/harness/must.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace fulcrum;
using namespace fulcrum::runtime;

ViewBody body(const std::string& model, const Vector3& position_W, double turn_rad = 0.0,
              const std::string& label = {}) {
    ViewBody result;
    result.model = model;
    result.label = label;
    result.pose_W.position = position_W;
    result.pose_W.orientation =
        Quaternion(AngleAxis(turn_rad, Vector3(0.2, 1.0, 0.3).normalized()));
    return result;
}

/// Falling fruit, the bucket, a force and the arm's true pose.
runtime::View falling() {
    runtime::View view;
    view.camera.eye_W = Vector3(0.0, 1.0, 1.95);
    view.camera.target_W = Vector3(0.0, 0.45, 0.0);
    view.title = "Which fruit is the heaviest?";
    view.level = 2;
    view.level_title = "Three fruits";
    view.score = 7;
    view.bodies.push_back(body("tree", {0.95, 0.0, -1.3}));
    view.bodies.push_back(body("hill", {-1.5, -0.2, -5.5}));
    view.bodies.push_back(body("flower", {-0.6, 0.0, -0.3}));
    view.bodies.push_back(body("watermelon", {-0.38, 0.62, 0.02}, 0.5, "watermelon"));
    view.bodies.push_back(body("apple", {0.42, 0.36, -0.05}, 0.2, "apple"));
    view.bodies.push_back(body("banana", {0.22, 0.75, -0.10}, 1.2, "banana"));
    view.bodies.push_back(body("egg", {-0.06, 0.155, 0.0}, 0.2));
    view.bodies.push_back(body("egg", {0.62, 0.03, 0.15}, 0.2));
    view.bodies.back().scale = Vector3(1.2, 0.8, 1.2);
    view.tool = body("bucket", {-0.05, 0.13, 0.0});
    view.force = {true, {-0.05, 0.13, 0.0}, {0.0, -2.8, 0.0}, "felt 2.8 N · true 0.6 N"};
    view.ghost_visible = true;
    view.ghost_pose_W.position = Vector3(-0.09, 0.11, 0.03);
    view.caption = "Catch the fruit with the bucket.";
    return view;
}

runtime::View question() {
    runtime::View view = falling();
    view.bodies.resize(3);
    view.bodies.push_back(body("watermelon", {-0.42, 0.09, 0.0}, 0.4, "watermelon"));
    view.bodies.push_back(body("apple", {0.02, 0.045, 0.1}, 0.0, "apple"));
    view.bodies.push_back(body("banana", {0.42, 0.04, 0.0}, 0.3, "banana"));
    view.tool_visible = false;
    view.ghost_visible = false;
    view.force.visible = false;
    view.caption = "Which one is the heaviest?";
    view.input_visible = true;
    view.input = "the watermelon is";
    return view;
}

runtime::View recast() {
    runtime::View view = question();
    view.bodies[3].light = BodyLight::offered;
    view.feedback = "Yes. A watermelon is *the heaviest*.";
    view.caption = "Now say the whole sentence again.";
    view.input = "";
    view.score = 8;
    return view;
}

runtime::View wrong() {
    runtime::View view = falling();
    view.bodies.resize(5);
    view.feedback = "Feel both again: which one pulls *harder* on your hand?";
    view.caption =
        "Weigh the apple, then the watermelon. Move the bucket under each of them and wait.";
    view.force = {true, {-0.05, 0.13, 0.0}, {1.2, 2.0, 0.0}, "felt 2.3 N"};
    return view;
}

runtime::View broken() {
    runtime::View view = falling();
    view.caption.clear();
    view.banner_is_error = true;
    view.banner =
        "scenarios/gravity/lesson.lua:42: attempt to index a nil value (local 'basket'); "
        "mend the line and save, the lesson then starts again.";
    return view;
}

runtime::View notice() {
    runtime::View view = falling();
    view.banner = "The arm is not plugged in, so the mouse moves the bucket.";
    return view;
}

runtime::View finished() {
    runtime::View view = question();
    view.input_visible = false;
    view.stars = 2;
    view.feedback = "Well done! You made *comparisons* with six words.";
    view.caption = "Press the space bar to play again.";
    return view;
}

runtime::View menu(int lessons, int selected) {
    const std::vector<ViewMenuItem> all{
        {"Which fruit is the heaviest?", "A1 · 15 minutes", "watermelon"},
        {"Rough or smooth?", "A1 · 10 minutes", "plank"},
        {"Around the sun", "A2 · 20 minutes", "star"},
        {"A lever moves the earth", "A2 · 15 minutes", "egg"},
        {"Fly the kite", "B1 · 15 minutes", "cloud"},
        {"Through the maze", "A1 · 10 minutes", "ghost"},
        {"The science room", "A1 · as long as you like", "flower"},
        {"A very long title that nobody should ever give to a lesson, but somebody will", "B2",
         "apple"},
        {"Nine", "A1", "banana"},
    };
    runtime::View view;
    view.title = "What shall we play?";
    view.caption = "Choose with the arrow keys, then press Enter.";
    view.menu.assign(all.begin(), all.begin() + lessons);
    view.menu_selected = selected;
    return view;
}

void load_models(Renderer& renderer, const std::filesystem::path& folder) {
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
        if (entry.path().extension() != ".glb") {
            continue;
        }
        const Expected<void> added = load_gltf(entry.path()).and_then([&](const auto& model) {
            return renderer.add_model(model);
        });
        if (!added) {
            std::fprintf(stderr, "%s\n", to_sentence(added.error()).c_str());
        }
    }
}

/// Times frames after a warm-up and prints a line of CSV.
void measure(const std::string& name, const runtime::View& view, Renderer& renderer,
             Offscreen& screen) {
    constexpr int kWarmUp = 5;
    constexpr int kFrames = 20;
    std::vector<double> times_ms;
    std::clock_t processor_start = 0;
    for (int i = 0; i < kWarmUp + kFrames; ++i) {
        if (i == kWarmUp) {
            processor_start = std::clock();
        }
        const double start_s = monotonic_now_s();
        renderer.draw(view, screen.width(), screen.height());
        screen.finish();
        if (i >= kWarmUp) {
            times_ms.push_back(1e3 * (monotonic_now_s() - start_s));
        }
    }
    const double processor_ms =
        1e3 * static_cast<double>(std::clock() - processor_start) / CLOCKS_PER_SEC / kFrames;
    std::sort(times_ms.begin(), times_ms.end());
    const double median_ms = times_ms[times_ms.size() / 2];
    std::printf("%s,%d,%d,%.2f,%.2f,%.1f,%.1f\n", name.c_str(), screen.width(), screen.height(),
                median_ms, times_ms[times_ms.size() * 9 / 10], 1e3 / median_ms, processor_ms);
}

void run(const std::filesystem::path& folder, const std::filesystem::path& models) {
    const auto screen = bench::must(Offscreen::create(1280, 720));
    const auto renderer = bench::must(Renderer::create());
    for (const std::string& sentence : renderer->notices()) {
        std::fprintf(stderr, "%s\n", sentence.c_str());
    }
    load_models(*renderer, models);
    std::filesystem::create_directories(folder);

    const std::vector<std::pair<std::string, runtime::View>> views{
        {"falling", falling()},   {"question", question()}, {"recast", recast()},
        {"wrong", wrong()},       {"error", broken()},      {"notice", notice()},
        {"finished", finished()}, {"menu1", menu(1, 0)},    {"menu3", menu(3, 1)},
        {"menu7", menu(7, 4)},    {"menu9", menu(9, 7)},    {"empty", runtime::View{}}};
    std::printf("view,width,height,median_ms,p90_ms,frames_per_s,processor_ms\n");
    for (const auto& [name, view] : views) {
        measure(name, view, *renderer, *screen);
        bench::must(save_png(folder / (name + ".png"), screen->read_back()));
    }
    for (const auto& [width, height] : {std::pair{1920, 1080}, {800, 600}, {480, 800}}) {
        if (screen->resize(width, height)) {
            measure("wrong", wrong(), *renderer, *screen);
            const std::string name = "wrong_" + std::to_string(width) + ".png";
            (void)save_png(folder / name, screen->read_back());
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: bench_render_gallery FOLDER [MODELS]\n");
        return 2;
    }
    try {
        run(argv[1], argc > 2 ? argv[2] : FULCRUM_MODELS_DIR);
        return 0;
    } catch (const std::runtime_error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
