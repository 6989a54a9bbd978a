// Points deeper than the band, one by one, for the kernels of distance_field_kernel.h, which includes this in each of their sources.
//
//   D = d + t K,  grad D = (1 + K dt/dd) grad d + t grad K      distance_field.h has the law; here as F = -D, in steps
//
// Thread: any. Cost: 15 ns a point.

// NOLINTBEGIN(misc-definitions-in-headers): each version is a set of functions of its own
namespace fulcrum::FULCRUM_KERNEL {
namespace {

// C of distance_field.h at a place, voxels, and its slopes.
struct CentreDepth {
    float depth = 0.0F;
    std::array<float, 3> slope{};
};

inline CentreDepth find_centre_depth(const FieldView& field,
                                     const std::array<float, 3>& place) noexcept {
    std::array<std::array<std::int32_t, 2>, 3> centres{};  // below and above, along each axis
    std::array<std::array<float, 2>, 3> weight{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float at = place[axis] / kBrickCells - 0.5F;
        const std::int32_t last = field.n_bricks[axis] - 1;
        const auto cell = static_cast<std::int32_t>(at > 0.0F ? at : 0.0F);
        const std::int32_t high = cell + 1 < last ? cell + 1 : last;
        centres[axis] = {high > 0 ? high - 1 : 0, high};
        float within = at - static_cast<float>(centres[axis][0]);
        within = within > 0.0F ? within : 0.0F;
        within = within < 1.0F ? within : 1.0F;
        weight[axis] = {1.0F - within, within};
    }
    constexpr std::array<float, 2> kBy{-1.0F / kBrickCells, 1.0F / kBrickCells};
    CentreDepth found;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const unsigned x = corner & 1U;
        const unsigned y = corner >> 1U & 1U;
        const unsigned z = corner >> 2U;
        const std::int32_t entry =
            centres[0][x] + field.row * centres[1][y] + field.layer * centres[2][z];
        const float depth = field.depths[entry];
        found.depth += depth * (weight[0][x] * weight[1][y] * weight[2][z]);
        found.slope[0] += depth * kBy[x] * (weight[1][y] * weight[2][z]);
        found.slope[1] += depth * kBy[y] * (weight[0][x] * weight[2][z]);
        found.slope[2] += depth * kBy[z] * (weight[0][x] * weight[1][y]);
    }
    return found;
}

constexpr float kDeepSteps = -static_cast<float>(DistanceField::kDeepFrom) *
                             static_cast<float>(DistanceField::kLargestValue);

// F and its slope of a point beyond 3/4 of the band become -D and its slope.
inline void deepen(const FieldView& field, const std::array<float, 3>& place, float& value,
                   std::array<float, 3>& slope) noexcept {
    constexpr auto kLargest = static_cast<float>(DistanceField::kLargestValue);
    const CentreDepth centre = find_centre_depth(field, place);
    const float more = centre.depth - field.band_voxels;
    if (!(more > 0.0F)) {
        return;
    }
    const float steps = kLargest / field.band_voxels;  // a voxel
    const float t = (value - kDeepSteps) / (-kLargest - kDeepSteps);
    const float by_value = t < 1.0F ? more * steps / (kLargest + kDeepSteps) : 0.0F;
    const float share = t < 1.0F ? t : 1.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        slope[axis] = slope[axis] * (1.0F + by_value) - share * steps * centre.slope[axis];
    }
    value -= share * steps * more;
}

constexpr std::size_t kDeepBlocks = kLeafPoints / kWidth;  // vectors in a leaf

// The few of a leaf that lie that deep, one by one.
template <bool kBySlopes>
inline void deepen_leaf(const FieldView& field, const FieldPlace& place, const ShellPoints& points,
                        std::array<Floats, kDeepBlocks>& values,
                        std::array<std::array<Floats, 3>, kDeepBlocks>& slopes) noexcept {
    for (std::size_t i = 0; i < kLeafPoints; ++i) {
        const std::size_t block = i / kWidth;
        const std::size_t lane = i % kWidth;
        float value = values[block][lane];
        if (!(value < kDeepSteps)) {
            continue;
        }
        std::array<float, 3> at{};
        std::array<float, 3> slope{};
        for (std::size_t row = 0; row < 3; ++row) {
            at[row] = place.A[3 * row] * points.x[i] + place.A[3 * row + 1] * points.y[i] +
                      place.A[3 * row + 2] * points.z[i] + place.b[row];
        }
        for (std::size_t row = 0; kBySlopes && row < 3; ++row) {
            slope[row] = slopes[block][row][lane];
        }
        deepen(field, at, value, slope);
        values[block][lane] = value;
        for (std::size_t row = 0; kBySlopes && row < 3; ++row) {
            slopes[block][row][lane] = slope[row];
        }
    }
}

}  // namespace
}  // namespace fulcrum::FULCRUM_KERNEL
// NOLINTEND(misc-definitions-in-headers)
