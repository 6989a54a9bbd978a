#include "runtime/render/camera.h"
#include "runtime/render/colour.h"
#include "runtime/render/image.h"
#include "runtime/render/theme.h"
#include "tests/unit/runtime/rig.h"

#include <numbers>
#include <png.h>
#include <random>

using namespace fulcrum::runtime::test;

namespace {

constexpr double kRoundTrip = 1e-9;  // a few roundings of numbers around 1000
const double kNan = std::numeric_limits<double>::quiet_NaN();

CameraDescription straight_ahead() {
    CameraDescription camera;
    camera.eye_W = Vector3(0.0, 0.0, 2.0);
    camera.target_W = Vector3::Zero();
    camera.vertical_angle_deg = 90.0;
    return camera;
}

using Bytes = std::vector<std::uint8_t>;

/// The names of a PNG's chunks, each with a blank behind it.
std::string chunks_of(const Bytes& png) {
    std::string names;
    for (std::size_t at = 8; at + 12 <= png.size();) {
        names.append(png.begin() + static_cast<long>(at + 4),
                     png.begin() + static_cast<long>(at + 8));
        names += ' ';
        at += 12 + (std::size_t{png[at]} << 24U | std::size_t{png[at + 1]} << 16U |
                    std::size_t{png[at + 2]} << 8U | png[at + 3]);
    }
    return names;
}

/// Takes a PNG apart by libpng, which checks signature, checksums, codes and filters, and complains of nothing.
Image decode(const Bytes& png) {
    png_image reader{};
    reader.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_memory(&reader, png.data(), png.size()) != 0);
    CHECK(reader.format == PNG_FORMAT_RGBA);
    CHECK(png[24] == 8);  // bits a channel
    CHECK(chunks_of(png) == "IHDR sRGB IDAT IEND ");
    Image image{static_cast<int>(reader.width), static_cast<int>(reader.height),
                Bytes(PNG_IMAGE_SIZE(reader))};
    REQUIRE(png_image_finish_read(&reader, nullptr, image.rgba.data(), 0, nullptr) != 0);
    CHECK(reader.warning_or_error == 0);
    return image;
}

Image picture(int width, int height, int kind) {
    Image image{width, height, {}};
    std::mt19937 random(static_cast<unsigned>(kind));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 4; ++c) {
                const int value = kind == 0   ? 200
                                  : kind == 1 ? x + 3 * y + 50 * c
                                              : static_cast<int>(random());
                image.rgba.push_back(static_cast<std::uint8_t>(value & 255));
            }
        }
    }
    return image;
}

}  // namespace

TEST_CASE("camera: projects in closed form") {
    const Camera camera(straight_ahead(), 1600, 900);
    const auto target = camera.project(Vector3::Zero());
    REQUIRE(target);
    CHECK(target->position_px.x() == Approx(800.0));
    CHECK(target->position_px.y() == Approx(kTargetHeight * 900.0));
    CHECK(target->depth_m == Approx(2.0));
    // At 90 degrees and 2 m half the height is 2 m; +X is right, +Y is up.
    const auto aside = camera.project(Vector3(1.0, 0.5, 0.0));
    REQUIRE(aside);
    CHECK(aside->position_px.x() == Approx(800.0 + 225.0));
    CHECK(aside->position_px.y() == Approx(kTargetHeight * 900.0 - 112.5));
}

TEST_CASE("camera: unproject undoes project, for any camera and point") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> metres(-3.0, 3.0);
    std::uniform_real_distribution<double> degrees(10.0, 100.0);
    int seen_points = 0;
    for (int i = 0; i < 2000; ++i) {
        CameraDescription description;
        description.eye_W = Vector3(metres(random), metres(random), metres(random));
        description.target_W = Vector3(metres(random), metres(random), metres(random));
        description.vertical_angle_deg = degrees(random);
        const Camera camera(description, 1280, 720);
        const Vector3 point(metres(random), metres(random), metres(random));
        const auto seen = camera.project(point);
        if (!seen) {
            continue;
        }
        ++seen_points;
        CHECK((camera.unproject(*seen) - point).norm() < kRoundTrip);
        const Ray ray = camera.ray(seen->position_px);
        CHECK(ray.direction_W.norm() == Approx(1.0));
        CHECK((point - ray.origin_W).cross(ray.direction_W).norm() < 1e-8);
    }
    CHECK(seen_points > 500);
}

