// The kernels of distance_field_batch.h for FULCRUM_KERNEL_LANES points at once, in the namespace FULCRUM_KERNEL. Included by
// each source that holds a version of them, once, after all other headers: compiler switches of that version are on here.
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

// What a leaf of points needs of the field. Filled for all of them before it is read: a vector that is read soon after its parts
// were written waits for them.
struct Gathered {
    alignas(64) std::array<std::int32_t, kLeafPoints> entries;
    alignas(64) std::array<std::int32_t, kLeafPoints> offsets;
    alignas(64) std::array<std::array<float, kLeafPoints>, 3> within;
    alignas(64) std::array<std::array<std::int32_t, kLeafPoints>, 4> pairs;
};

inline void find_cells(const FieldView& field, const std::array<Floats, 3>& place,
                       std::size_t first, Gathered& gathered) noexcept {
    std::array<Ints, 3> cell;
    Ints outside{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Floats within;
        find_cell(place[axis], field.end[axis], cell[axis], within, outside);
        store(within, gathered.within[axis].data() + first);
    }
    const Ints entry = (cell[0] >> 3) + field.row * (cell[1] >> 3) + field.layer * (cell[2] >> 3);
    const Ints at = (cell[0] & kCellBits) + kBrickSide * (cell[1] & kCellBits) +
                    kBrickSide * kBrickSide * (cell[2] & kCellBits);
    const Ints outside_entry = Ints{} + field.outside;
    const Ints safe_entry = outside ? outside_entry : entry;
    __builtin_memcpy(gathered.entries.data() + first, &safe_entry, sizeof safe_entry);
    __builtin_memcpy(gathered.offsets.data() + first, &at, sizeof at);
}

inline void gather(const FieldView& field, Gathered& gathered) noexcept {
    for (std::size_t i = 0; i < kLeafPoints; ++i) {
        const std::int32_t brick = field.table[gathered.entries[i]].brick;
        const std::int16_t* const corner =
            field.values + static_cast<std::size_t>(brick) * kBrickValues + gathered.offsets[i];
        __builtin_memcpy(&gathered.pairs[0][i], corner, 4);
        __builtin_memcpy(&gathered.pairs[1][i], corner + kBrickSide, 4);
        __builtin_memcpy(&gathered.pairs[2][i], corner + kLayer, 4);
        __builtin_memcpy(&gathered.pairs[3][i], corner + kLayer + kBrickSide, 4);
    }
}

inline void load_corners(const Gathered& gathered, std::size_t first, Corners& corners) noexcept {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        load(gathered.within[axis].data() + first, corners.within[axis]);
    }
    for (std::size_t i = 0; i < 4; ++i) {
        Ints pair;
        __builtin_memcpy(&pair, gathered.pairs[i].data() + first, sizeof pair);
        corners.low[i] = __builtin_convertvector((pair << 16) >> 16, Floats);
        corners.high[i] = __builtin_convertvector(pair >> 16, Floats);
    }
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

inline void load_turned(const FieldPlace& place, const ShellPoints& points, std::size_t first,
                        std::array<Floats, 3>& p, std::array<Floats, 3>& arm,
                        std::array<Floats, 3>& g) noexcept {
    load(points.x + first, p[0]);
    load(points.y + first, p[1]);
    load(points.z + first, p[2]);
    turn(place, p, arm);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        g[axis] = arm[axis] + place.b[axis];
    }
}

// d (x, y, z) and arm x d (x, y, z) to the lanes.
inline void add_contacts(const Floats& depth, const std::array<Floats, 3>& arm,
                         const std::array<Floats, 3>& along, std::size_t lane,
                         ContactLanes& lanes) noexcept {
    std::array<Floats, 3> push;
    for (std::size_t i = 0; i < 3; ++i) {
        push[i] = depth * along[i];
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        Floats sum;
        load(lanes.force[i].data() + lane, sum);
        store(sum + push[i], lanes.force[i].data() + lane);
        load(lanes.torque[i].data() + lane, sum);
        store(sum + (arm[j] * push[k] - arm[k] * push[j]), lanes.torque[i].data() + lane);
    }
    Ints count;
    __builtin_memcpy(&count, lanes.count.data() + lane, sizeof count);
    count -= depth > 0.0F;
    __builtin_memcpy(lanes.count.data() + lane, &count, sizeof count);
}

inline float find_least(const Floats& a) noexcept {
    alignas(64) std::array<float, kWidth> each;
    store(a, each.data());
    using Four = float __attribute__((vector_size(16)));
    Four least;
    __builtin_memcpy(&least, each.data(), sizeof least);
    for (std::size_t i = 4; i < kWidth; i += 4) {
        Four next;
        __builtin_memcpy(&next, each.data() + i, sizeof next);
        least = next < least ? next : least;
    }
    const float first = least[0] < least[1] ? least[0] : least[1];
    const float second = least[2] < least[3] ? least[2] : least[3];
    return first < second ? first : second;
}

constexpr std::size_t kBlocks = kLeafPoints / kWidth;  // vectors in a leaf

inline void gather_leaf(const FieldView& field, const FieldPlace& place, const ShellPoints& points,
                        Gathered& gathered) noexcept {
    for (std::size_t first = 0; first < kLeafPoints; first += kWidth) {
        std::array<Floats, 3> p;
        std::array<Floats, 3> arm;
        std::array<Floats, 3> g;
        load_turned(place, points, first, p, arm, g);
        find_cells(field, g, first, gathered);
    }
    gather(field, gathered);
}

