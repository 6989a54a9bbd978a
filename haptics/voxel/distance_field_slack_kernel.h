// The slacks of eight balls (ball_slack.h has the law), beside the kernels of distance_field_kernel.h, behind which each of their versions
// of eight lanes includes this.
//
// Thread: any. Cost: see ball_slack.h.

// NOLINTBEGIN(misc-definitions-in-headers,cppcoreguidelines-pro-type-member-init): each version is a set of functions of its
// own; vectors are written before they are read, and clearing them costs
namespace fulcrum::FULCRUM_KERNEL {
namespace {

constexpr float kMargin = 2.0e-3F;  // voxels: places of single precision in blocks of 2048

inline Floats larger(const Floats& a, const Floats& b) noexcept {
    return a > b ? a : b;
}

inline Floats find_roots(const Floats& squares) noexcept {
#if defined(__AVX__)
    return _mm256_sqrt_ps(squares);
#elif defined(__SSE2__)
    struct {
        __m128 low, high;
    } halves;
    __builtin_memcpy(&halves, &squares, sizeof halves);
    halves = {_mm_sqrt_ps(halves.low), _mm_sqrt_ps(halves.high)};
    Floats roots;
    __builtin_memcpy(&roots, &halves, sizeof roots);
    return roots;
#else
    Floats roots;
    for (int i = 0; i < 8; ++i) {
        roots[i] = std::sqrt(squares[i]);
    }
    return roots;
#endif
}

inline Floats find_length(const std::array<Floats, 3>& v) noexcept {
    return find_roots(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

// What the field tells at eight places.
struct Told {
    Floats value;                    // F, voxels
    Floats centre;                   // of the bricks, |d|, voxels
    std::array<Floats, 3> away;      // from those centres
    std::array<Floats, 3> overhang;  // of places outside the block
};

inline void ask(const SlackBounds& bounds, const std::array<Floats, 3>& g, Told& told) noexcept {
    const FieldView& field = bounds.view;
    Corners corners;
    std::array<Ints, 3> cell;
    Ints outside{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        find_cell(g[axis], field.end[axis], cell[axis], corners.within[axis], outside);
        const Floats nearest = __builtin_convertvector(cell[axis], Floats) + corners.within[axis];
        const Ints brick_middle = ((cell[axis] >> 3) << 3) + kBrickCells / 2;
        told.away[axis] = nearest - __builtin_convertvector(brick_middle, Floats);
        told.overhang[axis] = g[axis] - nearest;
    }
    const Ints entry = (cell[0] >> 3) + field.row * (cell[1] >> 3) + field.layer * (cell[2] >> 3);
    const Ints at =
        (cell[0] & 7) + kBrickSide * (cell[1] & 7) + kBrickSide * kBrickSide * (cell[2] & 7);
    for (int i = 0; i < 8; ++i) {
        const DistanceField::Entry& told_by = field.table[entry[i]];
        const std::int16_t* const corner =
            field.values + static_cast<std::size_t>(told_by.brick) * kBrickValues + at[i];
        told.centre[i] = std::abs(told_by.centre_voxels);
        for (std::size_t edge = 0; edge < 4; ++edge) {
            const std::size_t stride =
                (edge & 1U) * kBrickSide + (edge >> 1U) * kBrickSide * kBrickSide;
            corners.low[edge][i] = static_cast<float>(corner[stride]);
            corners.high[edge][i] = static_cast<float>(corner[stride + 1]);
        }
    }
    interpolate(corners, told.value);
    told.value *= bounds.voxels_per_step;
}

[[maybe_unused]] void find_slacks(const SlackBounds& bounds, const FieldPlace& place,
                                  const EightBalls& balls, std::array<float, 8>& slacks) noexcept {
    std::array<Floats, 3> p;
    std::array<Floats, 3> g;
    load(balls.x.data(), p[0]);
    load(balls.y.data(), p[1]);
    load(balls.z.data(), p[2]);
    turn(place, p, g);
    std::array<Floats, 3> from_ball;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        g[axis] += place.b[axis];
        from_ball[axis] = g[axis] - bounds.ball_centre[axis];
    }
    Told told;
    ask(bounds, g, told);
    const Floats zero{};
    const Floats size = larger(told.value, -told.value);
    const Floats within =
        larger(larger(told.centre - find_length(told.away), size - bounds.error), zero);
    const Floats overhang = find_length(told.overhang);
    const Floats beyond_ball = find_length(from_ball) - bounds.ball_radius;
    Floats distance = find_roots(within * within + overhang * overhang);
    distance = overhang > zero ? larger(distance, beyond_ball) : distance;
    const Floats reach = larger(told.value * bounds.inverse_slope, distance - bounds.error);
    Floats radius;
    load(balls.radius.data(), radius);
    const Floats free = told.value > zero ? reach : told.value * bounds.inverse_slope;
    store(free - radius * bounds.voxels_per_metre - kMargin, slacks.data());
}

}  // namespace
}  // namespace fulcrum::FULCRUM_KERNEL
// NOLINTEND(misc-definitions-in-headers,cppcoreguidelines-pro-type-member-init)
