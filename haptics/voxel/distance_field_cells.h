// Cells, corners and values between them, for FULCRUM_KERNEL_LANES points at once, in the namespace FULCRUM_KERNEL: what the kernels
// of distance_field_batch.h and the balls of ball_slack.h share. Included by each source that holds a version of them, once, after all
// other headers: compiler switches of that version are on here.
//
// Thread: any. Cost: see distance_field_batch.h.

// NOLINTBEGIN(misc-definitions-in-headers,cppcoreguidelines-pro-type-member-init): each version is a set of functions of its
// own; vectors are written before they are read, and clearing them costs
namespace fulcrum::FULCRUM_KERNEL {
namespace {

constexpr std::size_t kWidth = FULCRUM_KERNEL_LANES;
using Floats = float __attribute__((vector_size(4 * FULCRUM_KERNEL_LANES)));
using Ints = std::int32_t __attribute__((vector_size(4 * FULCRUM_KERNEL_LANES)));

constexpr std::int32_t kCellBits = kBrickCells - 1;
constexpr std::size_t kLayer = 9UL * 9;  // corners of a brick
constexpr std::size_t kBrickValues = sizeof(DistanceField::Brick) / sizeof(std::int16_t);

inline void load(const float* from, Floats& to) noexcept {
    __builtin_memcpy(&to, from, sizeof to);
}
inline void store(const Floats& from, float* to) noexcept {
    __builtin_memcpy(to, &from, sizeof from);
}

// Pairs of neighbours along x at the four edges of a cell, and the weights within it.
struct Corners {
    std::array<Floats, 4> low;   // y, z: 00 10 01 11
    std::array<Floats, 4> high;  // the neighbours
    std::array<Floats, 3> within;
};

// Cell along one axis of a place, and whether the place is outside the block.
inline void find_cell(const Floats& place, float end, Ints& cell, Floats& within,
                      Ints& outside) noexcept {
    const Floats zero{};
    Floats clamped = place > zero ? place : zero;
    clamped = clamped < end ? clamped : zero + end;
    outside |= clamped != place;
    cell = __builtin_convertvector(clamped, Ints);
    within = clamped - __builtin_convertvector(cell, Floats);
}

inline void interpolate(const Corners& c, Floats& value) noexcept {
    std::array<Floats, 4> along_x;
    for (std::size_t i = 0; i < 4; ++i) {
        along_x[i] = c.low[i] + c.within[0] * (c.high[i] - c.low[i]);
    }
    const Floats near = along_x[0] + c.within[1] * (along_x[1] - along_x[0]);
    const Floats far = along_x[2] + c.within[1] * (along_x[3] - along_x[2]);
    value = near + c.within[2] * (far - near);
}

// The same value, to the bit, and the slopes from the same eight numbers.
inline void interpolate(const Corners& c, Floats& value, std::array<Floats, 3>& slope) noexcept {
    std::array<Floats, 4> by_x;
    std::array<Floats, 4> along_x;
    for (std::size_t i = 0; i < 4; ++i) {
        by_x[i] = c.high[i] - c.low[i];
        along_x[i] = c.low[i] + c.within[0] * by_x[i];
    }
    const Floats near_by_y = along_x[1] - along_x[0];
    const Floats far_by_y = along_x[3] - along_x[2];
    const Floats near = along_x[0] + c.within[1] * near_by_y;
    const Floats far = along_x[2] + c.within[1] * far_by_y;
    value = near + c.within[2] * (far - near);
    const Floats near_by_x = by_x[0] + c.within[1] * (by_x[1] - by_x[0]);
    const Floats far_by_x = by_x[2] + c.within[1] * (by_x[3] - by_x[2]);
    slope[0] = near_by_x + c.within[2] * (far_by_x - near_by_x);
    slope[1] = near_by_y + c.within[2] * (far_by_y - near_by_y);
    slope[2] = far - near;
}

// A p, voxels along the object's axes.
inline void turn(const FieldPlace& place, const std::array<Floats, 3>& p,
                 std::array<Floats, 3>& turned) noexcept {
    for (std::size_t row = 0; row < 3; ++row) {
        turned[row] =
            place.A[3 * row] * p[0] + place.A[3 * row + 1] * p[1] + place.A[3 * row + 2] * p[2];
    }
}

}  // namespace
}  // namespace fulcrum::FULCRUM_KERNEL
// NOLINTEND(misc-definitions-in-headers,cppcoreguidelines-pro-type-member-init)
