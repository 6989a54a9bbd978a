// The made models, as the program will read them.
#include "assets/make/models.h"

#include "assets/make/glb_writer.h"
#include "haptics/geometry/mesh_report.h"
#include "runtime/lua/api/reference_sections.h"
#include "runtime/render/theme.h"
#include "runtime/scene/gltf/collision_from_model.h"
#include "runtime/scene/gltf/gltf_model.h"
#include "runtime/scene/shape_models.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <vector>

using namespace fulcrum;
using namespace fulcrum::assets;

namespace {

struct Maker {
    const char* name;
    Model (*make)();
    Vector3 size_m;  ///< of the box around it
};

const std::array<Maker, 43> kMakers{{{"watermelon", make_watermelon, {0.20, 0.166, 0.172}},
                                     {"apple", make_apple, {0.080, 0.085, 0.080}},
                                     {"banana", make_banana, {0.162, 0.061, 0.038}},
                                     {"egg", make_egg, {0.044, 0.057, 0.044}},
                                     {"bucket", make_bucket, {0.254, 0.185, 0.235}},
                                     {"cursor", make_cursor, {0.0914, 0.139, 0.0547}},
                                     {"ghost", make_ghost, {0.04, 0.04, 0.04}},
                                     {"star", make_star, {0.091, 0.086, 0.034}},
                                     {"ground", make_ground, {8.0, 0.21, 8.0}},
                                     {"hill", make_hill, {3.0, 0.51, 3.0}},
                                     {"tree", make_tree, {0.84, 1.21, 0.74}},
                                     {"cloud", make_cloud, {0.51, 0.24, 0.20}},
                                     {"flower", make_flower, {0.046, 0.103, 0.028}},
                                     {"plank", make_plank, {0.9, 0.025, 0.2}},
                                     {"sphere", make_sphere, {2.0, 2.0, 2.0}},
                                     {"box", make_box, {2.0, 2.0, 2.0}},
                                     {"cloth", make_cloth, {2.79, 2.11, 2.78}},
                                     {"spaceship", make_spaceship, {0.107, 0.18, 0.096}},
                                     {"table", make_table, {0.17, 0.119, 0.11}},
                                     {"statue", make_statue, {0.091, 0.156, 0.084}},
                                     {"bell", make_bell, {0.096, 0.1115, 0.096}},
                                     {"chair", make_chair, {0.084, 0.173, 0.084}},
                                     {"castle", make_castle, {0.165, 0.148, 0.0925}},
                                     {"sun", make_sun, {2.0, 2.0, 2.0}},
                                     {"mercury", make_mercury, {2.0, 2.0, 2.0}},
                                     {"venus", make_venus, {2.0, 2.0, 2.0}},
                                     {"earth", make_earth, {2.0, 2.0, 2.0}},
                                     {"mars", make_mars, {2.0, 2.0, 2.0}},
                                     {"jupiter", make_jupiter, {2.0, 2.0, 2.0}},
                                     {"saturn", make_saturn, {4.54, 2.0, 4.54}},
                                     {"uranus", make_uranus, {2.0, 2.0, 2.0}},
                                     {"neptune", make_neptune, {2.0, 2.0, 2.0}},
                                     {"lever", make_lever, {1.18, 0.236, 0.2}},
                                     {"support", make_support, {0.15, 0.3, 0.18}},
                                     {"ring", make_ring, {0.16, 0.032, 0.16}},
                                     {"bowl", make_bowl, {0.2, 0.1, 0.2}},
                                     {"walker", make_walker, {0.0437, 0.071, 0.0437}},
                                     {"gem", make_gem, {0.038, 0.060, 0.044}},
                                     {"handles", make_handles, {0.48, 0.1, 0.48}},
                                     {"cylinder", make_cylinder, {0.08, 0.16, 0.08}},
                                     {"capsule", make_capsule, {0.08, 0.2, 0.08}},
                                     {"hand", make_hand, {0.0914, 0.139, 0.0547}},
                                     {"kite", make_kite, {0.15, 0.3, 0.008}}}};

/// Each model is made once.
const Model& made(const Maker& maker) {
    static std::map<std::string, Model> models;
    const auto found = models.find(maker.name);
    return found != models.end() ? found->second
                                 : models.emplace(maker.name, maker.make()).first->second;
}

runtime::LoadedModel load(const Model& model) {
    const auto bytes = encode_glb(model);
    auto loaded = runtime::read_gltf(std::as_bytes(std::span(bytes)), model.name + ".glb");
    INFO((loaded ? "" : to_sentence(loaded.error())));
    REQUIRE(loaded.has_value());
    return *loaded;
}

/// A model's first part, which is the fruit itself.
TriangleMesh first_part(const Model& model) {
    auto loaded = load(model);
    loaded.primitives.resize(1);
    auto mesh = runtime::collision_from_model(loaded, model.name);
    REQUIRE(mesh.has_value());
    return *mesh;
}

std::size_t triangles_of(const Model& model) {
    std::size_t n = 0;
    for (const MeshPart& part : model.parts) {
        n += part.indices.size() / 3;
    }
    return n;
}

Vector3 corner(const runtime::ModelPrimitive& p, const std::vector<float>& list, std::size_t i) {
    const std::size_t at = 3 * std::size_t{p.indices[i]};
    return {list[at], list[at + 1], list[at + 2]};
}

}  // namespace

