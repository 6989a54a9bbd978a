// Which law a texture is felt by, and how finely its picture is drawn: what is felt, how true it is, what it gives.
//
// The plan is what a lesson with a plate of that material gets: coupling, energy's loan, passivity and gate as they ship.
#include "haptics/surface/materials.h"
#include "haptics/surface/texture.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/sent_force.h"
#include "tests/support/touchable.h"

namespace fulcrum::bench {
namespace {

constexpr double kPlate_m = 0.2;
constexpr double kStroke_m_per_s = 0.1;
constexpr double kPress_N = 2.0;
constexpr double kWave_m = 0.002;

struct Law {
    TextureLaw law;
    const char* name;
};
constexpr Law kLaws[] = {{TextureLaw::perturbed_normal, "perturbed normal"},
                         {TextureLaw::lateral, "lateral"},
                         {TextureLaw::height_offset, "height offset"}};

struct Sent {
    double along_N = 0.0;    // rms about the mean, along the stroke
    double energy_mJ = 0.0;  // given in a closed path
};

// A hand that presses downhill and lifts uphill, to and fro over the plate: so a law that is no gradient gives most.
Sent stroke(const TextureSettings& texture) {
    Material material = *find_material("metal");
    material.friction = {};
    material.texture = texture;
    test::SentForce loop(test::make_touch_lesson(material, false),
                         touchable(must(make_box(Vector3::Constant(kPlate_m)))));
    const double depth_m = kPress_N / loop.plan().solids.front().coupling->stiffness_N_per_m;
    const double top_m = 0.5 * kPlate_m;
    constexpr double kHalfWay_m = 10.25 * kWave_m;  // to where it turns from downhill to uphill
    const auto place = [&](double s_m) {
        const bool goes_back = s_m > 2 * kHalfWay_m;
        const double x_m = goes_back ? 3 * kHalfWay_m - s_m : s_m - kHalfWay_m;
        const double uphill =
            (goes_back ? -1.0 : 1.0) * std::cos(2.0 * std::numbers::pi * x_m / kWave_m);
        return Vector3(x_m, top_m - depth_m * (1.0 - 0.3 * uphill), 0.0);
    };
    loop.open_gate({-kHalfWay_m, top_m + 0.001, 0.0});
    for (double y_m = top_m + 0.001; y_m > place(0.0).y(); y_m -= 1.0e-5) {
        (void)loop.step({-kHalfWay_m, y_m, 0.0});
    }
    const double step_m = kStroke_m_per_s / loop.plan().rate_hz;
    Sent sent;
    RootMeanSquare along_N;
    Vector3 before_N = loop.step(place(0.0));
    Vector3 before_W = place(0.0);
    for (int n = 0; n < 2; ++n) {  // the second round counts
        for (double s_m = 0.0; s_m < 4 * kHalfWay_m; s_m += step_m) {
            const Vector3 hand_W = place(s_m);
            const Vector3 force_N = loop.step(hand_W);
            if (n == 1) {
                along_N.add(force_N.x());
                sent.energy_mJ += 1.0e3 * before_N.dot(hand_W - before_W);
            }
            before_N = force_N;
            before_W = hand_W;
        }
    }
    sent.along_N = along_N.swing();
    return sent;
}

TextureSettings make_grooves(TextureLaw law, double height_m) {
    TextureSettings settings;
    settings.source = SineTexture{kWave_m, 0.0};
    settings.law = law;
    settings.height_m = height_m;
    return settings;
}

Report run_texture_laws(Run& run) {
    LineChart along;
    along.name = "texture-laws-along";
    along.title = "How strongly grooves are felt along a stroke, by each law";
    along.work =
        "Grooves of 2 mm in metal without friction, stroked at 0.1 m/s with 2 N; the hand presses "
        "downhill and lifts uphill, by a third.";
    along.advice =
        "The lateral law, which most materials have that ship, is as strong as the relief is "
        "high; the perturbed normal fades with its square.";
    along.x = {"height of the grooves", "um", true};
    along.y = {"rms of the force along the stroke", "N", true};
    LineChart energy = along;
    energy.name = "texture-laws-energy";
    energy.title = "What grooves give to a hand that presses downhill, by each law";
    energy.reference = "a flat plate, taken off";
    energy.y = {"given in 82 mm there and back, beyond a flat plate", "mJ", false};
    const double flat_mJ = stroke({}).energy_mJ;
    const auto heights_um = run.pick<std::vector<double>>({10, 20, 50, 100, 200, 500}, {50, 200});
    for (const Law& law : kLaws) {
        Line a{law.name};
        Line e = a;
        for (const double height_um : heights_um) {
            const Sent sent = stroke(make_grooves(law.law, 1.0e-6 * height_um));
            a.add(height_um, sent.along_N);
            e.add(height_um, sent.energy_mJ - flat_mJ);
        }
        along.lines.push_back(a);
        energy.lines.push_back(e);
    }
    return {along, energy};
}

// The same grooves as a picture of `n` points a wave, ten waves wide.
TextureSettings make_picture(TextureLaw law, int n) {
    constexpr int kWaves = 10;
    auto map = std::make_shared<HeightMap>();
    map->n_u = kWaves * n;
    map->n_v = 4;
    for (int v = 0; v < map->n_v; ++v) {
        for (int u = 0; u < map->n_u; ++u) {
            map->heights.push_back(
                static_cast<float>(0.5 + 0.5 * std::sin(2.0 * std::numbers::pi * (u + 0.5) / n)));
        }
    }
    TextureSettings settings = make_grooves(law, 1.0e-4);
    settings.source = ImageTexture{std::move(map), kWaves * kWave_m, kWave_m};
    return settings;
}

// Of the relief's slope against the sine's, along a slow stroke: root mean square over that of the sine, shifted so that both fit best.
double find_slope_error(int n) {
    const Texture picture(make_picture(TextureLaw::lateral, n));
    const Texture sine(make_grooves(TextureLaw::lateral, 1.0e-4));
    constexpr int kSamples = 4000;
    constexpr double kDepth_m = 0.002;
    const auto felt = [&](const Texture& texture, double shift_m) {
        std::vector<double> values;
        for (int i = 0; i < kSamples; ++i) {
            const double u_m = 10 * kWave_m * i / kSamples + shift_m;
            values.push_back(texture.feel({u_m, 0.0007}, {}, kDepth_m).along.u_m);
        }
        return values;
    };
    const std::vector<double> drawn = felt(picture, 0.0);
    double best = HUGE_VAL;
    double best_m = 0.0;
    // About the best place so far, ever more closely.
    for (double span_m = kWave_m; span_m > 1.0e-4 * kWave_m; span_m *= 0.1) {
        const double middle_m = best_m;
        for (int i = -10; i <= 10; ++i) {
            const double shift_m = middle_m + 0.05 * span_m * i;
            const std::vector<double> exact = felt(sine, shift_m);
            RootMeanSquare error;
            RootMeanSquare all;
            for (std::size_t k = 0; k < exact.size(); ++k) {
                error.add(drawn[k] - exact[k]);
                all.add(exact[k]);
            }
            if (error.value() / all.value() < best) {
                best = error.value() / all.value();
                best_m = shift_m;
            }
        }
    }
    return best;
}

Report run_texture_pictures(Run& run) {
    LineChart chart;
    chart.name = "texture-pictures";
    chart.title = "How true a relief is felt, over its picture's points a wave";
    chart.work =
        "The slope of sine grooves of 2 mm that a picture draws, felt slowly, against the sine's.";
    chart.reference = "the sine itself, shifted to where it fits best";
    chart.advice =
        "Draw the finest detail with eight points: a lesson's tile of 50 mm with 2 mm grooves "
        "then needs 200 across.";
    chart.x = {"points a wave", "", true};
    chart.y = {"rms error of the slope, of the sine's", "", true};
    chart.trace("picture", LineStyle::measured,
                run.pick<std::vector<double>>({3, 4, 5, 6, 8, 12, 16, 24, 32}, {4, 16}),
                [](double n) { return find_slope_error(static_cast<int>(n)); });
    return {chart};
}

const Registration kTextureLaws{
    {"texture-laws", "what each law of a texture gives the hand, over the relief's height",
     run_texture_laws}};
const Registration kTexturePictures{{"texture-pictures",
                                     "how true a texture's picture is felt, over its resolution",
                                     run_texture_pictures}};

}  // namespace
}  // namespace fulcrum::bench
