#!/usr/bin/env bash
# rapier_multibody_joints_have_friction.sh: @dimforge/rapier3d-compat 0.21.0 in Node.js.
#
# Guessed: a revolute joint turns without friction unless one is asked for, whether it is made by createImpulseJoint or by
# createMultibodyJoint; the second one, in reduced coordinates, keeps a pendulum's energy better.
# Seen: every turning axis of a multibody joint is braked by 0.1 N m s/rad, also where the damping of both bodies is 0. The number is
# absolute: it does not grow with mass or size. A wheel of 1.7 kg m2 hardly shows it, one of 0.017 kg m2 stands after a second. Sliding
# axes are free, and so are the same joints made by createImpulseJoint. No method of the joint names it, so a program in JavaScript can
# neither see nor change it.
# So a scene that was tuned with one kind of joint is another scene with the other one, and a joint has to be measured, unloaded,
# before what a hand feels at it is called inertia.
#
# Fails when that changes. Needs npm and node; leaves nothing behind.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --ignore-scripts --prefix . @dimforge/rapier3d-compat@0.21.0 >/dev/null 2>&1 ||
    { echo "npm could not install @dimforge/rapier3d-compat 0.21.0" >&2 && exit 1; }

cat >friction.mjs <<'JS'
import Rapier from '@dimforge/rapier3d-compat';
await Rapier.init();
console.log('Rapier', Rapier.version());
const origin = { x: 0, y: 0, z: 0 }, axis = { x: 0, y: 0, z: 1 };
const joints = {
    revolute: Rapier.JointData.revolute(origin, origin, axis),
    spherical: Rapier.JointData.spherical(origin, origin),
    prismatic: Rapier.JointData.prismatic(origin, origin, axis),
};
let good = !Object.getOwnPropertyNames(Rapier.MultibodyJoint.prototype).some((name) => /damp|frict/i.test(name));
for (const [kind, joint] of Object.entries(joints)) {
    for (const multibody of [true, false]) {
        for (const density of [10, 100, 1000]) {
            const world = new Rapier.World(origin);
            const wall = world.createRigidBody(Rapier.RigidBodyDesc.fixed());
            const body = world.createRigidBody(Rapier.RigidBodyDesc.dynamic().setCanSleep(false));
            world.createCollider(Rapier.ColliderDesc.cuboid(0.2, 0.2, 0.2).setDensity(density).setCollisionGroups(0), body);
            if (multibody) {
                world.createMultibodyJoint(joint, wall, body, true);
            } else {
                world.createImpulseJoint(joint, wall, body, true);
            }
            world.step();
            const slides = kind === 'prismatic', inertia = slides ? body.mass() : body.principalInertia().z;
            const speed = () => (slides ? body.linvel().z : body.angvel().z);
            const push = { x: 0, y: 0, z: 6 * inertia };
            slides ? body.addForce(push, true) : body.addTorque(push, true);
            for (let i = 0; i < 30; ++i) world.step();
            body.resetForces(true);
            body.resetTorques(true);
            world.step();
            const before = speed();
            for (let i = 0; i < 60; ++i) world.step();
            const friction = inertia * Math.log(before / speed());
            console.log(`${multibody ? 'multibody' : 'impulse'} ${kind}, inertia ${inertia.toFixed(3)}: from ${before.toFixed(3)} to ` +
                `${speed().toFixed(3)} in 1 s, as if braked by ${friction.toFixed(4)}; damping of the body ${body.angularDamping()}`);
            good &&= body.angularDamping() === 0 && before > 0.5;
            good &&= multibody && !slides ? Math.abs(friction - 0.1) < 0.005 : Math.abs(speed() / before - 1) < 0.001;
        }
    }
}
if (!good) {
    console.error('this is another behaviour than the one described');
    process.exit(1);
}
JS
node friction.mjs
