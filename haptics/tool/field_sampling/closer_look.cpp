#include "haptics/tool/field_sampling/closer_look.h"

#include "haptics/math/length.h"
#include "haptics/tool/field_sampling/rank_cut.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

namespace {

constexpr float kNearest = 0.999F * RankCut::kFirst;
constexpr float kLeastNear_voxels = 0.01F;

// Of what is free by F where others are as deep as `near`, the same unit.
float rank_free(float F, float near) noexcept {
    return kNearest * near / (near + F);
}

}  // namespace

// What touches of the units first, then what is nearest to it; those that were due were looked at in this step. The highest rank.
float CloserLook::rank_units(TimedLook& in, const SampleUnits& units) noexcept {
    // What was not looked at is that free at least, and more as a rule.
    constexpr float kMore_voxels = 0.5F;
    const FreeLeaves known = in.known(in.sums().thinning());
    const float near =
        std::max(-in.sums().least_steps() * in.at().pair.bounds.voxels_per_step, kLeastNear_voxels);
    const std::int32_t* looked = units.due().begin();
    float highest = 0.0F;
    for (std::size_t i = 0; i < units.all().size(); ++i) {
        const std::int32_t unit = units.all().begin()[i];
        const bool is_new = looked != units.due().end() && *looked == unit;
        looked += is_new ? 1 : 0;
        const float least = known.find_slack(static_cast<std::size_t>(unit));
        const float free = least + (is_new ? 0.0F : kMore_voxels);
        ranks_[i] = least < -MotionClock::kMargin_voxels ? RankCut::kFirst
                                                         : rank_free(std::max(free, 0.0F), near);
        highest = std::max(highest, ranks_[i]);
    }
    return highest;
}

// As many of the units as there is room for.
void CloserLook::choose_units(const SampleUnits& units, std::size_t room) noexcept {
    RankCut cut({ranks_.data(), units.all().size()}, room);
    units_.copy(units.all());
    units_.keep_if([&](std::size_t i) { return cut.takes(ranks_[i]); });
}

// F of each sample of the units chosen.
void CloserLook::see_units(TimedLook& in) noexcept {
    const SampledPair& pair = in.at().pair;
    seen_.clear();
    for (const std::int32_t unit : units_) {
        pair.kernels->sample(
            pair.bounds.view, in.at().place,
            pair.shell->points(in.sums().thinning(), static_cast<std::size_t>(unit)), kLeafPoints,
            seen_.add_unit(), nullptr);
    }
    in.time().work().n_leaves += static_cast<std::int64_t>(units_.size());
}

// The least thinning whose parts there is room for; what touches beyond their rim is missed. None: the units' own.
CloserLook::Finer CloserLook::choose_finer(TimedLook& in, std::size_t n_touched_last) noexcept {
    constexpr double kRim = 4.0;  // times the root of the samples that touch: what surrounds a disc
    const std::size_t room = in.time().find_room(1.0);
    const std::size_t thinning = in.sums().thinning();
    for (std::size_t finer = 0; finer < thinning; ++finer) {
        seen_.split(std::size_t{1} << (thinning - finer));
        const auto n_seen = static_cast<double>(seen_.count_touching());
        const auto n_wanted =
            static_cast<std::size_t>(static_cast<double>(seen_.n_parts_a_sample()) *
                                     (2.0 * n_seen + kRim * std::sqrt(n_seen)));
        if (n_wanted + (finer == 0 ? n_touched_last : 0) < room) {
            return {finer, n_wanted};
        }
    }
    return {thinning, 0};
}

// Of the units' parts, those that touch by their samples first, then those that are nearest to it: as many as are wanted, and what more
// there may be time for.
void CloserLook::list_parts(TimedLook& in, const Finer& finer) noexcept {
    const SlackBounds& bounds = in.at().pair.bounds;
    const FreeLeaves known = in.known(finer.thinning);
    const std::size_t n_parts = std::size_t{1} << (in.sums().thinning() - finer.thinning);
    const float near =
        std::max(-in.sums().least_steps(), kLeastNear_voxels / bounds.voxels_per_step);
    // Those that are not known to be free by their own points.
    const auto visit = [&](auto&& use) {
        for (std::size_t i = 0; i < units_.size(); ++i) {
            const std::size_t first = units_[i] * n_parts;
            const std::size_t end = std::min(first + n_parts, in.shell().n_leaves(finer.thinning));
            for (std::size_t part = first; part < end; ++part) {
                if (known.may_touch(part)) {
                    use(part, seen_.least(i, part - first));
                }
            }
        }
    };
    std::size_t n = 0;
    visit([&](std::size_t, float F) {
        ranks_[n++] = F < 0.0F ? RankCut::kFirst : rank_free(F, near);
    });
    RankCut wanted({ranks_.data(), n}, finer.n_wanted);
    RankCut more({ranks_.data(), n}, std::max(finer.n_wanted, in.time().find_room(1.0)));
    n = 0;
    parts_.clear();
    more_.clear();
    visit([&](std::size_t part, float) {
        const float rank = ranks_[n++];
        const bool is_wanted = wanted.takes(rank);
        if (more.takes(rank)) {
            (is_wanted ? parts_ : more_).add(static_cast<std::int32_t>(part));
        }
    });
}

// What touched in the last step as well, whether or not samples tell of it.
void CloserLook::add_touched(const NodeList& touched_last) noexcept {
    scratch_.unite(parts_, touched_last);
    parts_.copy(scratch_);
    scratch_.subtract(more_, parts_);
    more_.copy(scratch_);
}

// Whether there was time for all that are wanted.
bool CloserLook::take_parts(TimedLook& in) noexcept {
    const bool is_whole = in.take(parts_.all()) == parts_.size();
    if (is_whole) {
        more_.shorten(in.take(more_.all()));
    }
    in.sums().settle(in.at());
    in.error().set_cut_short(false);
    return is_whole;
}

bool CloserLook::look(TimedLook& in, const SampleUnits& units,
                      const NodeList& touched_last) noexcept {
    constexpr std::size_t kUnits = 4;  // for one that touches
    constexpr double kSee = 0.5;       // of the time
    LeafSums& sums = in.sums();
    if (rank_units(in, units) < rank_free(kLeastNear_voxels, kLeastNear_voxels)) {
        return false;
    }
    choose_units(units, std::min(kUnits * (sums.touched().size() + 2), in.time().find_room(kSee)));
    see_units(in);
    const std::size_t thinning = sums.thinning();
    const Finer finer = choose_finer(in, touched_last.size());
    const bool is_enough = finer.thinning == 0 ||
                           (sums.sums().n_touching << (thinning - finer.thinning)) >= kEnoughTouch;
    if (finer.thinning == thinning || !is_enough) {
        return false;
    }
    list_parts(in, finer);
    if (finer.thinning == 0) {
        add_touched(touched_last);
    }
    const LeafSums::Total first = sums.total();
    const auto first_weight = static_cast<double>(sums.weight());
    sums.begin_anew(finer.thinning);
    if (!take_parts(in)) {
        // Where the clock cuts this short, what was seen first stands.
        sums.go_back(first);
        return false;
    }
    sums.forget_before(first);
    scratch_.unite(parts_, more_);
    const auto weight = static_cast<double>(sums.weight());
    SampleMiss miss = in.error().miss();
    miss.force_m =
        compute_length(Vector3(first_weight * first.sums.force - weight * sums.sums().force));
    miss.torque_m2 =
        compute_length(Vector3(first_weight * first.sums.torque - weight * sums.sums().torque));
    in.error().set_miss(miss);
    return true;
}

}  // namespace fulcrum
