#include "haptics/tool/implicit_penalty/field_contacts.h"

#include <algorithm>
#include <array>

namespace fulcrum {
namespace {

constexpr std::size_t kWidth = ShellTree::kWidth;

// The leaf's thinning for which all that are near fit into `room`.
std::size_t choose_thinning(const ShellTree& shell, std::span<const std::size_t> leaves,
                            std::size_t room) noexcept {
    for (std::size_t m = 0; m + 1 < shell.n_thinnings(); ++m) {
        std::size_t n = 0;
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            if (i == 0 || leaves[i] >> m != leaves[i - 1] >> m) {
                n += shell.count_in(m, leaves[i] >> m);
            }
        }
        if (n <= room) {
            return m;
        }
    }
    return shell.n_thinnings() - 1;
}

}  // namespace

void FieldContacts::find_leaves(const FieldPlace& place, double within_m) noexcept {
    const auto near_voxels = static_cast<float>(within_m / field_->frame().voxel_m);
    stack_.clear();
    leaves_.clear();
    stack_.add({shell_->n_levels() - 1, 0});
    while (stack_.count() > 0) {
        const Node node = stack_.take_last();
        std::array<float, kWidth> slacks{};
        kernels_->find_slacks(bounds_, place, shell_->level(node.level)[node.group], slacks);
        // The last on the stack is the first to be taken: leaves come in ascending order.
        for (std::size_t back = kWidth; back-- > 0;) {
            const std::size_t i = node.level > 0 ? back : kWidth - 1 - back;
            // A ball that is not there has a slack beyond all measure.
            if (slacks[i] > near_voxels) {
                continue;
            }
            const std::size_t below = kWidth * node.group + i;
            if (node.level > 0) {
                stack_.add({node.level - 1, below});
            } else if (below < shell_->n_leaves()) {
                leaves_.add(below);
            }
        }
    }
}

void FieldContacts::find(const Pose& X_OT, double within_m,
                         BoundedList<NearContact>& near) noexcept {
    const FieldPlace place(*field_, X_OT);
    find_leaves(place, within_m);
    const std::size_t m = choose_thinning(*shell_, leaves_.all(), near.capacity() - near.count());
    for (std::size_t i = 0; i < leaves_.count(); ++i) {
        if (i == 0 || leaves_[i] >> m != leaves_[i - 1] >> m) {
            add_leaf(X_OT, place, m, leaves_[i] >> m, within_m, near);
        }
    }
}

void FieldContacts::add_leaf(const Pose& X_OT, const FieldPlace& place, std::size_t thinning,
                             std::size_t leaf, double within_m,
                             BoundedList<NearContact>& near) const noexcept {
    constexpr double kFlat = 1.0e-3;  // metres a metre: a slope that tells no direction
    const double per_step = field_->step_m() / field_->frame().voxel_m;
    const ShellPoints points = shell_->points(thinning, leaf);
    alignas(64) std::array<float, kLeafPoints> values{};
    alignas(64) std::array<std::array<float, kLeafPoints>, 3> slopes{};
    const std::array<float*, 3> into{slopes[0].data(), slopes[1].data(), slopes[2].data()};
    kernels_->sample(bounds_.view, place, points, kLeafPoints, values.data(), into.data());
    const std::size_t n = shell_->count_in(thinning, leaf);
    for (std::size_t i = 0; i < n; ++i) {
        const double f_m = field_->step_m() * static_cast<double>(values[i]);
        if (!(f_m < within_m)) {
            continue;
        }
        NearContact contact;
        contact.point_T = {points.x[i], points.y[i], points.z[i]};
        contact.depth_m = -f_m;
        Vector3 out = per_step * Vector3(slopes[0][i], slopes[1][i], slopes[2][i]);
        if (f_m < -DistanceField::kDeepFrom * field_->band_m()) {
            const DepthSample deep = field_->sample_depth(X_OT * contact.point_T);
            contact.depth_m = deep.depth_m;
            out = deep.way_out;
        }
        const double steepness = out.norm();
        contact.normal_O =
            steepness > kFlat
                ? Vector3(out / steepness)
                : Vector3(X_OT.orientation *
                          Vector3(points.nx[i], points.ny[i], points.nz[i]).normalized());
        if (!near.add(contact)) {
            return;
        }
    }
}

}  // namespace fulcrum
