// CHAI3D's finger proxy on the stroked ball: as it comes, with its dynamic proxy, and with its shaded normals as well. It has no damper of
// its own in this force, and no gate: what it computes is what it sends.
#include "haptics/geometry/shape.h"
#include "haptics/surface/materials.h"
#include "tests/bench/curves/felt_sphere.h"
#include "tests/bench/harness/measure.h"
#include "tests/bench/harness/must.h"
#include "tests/bench/harness/registry.h"

#include <chai3d.h>
#include <memory>

namespace fulcrum::bench {
namespace {

chai3d::cVector3d to_chai(const Vector3& v) {
    return {v.x(), v.y(), v.z()};
}

// A world with one mesh in it, and a proxy.
class ChaiBall {
  public:
    ChaiBall(const TriangleMesh& mesh, double stiffness_N_per_m, bool dynamic, bool shaded) {
        auto* body = new chai3d::cMesh();  // the world's
        for (const Vector3& p : mesh.vertices_B()) {
            body->newVertex(to_chai(p));
        }
        for (const TriangleCorners& t : mesh.triangles()) {
            body->newTriangle(static_cast<unsigned>(t[0]), static_cast<unsigned>(t[1]),
                              static_cast<unsigned>(t[2]));
        }
        body->computeAllNormals();
        body->createAABBCollisionDetector(kProxy_m);
        body->m_material->setStiffness(stiffness_N_per_m);
        body->m_material->setStaticFriction(0.0);
        body->m_material->setDynamicFriction(0.0);
        body->m_material->setUseHapticShading(shaded);
        world_->addChild(body);
        proxy_.m_useDynamicProxy = dynamic;
        proxy_.setProxyRadius(kProxy_m);
    }
    Vector3 send(const Vector3& hand_W) {
        if (!begun_) {
            proxy_.initialize(world_.get(), to_chai(hand_W));
            begun_ = true;
        }
        const chai3d::cVector3d f = proxy_.computeForces(to_chai(hand_W), {0.0, 0.0, 0.0});
        return {f.x(), f.y(), f.z()};
    }

  private:
    static constexpr double kProxy_m = 1.0e-6;
    std::unique_ptr<chai3d::cWorld> world_ = std::make_unique<chai3d::cWorld>();
    chai3d::cAlgorithmFingerProxy proxy_;
    bool begun_ = false;
};

std::vector<CostPoint> stroke_chai(Run& run) {
    struct Mode {
        const char* name;
        bool dynamic, shaded;
    };
    const double stiffness_N_per_m = find_material("metal")->coupling.stiffness_N_per_m;
    const double depth_m = kStrokePush_N / stiffness_N_per_m;
    std::vector<CostPoint> points;
    for (const Mode& mode :
         {Mode{"CHAI3D 3.3", false, false}, Mode{"CHAI3D 3.3 shaded", false, true},
          Mode{"CHAI3D 3.3 dynamic", true, false}, Mode{"CHAI3D 3.3 dynamic shaded", true, true}}) {
        for (const int frequency : stroked_balls(run.quick())) {
            ChaiBall ball(must(make_sphere(kStrokedBall_m, frequency)), stiffness_N_per_m,
                          mode.dynamic, mode.shaded);
            const auto send = [&](const Vector3& hand_W) { return ball.send(hand_W); };
            const SentStroke sent = stroke_ball(send, depth_m);
            points.push_back(to_point(mode.name, 20.0 * frequency * frequency, sent,
                                      measure_stroke(send, depth_m)));
        }
    }
    return points;
}

const PeerRegistration kChai{{"CHAI3D 3.3", "felt-sphere", stroke_chai}};

}  // namespace
}  // namespace fulcrum::bench
