// How the force of points along slopes changes with the tool's pose, beside the kernels of distance_field_kernel.h, behind which each of
// their sources includes this.
//
// With a the arm A p, g = grad F, D = -F, B the mixed second derivatives of F within a cell, all in steps and voxels:
//   S = -(g g^T - D B)     the force's change by the place; symmetric
//   T = -S [a]             by turning, row by row a x S_i
//   [a] T                  the torque's change by turning for as long as the force is the same; symmetric
//   a f^T                  f = D g: what the arm's own change adds to that, less (f . a) I
// Points beyond 3/4 of the band follow another law (distance_field_deep_kernel.h): they are told, not summed.
//
// Thread: any. Cost: a leaf 0.1 us.

// NOLINTBEGIN(misc-definitions-in-headers,cppcoreguidelines-pro-type-member-init): each version is a set of functions of its
// own; vectors are written before they are read, and clearing them costs
namespace fulcrum::FULCRUM_KERNEL {
namespace {

using Three = std::array<Floats, 3>;

// The mixed derivatives by y and z, by x and z, by x and y.
inline void find_bend(const Corners& c, Three& bend) noexcept {
    std::array<Floats, 4> by_x;
    std::array<Floats, 4> along_x;
    for (std::size_t i = 0; i < 4; ++i) {
        by_x[i] = c.high[i] - c.low[i];
        along_x[i] = c.low[i] + c.within[0] * by_x[i];
    }
    const Floats near_by_xy = by_x[1] - by_x[0];
    const Floats far_by_xy = by_x[3] - by_x[2];
    const Floats near_by_x = by_x[0] + c.within[1] * near_by_xy;
    const Floats far_by_x = by_x[2] + c.within[1] * far_by_xy;
    bend[0] = (along_x[3] - along_x[2]) - (along_x[1] - along_x[0]);
    bend[1] = far_by_x - near_by_x;
    bend[2] = near_by_xy + c.within[2] * (far_by_xy - near_by_xy);
}

inline void add_to_lane(const Floats& more, std::array<float, ContactLanes::kLanes>& lanes,
                        std::size_t lane) noexcept {
    Floats sum;
    load(lanes.data() + lane, sum);
    store(sum + more, lanes.data() + lane);
}

inline void cross(const Three& a, const Three& b, Three& product) noexcept {
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        product[i] = a[j] * b[k] - a[k] * b[j];
    }
}

// Points with `depth` 0 add nothing, their slope and bend being 0 as well.
inline void add_slopes(const Floats& depth, const Three& slope, const Three& bend, const Three& arm,
                       std::size_t lane, SlopeLanes& lanes) noexcept {
    std::array<Three, 3> by_place;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        by_place[i][i] = -(slope[i] * slope[i]);
        by_place[j][k] = depth * bend[i] - slope[j] * slope[k];
        by_place[k][j] = by_place[j][k];
        add_to_lane(by_place[i][i], lanes.place[i], lane);
        add_to_lane(by_place[j][k], lanes.place[3 + i], lane);
    }
    std::array<Three, 3> by_turn;
    for (std::size_t i = 0; i < 3; ++i) {
        cross(arm, by_place[i], by_turn[i]);
        const Floats force = depth * slope[i];
        for (std::size_t j = 0; j < 3; ++j) {
            add_to_lane(by_turn[i][j], lanes.turn[3 * i + j], lane);
            add_to_lane(arm[j] * force, lanes.arm_force[3 * j + i], lane);
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        // Rows i and j of [a] T in column i.
        add_to_lane(arm[j] * by_turn[k][i] - arm[k] * by_turn[j][i], lanes.torque[i], lane);
        add_to_lane(arm[k] * by_turn[i][i] - arm[i] * by_turn[k][i], lanes.torque[3 + k], lane);
    }
}

// The points of one vector; a bit for each that is too deep.
inline std::uint32_t sum_block_slopes(const FieldPlace& place, const ShellPoints& points,
                                      const Corners& corners, std::size_t first, std::size_t n,
                                      SlopeLanes& lanes) noexcept {
    Floats value;
    Three slope;
    Three bend;
    interpolate(corners, value, slope);
    find_bend(corners, bend);
    for (std::size_t i = first > n ? first : n; i < first + kWidth; ++i) {
        value[i - first] = 0.0F;  // behind the last
    }
    std::uint32_t deep = 0;
    const Floats zero{};
    const Floats deepest = zero + kDeepSteps;
    const Ints is_deep = value < deepest;
    for (std::size_t i = 0; i < kWidth; ++i) {
        deep |= is_deep[i] != 0 ? 1U << i : 0U;
    }
    const Ints counts = (value < zero) & ~is_deep;
    const Floats depth = counts ? -value : zero;
    Three p;
    load(points.x + first, p[0]);
    load(points.y + first, p[1]);
    load(points.z + first, p[2]);
    Three arm;
    turn(place, p, arm);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        slope[axis] = counts ? slope[axis] : zero;
        bend[axis] = counts ? bend[axis] : zero;
    }
    add_slopes(depth, slope, bend, arm, first % ContactLanes::kLanes, lanes);
    return deep;
}

[[maybe_unused]] std::uint32_t sum_slopes(const FieldView& field, const FieldPlace& place,
                                          const ShellPoints& leaf, std::size_t n,
                                          SlopeLanes& lanes) noexcept {
    Gathered gathered;
    find_leaf(field, place, leaf, gathered);
    gather(field, gathered);
    std::uint32_t deep = 0;
    for (std::size_t first = 0; first < kLeafPoints; first += kWidth) {
        Corners corners;
        load_corners(gathered, first, corners);
        deep |= sum_block_slopes(place, leaf, corners, first, n, lanes) << first;
    }
    return deep;
}

}  // namespace
}  // namespace fulcrum::FULCRUM_KERNEL
// NOLINTEND(misc-definitions-in-headers,cppcoreguidelines-pro-type-member-init)