TEST_CASE("camera: the matrix for OpenGL agrees with project") {
    CameraDescription description;
    description.eye_W = Vector3(0.4, 0.9, 1.3);
    description.target_W = Vector3(-0.1, 0.3, 0.1);
    const Camera camera(description, 1280, 720);
    for (const Vector3& point : {Vector3(0.2, 0.1, -0.4), Vector3(-0.5, 0.8, 0.3)}) {
        const auto seen = camera.project(point);
        REQUIRE(seen);
        const Vector4f world(static_cast<float>(point.x()), static_cast<float>(point.y()),
                             static_cast<float>(point.z()), 1.0F);
        const Vector4f clip = camera.clip_from_world() * world;
        const double x_px = 0.5 * (1.0 + static_cast<double>(clip.x() / clip.w())) * 1280.0;
        const double y_px = 0.5 * (1.0 - static_cast<double>(clip.y() / clip.w())) * 720.0;
        CHECK(x_px == Approx(seen->position_px.x()).margin(1e-2));
        CHECK(y_px == Approx(seen->position_px.y()).margin(1e-2));
        CHECK(std::abs(clip.z()) <= clip.w());
        CHECK(clip.w() == Approx(static_cast<float>(seen->depth_m)));
    }
}

TEST_CASE("camera: what lies behind the eye or is not finite is not seen") {
    const Camera camera(straight_ahead(), 800, 600);
    CHECK_FALSE(camera.project(Vector3(0.0, 0.0, 2.5)));
    CHECK_FALSE(camera.project(Vector3(0.0, 0.0, 2.0)));
    CHECK_FALSE(camera.project(Vector3(kNan, 0.0, 0.0)));
    CHECK_FALSE(camera.project(Vector3(0.0, std::numeric_limits<double>::infinity(), 0.0)));
}

TEST_CASE("camera: bad descriptions give a camera that works") {
    CameraDescription nonsense;
    nonsense.eye_W = Vector3(kNan, 0.0, 0.0);
    nonsense.vertical_angle_deg = kNan;
    const CameraDescription standard;
    const Camera repaired(nonsense, 640, 480);
    CHECK(repaired.eye_W() == standard.eye_W);
    CHECK(repaired.project(standard.target_W));

    CameraDescription on_target;
    on_target.eye_W = on_target.target_W;
    CHECK(Camera(on_target, 640, 480).forward_W().isApprox(-Vector3::UnitZ()));

    CameraDescription down;
    down.eye_W = Vector3(0.0, 5.0, 0.0);
    down.target_W = Vector3::Zero();
    const Camera from_above(down, 640, 480);
    CHECK(from_above.up_W().isApprox(-Vector3::UnitZ(), 1e-6));
    CHECK(from_above.clip_from_world().allFinite());

    CHECK(Camera(standard, 0, -5).clip_from_world().allFinite());
    CameraDescription wide;
    wide.vertical_angle_deg = 500.0;
    CHECK(Camera(wide, 640, 480).clip_from_world().allFinite());
}

TEST_CASE("camera: a narrow picture shows as much from left to right as one of 4:3") {
    const CameraDescription description;
    const Camera usual(description, 800, 600);
    const Camera narrow(description, 400, 800);
    const Vector3 edge = usual.unproject({{0.0, 0.5 * 600.0}, usual.distance_m()});
    const auto seen = narrow.project(edge);
    REQUIRE(seen);
    CHECK(seen->position_px.x() == Approx(0.0).margin(1e-6));
}

TEST_CASE("camera: the pointer lies on the upright plane through the target, and where it points") {
    const CameraDescription description;
    const Camera camera(description, 1280, 720);
    for (const double wheel_m : {0.0, 0.2, -0.15}) {
        const Vector2 pointer(300.0, 500.0);
        const auto place = pointer_on_plane(camera, pointer, wheel_m);
        REQUIRE(place);
        // The eye looks along -Z, so the plane is z = target's z - wheel.
        CHECK(place->z() == Approx(description.target_W.z() - wheel_m).margin(1e-9));
        const auto back = camera.project(*place);
        REQUIRE(back);
        CHECK((back->position_px - pointer).norm() < 1e-6);
    }
    const auto target = pointer_on_plane(camera, {640.0, kTargetHeight * 720.0}, 0.0);
    REQUIRE(target);
    CHECK((*target - description.target_W).norm() < 1e-9);
}

TEST_CASE("camera: the pointer's plane has the normal along which its wheel moves it") {
    CameraDescription aside;
    aside.eye_W = Vector3(1.0, 0.9, 1.5);
    for (const double height_m : {0.9, 8.0}) {
        aside.eye_W.y() = height_m;
        const Camera camera(aside, 1280, 720);
        const Vector3 normal = pointer_plane_normal(camera);
        CHECK(normal.norm() == Approx(1.0));
        CHECK(normal.dot(camera.forward_W()) > 0.0);
        if (height_m < 2.0) {
            CHECK(normal.y() == 0.0);
        }
        const auto place = pointer_on_plane(camera, {500.0, 320.0}, 0.1);
        REQUIRE(place);
        CHECK(normal.dot(*place - camera.target_W()) == Approx(0.1));
    }
}

TEST_CASE("camera: from steeply above, the pointer moves across the view") {
    CameraDescription down;
    down.eye_W = Vector3(0.0, 2.0, 0.1);
    down.target_W = Vector3(0.0, 0.0, 0.0);
    const Camera camera(down, 1280, 720);
    const auto place = pointer_on_plane(camera, {900.0, 200.0}, 0.0);
    REQUIRE(place);
    CHECK(camera.forward_W().dot(*place - down.target_W) == Approx(0.0).margin(1e-9));
}