TEST_CASE("models: the reference of lessons names every one, and no other") {
    std::vector<std::string_view> names;
    for (const Maker& maker : kMakers) {
        names.push_back(maker.name);
    }
    names.push_back(runtime::kOrbitModel);  // which the program draws by itself
    CHECK(std::equal(names.begin(), names.end(), runtime::kModelNames.begin(),
                     runtime::kModelNames.end()));
}

// In one case, since making them takes a while.
TEST_CASE("assets: every model is what lessons say, can be loaded, and is drawn rightly") {
    SECTION("it passes the loader, under its name, in its size, not too heavy to draw") {
        std::size_t total = 0;
        for (const Maker& maker : kMakers) {
            CAPTURE(maker.name);
            const Model& model = made(maker);
            CHECK(model.name == maker.name);
            const auto loaded = load(model);
            CHECK(loaded.images.size() == model.pictures.size());
            const auto mesh = runtime::collision_from_model(loaded, model.name);
            REQUIRE(mesh.has_value());
            const Vector3 size_m = mesh->upper_B() - mesh->lower_B();
            // 3 %: the table above is rounded.
            CHECK((size_m - maker.size_m).cwiseAbs().maxCoeff() < 0.03 * maker.size_m.maxCoeff());
            CHECK(triangles_of(model) <= 16'000);
            total += triangles_of(model);
        }
        // Fruit, bucket and a scenery of a tree, a hill and two clouds stay below 100 000 triangles together, and a lesson's things
        // below 50 000; the Sun and its planets below 60 000; post and pill below 5 000, hand and kite below 3 000.
        CHECK(total < 268'000);
    }
    SECTION("normals are of unit length and agree with their triangles") {
        for (const Maker& maker : kMakers) {
            CAPTURE(maker.name);
            const auto loaded = load(made(maker));
            for (const auto& p : loaded.primitives) {
                double against = 0.0;
                double all = 0.0;
                for (std::size_t i = 0; i < p.indices.size(); i += 3) {
                    const Vector3 a = corner(p, p.positions, i);
                    const Vector3 across = (corner(p, p.positions, i + 1) - a)
                                               .cross(corner(p, p.positions, i + 2) - a);
                    const Vector3 mean = corner(p, p.normals, i) + corner(p, p.normals, i + 1) +
                                         corner(p, p.normals, i + 2);
                    REQUIRE(corner(p, p.normals, i).norm() == Approx(1.0).epsilon(1e-5));
                    all += across.norm();
                    against += across.dot(mean) < 0.0 ? across.norm() : 0.0;
                }
                // At a leaf's sharp tip both sides share their corners: a crumb of the area.
                CHECK(against <= 0.002 * all);
            }
        }
    }
    SECTION("the ghost can be seen through, everything else cannot") {
        for (const Maker& maker : kMakers) {
            CAPTURE(maker.name);
            for (const auto& p : load(made(maker)).primitives) {
                CHECK((p.base_colour[3] < 1.0F) == (std::string(maker.name) == "ghost"));
            }
        }
    }
}

TEST_CASE("assets: the hand has the colour in which all that hands hold is drawn") {
    const auto& glove = load(made({"cursor", make_cursor, {}})).primitives.front().base_colour;
    const runtime::Colour wanted = runtime::theme::kHand;
    CHECK(glove[0] == Approx(runtime::to_linear(wanted.r)).margin(1e-3));
    CHECK(glove[1] == Approx(runtime::to_linear(wanted.g)).margin(1e-3));
    CHECK(glove[2] == Approx(runtime::to_linear(wanted.b)).margin(1e-3));
}

TEST_CASE("assets: the same model is the same file every time") {
    CHECK(encode_glb(make_banana()) == encode_glb(make_banana()));
    CHECK(encode_glb(make_bucket()) == encode_glb(make_bucket()));
}

TEST_CASE(
    "assets: fruit and simple shapes are closed, face outwards, and balance at their origin") {
    for (const auto make : {make_watermelon, make_apple, make_banana, make_egg, make_sphere,
                            make_box, make_cylinder, make_capsule}) {
        const Model model = make();
        CAPTURE(model.name);
        const TriangleMesh mesh = first_part(model);
        CHECK(compute_mesh_report(mesh).is_closed());
        Vector3 moment = Vector3::Zero();
        double volume_m3 = 0.0;
        for (const auto& t : mesh.triangles()) {
            const auto at = [&](std::size_t k) {
                return mesh.vertices_B()[static_cast<std::size_t>(t[k])];
            };
            const double v = at(0).dot(at(1).cross(at(2))) / 6.0;
            volume_m3 += v;
            moment += v * (at(0) + at(1) + at(2)) / 4.0;
        }
        CHECK(volume_m3 > 0.0);
        CHECK((moment / volume_m3).norm() < 1e-4);
    }
}

TEST_CASE("assets: an egg has the volume of its formula") {
    // Narushin, Romanov & Griffin 2021: V = pi/4 B^2 * integral of (L^2 - 4x^2) / (L^2 + 8wx + 4w^2), by Simpson's rule.
    const double L = 0.057;
    const double B = 0.044;
    const double w = 0.0034;
    const auto area = [&](double x) {
        return (L * L - 4 * x * x) / (L * L + 8 * w * x + 4 * w * w);
    };
    const int n = 200;
    double sum = 0.0;
    for (int i = 0; i <= n; ++i) {
        const double weight = i == 0 || i == n ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
        sum += weight * area(-0.5 * L + L * i / n);
    }
    const double expected_m3 = M_PI / 4.0 * B * B * sum * (L / n) / 3.0;
    // The triangles lie inside the curved shell: less than half a percent is missing.
    const Bulk bulk = bulk_of(make_egg().parts.front());
    CHECK(bulk.volume_m3 < expected_m3);
    CHECK(bulk.volume_m3 > 0.995 * expected_m3);
}

TEST_CASE("assets: an egg is pointed above and blunt below") {
    const Model egg = make_egg();
    // Its widest place lies below the middle between its ends: by the formula, w of 3.4 mm or a little less.
    double widest_m = 0.0;
    double widest_y_m = 0.0;
    double top_m = -1.0;
    double bottom_m = 1.0;
    for (const Vector3& p : egg.parts.front().positions) {
        const double r = std::hypot(p.x(), p.z());
        widest_y_m = r > widest_m ? p.y() : widest_y_m;
        widest_m = std::max(widest_m, r);
        top_m = std::max(top_m, p.y());
        bottom_m = std::min(bottom_m, p.y());
    }
    CHECK(widest_y_m < 0.5 * (top_m + bottom_m) - 0.002);
    CHECK(widest_y_m > 0.5 * (top_m + bottom_m) - 0.006);
}

TEST_CASE("assets: the bucket is open upwards, wide and deep as lessons say; a melon fits in") {
    const auto loaded = load(make_bucket());
    // The inner sheet is the second part: nothing of it lies above the rim or closer to the axis than the floor allows.
    const auto& inner = loaded.primitives.at(1);
    double rim_m = 0.0;
    double lowest_m = 0.0;
    for (std::size_t i = 0; i < inner.positions.size(); i += 3) {
        const double r = std::hypot(inner.positions[i], inner.positions[i + 2]);
        const double y = inner.positions[i + 1];
        lowest_m = std::min(lowest_m, y);
        CHECK(y < 1e-6);
        if (y > -1e-6) {
            rim_m = std::max(rim_m, r);
            CHECK(r > 0.109);
        }
    }
    CHECK(rim_m == Approx(0.11));
    CHECK(lowest_m == Approx(-0.14));
    // Its floor looks up.
    for (std::size_t i = 0; i < inner.positions.size(); i += 3) {
        if (inner.positions[i + 1] < -0.1399F &&
            std::hypot(inner.positions[i], inner.positions[i + 2]) < 0.05F) {
            CHECK(inner.normals[i + 1] > 0.99F);
        }
    }
    double melon_m = 0.0;
    const Model melon = make_watermelon();
    for (const Vector3& p : melon.parts.front().positions) {
        melon_m = std::max(melon_m, std::hypot(p.x(), p.z()));
    }
    CHECK(melon_m < rim_m);
}

TEST_CASE("assets: colours tell the fruit apart, by brightness too") {
    // Mean relative luminance of each fruit's picture; colour alone must not be what tells them apart.
    const auto luminance = [](const Model& model) {
        double sum = 0.0;
        const auto& rgb = model.pictures.front().rgb;
        for (std::size_t i = 0; i < rgb.size(); i += 3) {
            const auto linear = [&](std::size_t k) { return std::pow(rgb[i + k] / 255.0, 2.2); };
            sum += 0.2126 * linear(0) + 0.7152 * linear(1) + 0.0722 * linear(2);
        }
        return sum / (static_cast<double>(rgb.size()) / 3.0);
    };
    const double apple = luminance(make_apple());
    const double melon = luminance(make_watermelon());
    const double banana = luminance(make_banana());
    CAPTURE(apple, melon, banana);
    CHECK(melon > 1.3 * apple);
    CHECK(banana > 1.3 * melon);
}
