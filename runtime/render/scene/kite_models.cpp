#include "runtime/render/scene/kite_models.h"

#include "haptics/math/length.h"
#include "runtime/render/scene/shapes.h"
#include "runtime/render/theme.h"
#include "runtime/scene/shape_models.h"

#include <cmath>
#include <numbers>
#include <string>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kSheetCorners = 4;  // leading inner and outer, trailing inner and outer
constexpr double kSeam = 0.35;            // of a sheet's chord, where its colour changes

std::array<float, 4> paint(const Colour& colour) {
    return {to_linear(colour.r), to_linear(colour.g), to_linear(colour.b), 1.0F};
}

void add_triangle(const std::array<Vector3, 3>& corners, ModelPrimitive& primitive) {
    const Vector3 across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double least_m2 = 1.0e-9;
    if (compute_length(across) < least_m2) {
        return;
    }
    // The light shines through a cloth: seen from the front, which in flight is below, it is as bright as its back.
    const bool is_front = across.z() > 0.0;
    const Vector3 normal = (is_front ? -1.0 : 1.0) * compute_direction(across);
    for (const std::size_t i :
         is_front ? std::array<std::size_t, 3>{0, 1, 2} : std::array<std::size_t, 3>{0, 2, 1}) {
        const Vector3& corner = corners[i];
        primitive.indices.push_back(static_cast<std::uint32_t>(primitive.positions.size() / 3));
        for (int axis = 0; axis < 3; ++axis) {
            primitive.positions.push_back(static_cast<float>(corner[axis]));
            primitive.normals.push_back(static_cast<float>(normal[axis]));
        }
        primitive.uvs.insert(primitive.uvs.end(), {0.0F, 0.0F});
    }
}

void add_quad(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d,
              ModelPrimitive& primitive) {
    add_triangle({a, b, c}, primitive);
    add_triangle({a, c, d}, primitive);
}

LoadedModel make_sheets(const KiteSettings& design) {
    LoadedModel model;
    model.name = kKiteModel;
    model.primitives.resize(2);
    model.primitives[0].base_colour = paint(theme::kVermillion);
    model.primitives[1].base_colour = paint(theme::kStar);
    const Kite kite = make_kite(design);
    for (std::size_t i = 0; i + kSheetCorners <= kite.corners_B.size(); i += kSheetCorners) {
        std::array<Vector3, kSheetCorners> corner;
        for (std::size_t k = 0; k < kSheetCorners; ++k) {
            corner[k] = kite.X_KB * kite.corners_B[i + k];
        }
        const auto& [leading_in, leading_out, trailing_in, trailing_out] = corner;
        const Vector3 seam_in = leading_in + kSeam * (trailing_in - leading_in);
        const Vector3 seam_out = leading_out + kSeam * (trailing_out - leading_out);
        const std::size_t upper = i / kSheetCorners % 2;
        add_quad(leading_in, leading_out, seam_out, seam_in, model.primitives[upper]);
        add_quad(seam_in, seam_out, trailing_out, trailing_in, model.primitives[1 - upper]);
    }
    return model;
}

LoadedModel make_bar(std::string_view name, const Colour& colour) {
    LoadedModel model = make_arrow_shaft(paint(colour));
    model.name = name;
    return model;
}

// Thin at both ends.
LoadedModel make_wisp() {
    constexpr int kPieces = 16;
    std::vector<std::array<float, 2>> profile;
    for (int i = 0; i <= kPieces; ++i) {
        const float along = static_cast<float>(i) / kPieces;
        const bool is_end = i == 0 || i == kPieces;
        profile.push_back({is_end ? 0.0F : std::sin(std::numbers::pi_v<float> * along), along});
    }
    LoadedModel model = make_lathe(profile, {1.0F, 1.0F, 1.0F, 1.0F});
    model.name = kWispModel;
    return model;
}

// A spool on its side: two discs and the line between them.
LoadedModel make_reel() {
    LoadedModel model = make_lathe({{0.0F, -0.06F},
                                    {0.08F, -0.06F},
                                    {0.08F, -0.045F},
                                    {0.045F, -0.045F},
                                    {0.045F, 0.045F},
                                    {0.08F, 0.045F},
                                    {0.08F, 0.06F},
                                    {0.0F, 0.06F}},
                                   paint(theme::kVermillion));
    // Its axle towards the viewer: y becomes z.
    for (ModelPrimitive& primitive : model.primitives) {
        for (auto* values : {&primitive.positions, &primitive.normals}) {
            for (std::size_t i = 0; i + 2 < values->size(); i += 3) {
                const float y = (*values)[i + 1];
                (*values)[i + 1] = -(*values)[i + 2];
                (*values)[i + 2] = y;
            }
        }
    }
    model.name = kReelModel;
    return model;
}

}  // namespace

std::vector<LoadedModel> make_kite_models(const KiteSettings& design) {
    return {make_sheets(design), make_bar(kLineModel, theme::kUsual.soft_ink),
            make_bar(kTailModel, theme::kBlue), make_wisp(), make_reel()};
}

}  // namespace fulcrum::runtime