void sample_leaf(const FieldView& field, const FieldPlace& place, const ShellPoints& points,
                 float* values, const std::array<float*, 3>* slopes) noexcept {
    Gathered gathered;
    gather_leaf(field, place, points, gathered);
    for (std::size_t first = 0; first < kLeafPoints; first += kWidth) {
        Corners corners;
        load_corners(gathered, first, corners);
        Floats value;
        if (slopes == nullptr) {
            interpolate(corners, value);
        } else {
            std::array<Floats, 3> slope;
            interpolate(corners, value, slope);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                store(slope[axis], (*slopes)[axis] + first);
            }
        }
        store(value, values + first);
    }
}

[[maybe_unused]] void sample(const FieldView& field, const FieldPlace& place,
                             const ShellPoints& points, std::size_t n, float* values,
                             float* const* slopes) noexcept {
    const std::size_t n_whole = n / kLeafPoints * kLeafPoints;
    for (std::size_t first = 0; first < n_whole; first += kLeafPoints) {
        if (slopes == nullptr) {
            sample_leaf(field, place, points.from(first), values + first, nullptr);
        } else {
            const std::array<float*, 3> to{slopes[0] + first, slopes[1] + first, slopes[2] + first};
            sample_leaf(field, place, points.from(first), values + first, &to);
        }
    }
    if (n_whole == n) {
        return;
    }
    // What is left is done in a leaf of its own.
    std::array<std::array<float, kLeafPoints>, 7> leaf{};
    for (std::size_t i = n_whole; i < n; ++i) {
        leaf[0][i - n_whole] = points.x[i];
        leaf[1][i - n_whole] = points.y[i];
        leaf[2][i - n_whole] = points.z[i];
    }
    const std::array<float*, 3> to{leaf[4].data(), leaf[5].data(), leaf[6].data()};
    sample_leaf(field, place,
                {leaf[0].data(), leaf[1].data(), leaf[2].data(), nullptr, nullptr, nullptr},
                leaf[3].data(), slopes == nullptr ? nullptr : &to);
    for (std::size_t i = n_whole; i < n; ++i) {
        values[i] = leaf[3][i - n_whole];
        for (std::size_t axis = 0; slopes != nullptr && axis < 3; ++axis) {
            slopes[axis][i] = to[axis][i - n_whole];
        }
    }
}

// The contacts of one vector of points, at `first` of a leaf.
inline void add_block(const FieldPlace& place, const ShellPoints& points, std::size_t first,
                      bool by_slopes, const Floats& value, const std::array<Floats, 3>& slope,
                      ContactLanes& lanes) noexcept {
    const Floats zero{};
    const Floats depth = value < zero ? -value : zero;
    std::array<Floats, 3> p;
    load(points.x + first, p[0]);
    load(points.y + first, p[1]);
    load(points.z + first, p[2]);
    const std::size_t lane = first % ContactLanes::kLanes;
    if (by_slopes) {
        std::array<Floats, 3> arm;
        turn(place, p, arm);
        add_contacts(depth, arm, slope, lane, lanes);
    } else {
        std::array<Floats, 3> normal;
        load(points.nx + first, normal[0]);
        load(points.ny + first, normal[1]);
        load(points.nz + first, normal[2]);
        add_contacts(depth, p, normal, lane, lanes);
    }
}

template <bool kBySlopes>
float sum_leaf_along(const FieldView& field, const FieldPlace& place, const ShellPoints& points,
                     std::size_t n, ContactLanes& lanes) noexcept {
    Gathered gathered;
    gather_leaf(field, place, points, gathered);
    std::array<Floats, kBlocks> values;
    std::array<std::array<Floats, 3>, kBlocks> slopes;
    for (std::size_t block = 0; block < kBlocks; ++block) {
        Corners corners;
        load_corners(gathered, block * kWidth, corners);
        if constexpr (kBySlopes) {
            interpolate(corners, values[block], slopes[block]);
        } else {
            interpolate(corners, values[block]);
        }
    }
    for (std::size_t i = n; i < kLeafPoints; ++i) {
        values[i / kWidth][i % kWidth] = static_cast<float>(DistanceField::kLargestValue);
    }
    Floats least_each = values[0];
    for (std::size_t block = 1; block < kBlocks; ++block) {
        least_each = values[block] < least_each ? values[block] : least_each;
    }
    const float least = find_least(least_each);
    if (least < 0.0F) {
        for (std::size_t block = 0; block < kBlocks; ++block) {
            add_block(place, points, block * kWidth, kBySlopes, values[block], slopes[block],
                      lanes);
        }
    }
    return least;
}

[[maybe_unused]] float sum_leaf(const FieldView& field, const FieldPlace& place,
                                const ShellPoints& points, std::size_t n, ForceAlong along,
                                ContactLanes& lanes) noexcept {
    return along == ForceAlong::slopes ? sum_leaf_along<true>(field, place, points, n, lanes)
                                       : sum_leaf_along<false>(field, place, points, n, lanes);
}

}  // namespace
}  // namespace fulcrum::FULCRUM_KERNEL
// NOLINTEND(misc-definitions-in-headers,cppcoreguidelines-pro-type-member-init)
