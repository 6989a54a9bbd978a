// The kernels of distance_field_batch.h for FULCRUM_KERNEL_LANES points at once, in the namespace FULCRUM_KERNEL. Included by
// each source that holds a version of them, once, after all other headers: compiler switches of that version are on here.
//
// Thread: any. Cost: see distance_field_batch.h.
#include "haptics/voxel/distance_field_cells.h"
#include "haptics/voxel/distance_field_deep_kernel.h"

// NOLINTBEGIN(misc-definitions-in-headers,cppcoreguidelines-pro-type-member-init): each version is a set of functions of its
// own; vectors are written before they are read, and clearing them costs
namespace fulcrum::FULCRUM_KERNEL {
namespace {

// What a leaf of points needs of the field. Filled for all of them before it is read: a vector that is read soon after its parts
// were written waits for them.
struct Gathered {
    alignas(64) std::array<std::int32_t, kLeafPoints> entries;
    alignas(64) std::array<std::int32_t, kLeafPoints> offsets;
    alignas(64) std::array<std::array<float, kLeafPoints>, 3> within;
#if FULCRUM_KERNEL_LANES == 16
    // The four pairs of a point side by side; point 4 j + i of a vector in slot 4 i + j.
    alignas(64) std::array<std::array<std::int32_t, 4>, kLeafPoints> pairs;
#else
    alignas(64) std::array<std::array<std::int32_t, kLeafPoints>, 4> pairs;
#endif
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

inline void split_pairs(const Ints& pairs, std::size_t edge, Corners& corners) noexcept {
    corners.low[edge] = __builtin_convertvector((pairs << 16) >> 16, Floats);
    corners.high[edge] = __builtin_convertvector(pairs >> 16, Floats);
}

#if FULCRUM_KERNEL_LANES == 16

// A row and the next lie within 32 bytes: two loads hold all eight corners. The last cell's reach the brick's last values but two.
static_assert(637 + kLayer + 16 <= kBrickValues);
inline void gather(const FieldView& field, Gathered& gathered) noexcept {
    const __m256i picks = _mm256_setr_epi16(0, 1, 9, 10, 16, 17, 25, 26, 0, 0, 0, 0, 0, 0, 0, 0);
    const DistanceField::Entry* const table = field.table;
    const std::int16_t* const values = field.values;
#pragma GCC unroll 32
    for (std::size_t i = 0; i < kLeafPoints; ++i) {
        const std::int16_t* const corner =
            values + static_cast<std::size_t>(table[gathered.entries[i]].brick) * kBrickValues +
            gathered.offsets[i];
        __m256i near;
        __m256i far;
        __builtin_memcpy(&near, corner, sizeof near);
        __builtin_memcpy(&far, corner + kLayer, sizeof far);
        const __m128i all = _mm256_castsi256_si128(_mm256_permutex2var_epi16(near, picks, far));
        const std::size_t slot = (i & 16U) + 4 * (i & 3U) + ((i >> 2U) & 3U);
        __builtin_memcpy(gathered.pairs[slot].data(), &all, sizeof all);
    }
}

// Out of each quarter of two vectors the four numbers of these places in the first quarter; from 16 on those of the second vector.
template <int kA, int kB, int kC, int kD>
inline Ints pick_quarters(const Ints& a, const Ints& b) noexcept {
    return __builtin_shufflevector(a, b, kA, kB, kC, kD, kA + 4, kB + 4, kC + 4, kD + 4, kA + 8,
                                   kB + 8, kC + 8, kD + 8, kA + 12, kB + 12, kC + 12, kD + 12);
}

// Sixteen points' pairs from their slots: a matrix of 4 x 4 turned in each part of a vector.
inline void load_pairs(const Gathered& gathered, std::size_t first, Corners& corners) noexcept {
    std::array<Ints, 4> slots;
    __builtin_memcpy(&slots, gathered.pairs[first].data(), sizeof slots);
    const Ints near_01 = pick_quarters<0, 16, 1, 17>(slots[0], slots[1]);
    const Ints near_23 = pick_quarters<0, 16, 1, 17>(slots[2], slots[3]);
    const Ints far_01 = pick_quarters<2, 18, 3, 19>(slots[0], slots[1]);
    const Ints far_23 = pick_quarters<2, 18, 3, 19>(slots[2], slots[3]);
    const std::array<Ints, 4> pairs{pick_quarters<0, 1, 16, 17>(near_01, near_23),
                                    pick_quarters<2, 3, 18, 19>(near_01, near_23),
                                    pick_quarters<0, 1, 16, 17>(far_01, far_23),
                                    pick_quarters<2, 3, 18, 19>(far_01, far_23)};
    for (std::size_t edge = 0; edge < 4; ++edge) {
        split_pairs(pairs[edge], edge, corners);
    }
}

#else

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

inline void load_pairs(const Gathered& gathered, std::size_t first, Corners& corners) noexcept {
    for (std::size_t edge = 0; edge < 4; ++edge) {
        Ints pairs;
        __builtin_memcpy(&pairs, gathered.pairs[edge].data() + first, sizeof pairs);
        split_pairs(pairs, edge, corners);
    }
}

#endif

inline void load_corners(const Gathered& gathered, std::size_t first, Corners& corners) noexcept {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        load(gathered.within[axis].data() + first, corners.within[axis]);
    }
    load_pairs(gathered, first, corners);
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

inline void find_leaf(const FieldView& field, const FieldPlace& place, const ShellPoints& points,
                      Gathered& gathered) noexcept {
    for (std::size_t first = 0; first < kLeafPoints; first += kWidth) {
        std::array<Floats, 3> p;
        std::array<Floats, 3> arm;
        std::array<Floats, 3> g;
        load_turned(place, points, first, p, arm, g);
        find_cells(field, g, first, gathered);
    }
}

[[gnu::always_inline]] inline void sample_leaf(const FieldView& field, const FieldPlace& place,
                                               const ShellPoints& points, float* values,
                                               const std::array<float*, 3>* slopes) noexcept {
    Gathered gathered;
    find_leaf(field, place, points, gathered);
    gather(field, gathered);
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

inline float find_least(const std::array<Floats, kBlocks>& values) noexcept {
    Floats least_each = values[0];
    for (std::size_t block = 1; block < kBlocks; ++block) {
        least_each = values[block] < least_each ? values[block] : least_each;
    }
    return find_least(least_each);
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

// The contacts of a leaf whose corners are gathered; its least F, or minus its largest D.
template <bool kBySlopes>
float add_leaf(const FieldView& field, const Gathered& gathered, const FieldPlace& place,
               const ShellPoints& points, std::size_t n, ContactLanes& lanes) noexcept {
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
    float least = find_least(values);
    if (least < kDeepSteps) {
        deepen_leaf<kBySlopes>(field, place, points, values, slopes);
        least = find_least(values);
    }
    if (least < 0.0F) {
        for (std::size_t block = 0; block < kBlocks; ++block) {
            add_block(place, points, block * kWidth, kBySlopes, values[block], slopes[block],
                      lanes);
        }
    }
    return least;
}

// Asks for the corners' memory: a row and the next are near each other, the layer above is not.
inline void prefetch_corners(const FieldView& field, const Gathered& gathered) noexcept {
    for (std::size_t i = 0; i < kLeafPoints; ++i) {
        const std::int32_t brick = field.table[gathered.entries[i]].brick;
        const std::int16_t* const corner =
            field.values + static_cast<std::size_t>(brick) * kBrickValues + gathered.offsets[i];
        __builtin_prefetch(corner);
        __builtin_prefetch(corner + kLayer);
    }
}

template <bool kBySlopes>
std::size_t sum_leaves_along(const FieldView& field, const FieldPlace& place, const LeafRun& run,
                             ContactLanes& lanes, float* least) noexcept {
    // Memory far from the processor is waited for while other leaves are summed.
    constexpr std::size_t kAhead = 2;
    constexpr std::size_t kPointsAhead = 8;
    std::array<Gathered, kAhead + 1> gathered;
    const auto find = [&](std::size_t leaf) {
        if (leaf < run.n) {
            Gathered& to = gathered[leaf % gathered.size()];
            find_leaf(field, place, run.leaves[leaf], to);
            prefetch_corners(field, to);
        }
    };
    for (std::size_t leaf = 0; leaf < kAhead; ++leaf) {
        find(leaf);
    }
    std::size_t n_touching = 0;
    for (std::size_t leaf = 0; leaf < run.n; ++leaf) {
        if (leaf + kPointsAhead < run.n) {
            prefetch(run.leaves[leaf + kPointsAhead].x, 3 * kLeafPoints * sizeof(float));
        }
        find(leaf + kAhead);
        Gathered& here = gathered[leaf % gathered.size()];
        gather(field, here);
        const std::size_t n_points = leaf + 1 == run.n ? run.n_in_last : kLeafPoints;
        least[leaf] = add_leaf<kBySlopes>(field, here, place, run.leaves[leaf], n_points, lanes);
        n_touching += least[leaf] < 0.0F ? 1 : 0;
        if (n_touching == run.most_touching) {
            return leaf + 1;
        }
    }
    return run.n;
}

[[maybe_unused]] std::size_t sum_leaves(const FieldView& field, const FieldPlace& place,
                                        const LeafRun& run, ForceAlong along, ContactLanes& lanes,
                                        float* least) noexcept {
    return along == ForceAlong::slopes ? sum_leaves_along<true>(field, place, run, lanes, least)
                                       : sum_leaves_along<false>(field, place, run, lanes, least);
}

[[maybe_unused]] std::size_t collect(const float* values, std::size_t n_values,
                                     std::int32_t* hits) noexcept {
    std::size_t n = 0;
    std::size_t i = 0;
#if FULCRUM_KERNEL_LANES == 16
    __m512i numbers = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    for (; i + kWidth <= n_values; i += kWidth) {
        const __mmask16 below =
            _mm512_cmp_ps_mask(_mm512_loadu_ps(values + i), _mm512_setzero_ps(), _CMP_LT_OQ);
        // No more than `i` are written before, so sixteen fit.
        _mm512_storeu_si512(hits + n, _mm512_maskz_compress_epi32(below, numbers));
        n += static_cast<std::size_t>(__builtin_popcount(below));
        numbers = _mm512_add_epi32(numbers, _mm512_set1_epi32(kWidth));
    }
#endif
    for (; i < n_values; ++i) {
        hits[n] = static_cast<std::int32_t>(i);
        n += values[i] < 0.0F ? 1 : 0;
    }
    return n;
}

}  // namespace
}  // namespace fulcrum::FULCRUM_KERNEL
// NOLINTEND(misc-definitions-in-headers,cppcoreguidelines-pro-type-member-init)
