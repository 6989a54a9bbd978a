// What a coarser picture saves, and what it loses: runtime/render/picture_quality.h.
//
// Truth: the same view at twice the size, 4 samples a pixel, averaged: 16 samples.
#include "runtime/render/egl/offscreen.h"
#include "runtime/render/picture_quality.h"
#include "runtime/render/renderer.h"
#include "runtime/render/scene/shapes.h"
#include "tests/bench/harness/measure.h"
#include "tests/bench/harness/must.h"
#include "tests/bench/harness/registry.h"
#include "tests/bench/harness/root_mean_square.h"

namespace fulcrum::bench {
namespace {

using runtime::Image;

constexpr int kWidth_px = 1280;
constexpr int kHeight_px = 720;
constexpr int kBalls = 12;

runtime::View make_view() {
    runtime::View view;
    view.title = "Which one is the heaviest?";
    view.caption = "Feel how heavy it is.";
    for (int i = 0; i < kBalls; ++i) {
        runtime::ViewBody body;
        body.model = "ball";
        body.pose_W.position = Vector3(-0.55 + 0.1 * i, 0.1 + 0.07 * (i % 5), -0.1 * (i % 3));
        view.bodies.push_back(body);
    }
    view.tool = view.bodies.front();
    view.force = {true, {0.0, 0.3, 0.0}, {0.0, -3.0, 0.0}, "felt 3.0 N"};
    return view;
}

struct Studio {
    std::unique_ptr<runtime::Offscreen> screen;
    std::unique_ptr<runtime::Renderer> renderer;

    Studio(int width_px, int height_px)
        : screen(must(runtime::Offscreen::create(width_px, height_px))),
          renderer(must(runtime::Renderer::create())) {
        runtime::LoadedModel ball = runtime::make_ball(0.06F, {0.7F, 0.1F, 0.05F, 1.0F});
        ball.name = "ball";
        must(renderer->add_model(ball));
    }
    void draw(const runtime::View& view, const runtime::PictureQuality& quality) const {
        renderer->draw(view, screen->width(), screen->height(), quality);
        screen->finish();
    }
};

// Of a pixel and its channels, 0 to 255. Words are set by the pixel, so only the scene is compared: what lies above them.
double find_error(const Image& drawn, const Image& twice) {
    RootMeanSquare error;
    for (int y = kHeight_px / 6; y < kHeight_px * 3 / 4; ++y) {
        for (int x = 0; x < kWidth_px; ++x) {
            for (int channel = 0; channel < 3; ++channel) {
                const auto at = [&](const Image& image, int px, int py) {
                    return static_cast<double>(
                        image
                            .rgba[static_cast<std::size_t>(4 * (py * image.width + px) + channel)]);
                };
                const double truth =
                    0.25 * (at(twice, 2 * x, 2 * y) + at(twice, 2 * x + 1, 2 * y) +
                            at(twice, 2 * x, 2 * y + 1) + at(twice, 2 * x + 1, 2 * y + 1));
                error.add(at(drawn, x, y) - truth);
            }
        }
    }
    return error.value();
}

// Of all threads: without a graphics card they share the drawing.
double process_time_us() {
    timespec now{};
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1.0e6 * static_cast<double>(now.tv_sec) + 1.0e-3 * static_cast<double>(now.tv_nsec);
}

Report run_picture_levels(Run& run) {
    CostCurve curve;
    curve.name = "picture-levels";
    curve.title = "What a coarser picture saves, and what it loses";
    curve.work =
        "A scene of 12 balls with shadows, words and an arrow, 1280 x 720: processor time of a "
        "picture over all threads (without a graphics card that is the drawing).";
    curve.reference = "converged: twice the size and 4 samples, averaged to 16 samples a pixel";
    curve.advice =
        "Leave the choice to the program: it takes the finest level that gives 30 pictures a "
        "second.";
    curve.knob = {"dots drawn of those shown", "", false};
    curve.error = {"error of a channel, rms of 255", "", false};
    curve.default_series = "best";
    curve.default_knob = 1.0;
    curve.time_is_per = "picture";
    const runtime::View view = make_view();
    const Studio twice(2 * kWidth_px, 2 * kHeight_px);
    twice.draw(view, {});
    const Image truth = twice.screen->read_back();
    const Studio studio(kWidth_px, kHeight_px);
    constexpr std::array<const char*, runtime::kPictureLevels.size()> kNames{"best", "good", "fair",
                                                                             "fast"};
    const int n = run.pick(60, 8);
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        run.progress(i, kNames.size(), kNames[i]);
        const runtime::PictureQuality& quality = runtime::kPictureLevels[i];
        studio.draw(view, quality);
        studio.draw(view, quality);
        std::vector<double> took_us;
        for (int k = 0; k < n; ++k) {
            const double before_us = process_time_us();
            studio.draw(view, quality);
            took_us.push_back(process_time_us() - before_us);
        }
        std::ranges::sort(took_us);
        const auto bytes = static_cast<std::size_t>(8.0 * kWidth_px * kHeight_px * quality.samples *
                                                    quality.scale * quality.scale);
        curve.add(kNames[i], quality.scale * quality.scale,
                  find_error(studio.screen->read_back(), truth),
                  {took_us[took_us.size() / 2], took_us[took_us.size() * 99 / 100], bytes});
    }
    return {curve};
}

const Registration kPictures{
    {"picture-levels", "what a coarser picture saves, and what it loses", run_picture_levels}};

}  // namespace
}  // namespace fulcrum::bench
