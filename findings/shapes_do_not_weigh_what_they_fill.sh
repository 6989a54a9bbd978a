#!/usr/bin/env bash
# shapes_do_not_weigh_what_they_fill.sh: jolt-physics 1.1.0 and @dimforge/rapier3d-compat 0.21.0 in Node.js.
#
# Guessed: a shape's mass is its density times the room that it takes in collisions, for Jolt's tapered capsule within 1 %; the border
# that rounds a Rapier cuboid has the density of the rest.
# Seen: Jolt's boxes, capsules, cylinders and tapered cylinders are right to five digits, but a tapered capsule is taken for a box: with
# radii of 0.3 and 0.301 m it weighs 42 % more than the capsule of radius 0.3 m, and its moment across is 74 % larger. In Rapier the
# border weighs nothing: a round cuboid of half sizes 0.3, 0.4, 0.5 m with a border of 0.1 m has 51 % of the mass that its room has.
# So two bodies that look and collide alike are lifted differently, and a shape that is chosen because it rolls or slides better changes
# the weight in the hand: give such shapes their mass and inertia.
#
# Fails when that changes. Needs npm and node; leaves nothing behind.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --ignore-scripts --prefix . @dimforge/rapier3d-compat@0.21.0 jolt-physics@1.1.0 >/dev/null 2>&1 ||
    { echo "npm could not install the two engines" >&2 && exit 1; }

cat >weights.mjs <<'JS'
import Rapier from '@dimforge/rapier3d-compat';
import loadJolt from 'jolt-physics';
let good = true;
function say(what, mass, room, low, high) {
    console.log(`${what}: mass / (density room) = ${(mass / room).toFixed(4)}`);
    good &&= mass / room > low && mass / room < high;
}

const Jolt = await loadJolt(), r = 0.3, half = 0.7, density = 1000;
const made = (settings) => settings.Create().Get();
const mass = (shape) => shape.GetMassProperties().mMass;
const across = (shape) => shape.GetMassProperties().mInertia.GetColumn3(0).GetX();
const capsule = new Jolt.CapsuleShape(half, r), tapered = made(new Jolt.TaperedCapsuleShapeSettings(half, r, r + 0.001));
const frustum = made(new Jolt.TaperedCylinderShapeSettings(half, 0.2, 0.5, 0));
say('Jolt capsule', mass(capsule), density * Math.PI * r * r * (2 * half + (4 / 3) * r), 0.999, 1.001);
say('Jolt cylinder', mass(new Jolt.CylinderShape(half, r, 0.02)), density * Math.PI * r * r * 2 * half, 0.999, 1.001);
say('Jolt tapered cylinder', mass(frustum), (density * Math.PI * 2 * half * (0.2 ** 2 + 0.2 * 0.5 + 0.5 ** 2)) / 3, 0.999, 1.001);
say('Jolt tapered capsule, radii alike to 1 mm', mass(tapered), mass(capsule), 1.3, 1.5);
say('  moment across, against the capsule', across(tapered), across(capsule), 1.5, 2);

await Rapier.init();
console.log('Rapier', Rapier.version());
// What a collider fills is counted in Rapier itself, on a grid of points.
function rapier(what, description, low, high) {
    const world = new Rapier.World({ x: 0, y: 0, z: 0 }), body = world.createRigidBody(Rapier.RigidBodyDesc.dynamic());
    const collider = world.createCollider(description.setDensity(1), body);
    world.step();
    const step = 0.02;
    let inside = 0;
    for (let x = -0.69; x < 0.7; x += step) {
        for (let y = -0.69; y < 0.7; y += step) {
            for (let z = -0.69; z < 0.7; z += step) inside += collider.containsPoint({ x, y, z }) ? 1 : 0;
        }
    }
    say(`Rapier ${what}, of ${inside} points inside`, body.mass(), inside * step ** 3, low, high);
}
rapier('cuboid', Rapier.ColliderDesc.cuboid(0.3, 0.4, 0.5), 0.97, 1.03);
rapier('round cuboid', Rapier.ColliderDesc.roundCuboid(0.3, 0.4, 0.5, 0.1), 0.49, 0.54);
rapier('round cylinder', Rapier.ColliderDesc.roundCylinder(0.4, 0.3, 0.1), 0.4, 0.7);
if (!good) {
    console.error('this is another behaviour than the one described');
    process.exit(1);
}
JS
node weights.mjs
