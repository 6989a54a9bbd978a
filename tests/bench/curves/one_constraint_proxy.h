// The simple proxy that the god-object replaces: the hand's foot on the plane touched last, then on to what the sweep there meets,
// one constraint a tick. It needs several ticks into a corner and trembles on finely divided surfaces; kept as the thing to beat.
#pragma once

#include "haptics/collision/segment_query.h"
#include "haptics/point/proxy.h"

#include <memory>

namespace fulcrum::bench {

class OneConstraintProxy final : public Proxy {
  public:
    /// One mesh that stands still at the origin.
    explicit OneConstraintProxy(std::shared_ptr<const CollisionMesh> mesh)
        : mesh_(std::move(mesh)) {}
    void reset(const Vector3& hand_W) noexcept override;
    void put_solid(std::size_t /*solid*/, const Pose& /*pose_W*/) noexcept override {}
    const ProxyContact& step(const Vector3& hand_W,
                             std::span<const Pose> solid_poses_W) noexcept override;

  private:
    void take_plane(const SegmentHit& hit) noexcept;

    std::shared_ptr<const CollisionMesh> mesh_;
    ProxyContact contact_;
    Vector3 normal_{Vector3::UnitY()};
    Vector3 point_{Vector3::Zero()};
    bool touching_ = false;
};

}  // namespace fulcrum::bench