TEST_CASE("camera: a pointer without a place has none") {
    const Camera camera(CameraDescription{}, 1280, 720);
    CHECK_FALSE(pointer_on_plane(camera, {kNan, 0.0}, 0.0));
    // The plane pulled behind the eye is not in front of any ray.
    CHECK_FALSE(pointer_on_plane(camera, {640.0, 300.0}, -100.0));
}

TEST_CASE("colour: contrast in closed form") {
    const Colour black = from_hex(0x000000);
    const Colour white = from_hex(0xFFFFFF);
    CHECK(contrast_ratio(black, white) == Approx(21.0));
    CHECK(contrast_ratio(white, black) == Approx(21.0));
    CHECK(contrast_ratio(white, white) == Approx(1.0));
    // White is ten times as bright as black on the projector.
    CHECK(contrast_ratio(black, white, kProjectorStrayLight) == Approx(10.0));
    // A grey that is known to be just below and above the limit on white (WCAG 2.1).
    CHECK(contrast_ratio(from_hex(0x777777), white) < 4.5);
    CHECK(contrast_ratio(from_hex(0x767676), white) > 4.5);
}

TEST_CASE("colour: sRGB decoding in closed form") {
    CHECK(to_linear(0.0F) == 0.0F);
    CHECK(to_linear(1.0F) == Approx(1.0F));
    CHECK(to_linear(0.5F) == Approx(0.21404F).epsilon(1e-4));
    CHECK(to_linear(0.04F) == Approx(0.04F / 12.92F));
    const Colour colour = from_hex(0xFF8000, 0.25F);
    CHECK(colour.r == 1.0F);
    CHECK(colour.g == Approx(128.0F / 255.0F));
    CHECK(colour.b == 0.0F);
    CHECK(colour.a == 0.25F);
}

TEST_CASE("theme: every pair of ink and paper can be read, also on a washed-out projector") {
    // Success criteria 1.4.3 and 1.4.6 of WCAG 2.1.
    CHECK(theme::kUsual.least_contrast == 4.5);
    CHECK(theme::kHighContrast.least_contrast == 7.0);
    for (const theme::Palette& palette : {theme::kUsual, theme::kHighContrast}) {
        for (const theme::InkOnPaper& words : theme::list_words(palette)) {
            INFO(words.where << ", " << palette.least_contrast);
            CHECK(contrast_ratio(words.ink, words.paper) >= palette.least_contrast);
            CHECK(contrast_ratio(words.ink, words.paper, kProjectorStrayLight) >=
                  palette.least_contrast);
            CHECK(words.ink.a == 1.0F);
            CHECK(words.paper.a == 1.0F);
        }
    }
    // High contrast has more of it, pair by pair.
    const auto usual = theme::list_words(theme::kUsual);
    const auto high = theme::list_words(theme::kHighContrast);
    for (std::size_t i = 0; i < usual.size(); ++i) {
        INFO(usual[i].where);
        CHECK(contrast_ratio(high[i].ink, high[i].paper) >
              contrast_ratio(usual[i].ink, usual[i].paper));
    }
}

TEST_CASE("png: what was written is read back, flat, sloped and random pictures") {
    for (const int kind : {0, 1, 2}) {
        for (const auto& [width, height] : {std::pair{1, 1}, {7, 5}, {640, 33}, {200, 300}}) {
            const Image image = picture(width, height, kind);
            const auto png = encode_png(image);
            REQUIRE(png);
            const Image back = decode(*png);
            CHECK(back.width == width);
            CHECK(back.height == height);
            CHECK(back.rgba == image.rgba);
        }
    }
}

TEST_CASE("png: a flat picture takes little room") {
    const auto png = encode_png(picture(640, 360, 0));
    REQUIRE(png);
    CHECK(png->size() < 640UL * 360UL * 4UL / 50UL);
}

TEST_CASE("png: a picture of a wrong size is refused in one sentence") {
    for (const Image& bad : {Image{}, Image{2, 2, Bytes(15)}, Image{-1, -4, Bytes(16)}}) {
        const auto png = encode_png(bad);
        REQUIRE_FALSE(png);
        CHECK(to_sentence(png.error()).find("picture") != std::string::npos);
    }
}

TEST_CASE("png: a file that cannot be written is named") {
    const auto saved = save_png("/no/such/folder/picture.png", picture(2, 2, 0));
    REQUIRE_FALSE(saved);
    CHECK(to_sentence(saved.error()).find("/no/such/folder/picture.png") == 0);
}

TEST_CASE("png: the file holds the encoded bytes") {
    const auto file = std::filesystem::temp_directory_path() / "fulcrum_image_test.png";
    const Image image = picture(9, 4, 1);
    REQUIRE(save_png(file, image));
    std::ifstream in(file, std::ios::binary);
    const Bytes bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    CHECK(bytes == *encode_png(image));
    std::filesystem::remove(file);
}
