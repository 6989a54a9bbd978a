#!/usr/bin/env bash
# rapier_iterations_change_free_fall.sh: @dimforge/rapier3d-compat 0.21.0 in Node.js.
#
# Guessed: numSolverIterations says how well contacts and joints are solved; a lone body that touches nothing falls the same way,
# to the bit, whatever it is. Nor does a body's setAdditionalSolverIterations change how that body falls.
# Seen: both do. An iteration is a step of its own that also applies gravity, so a body falls too far by g h T / (2 n) for n of them,
# h the time step and T the time of the fall. Of equal balls that are dropped side by side the one with 60 iterations more is 3 cm
# above the others after 10 m, and with one iteration all are 14 cm low.
# So raising the iterations of one body "to make its joints stiffer" lets it lose a race against its twin, and a test of a trajectory
# holds for one number of iterations only.
#
# Fails when that changes. Needs npm and node; leaves nothing behind.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --ignore-scripts --prefix . @dimforge/rapier3d-compat@0.21.0 >/dev/null 2>&1 ||
    { echo "npm could not install @dimforge/rapier3d-compat 0.21.0" >&2 && exit 1; }

cat >fall.mjs <<'JS'
import Rapier from '@dimforge/rapier3d-compat';
await Rapier.init();
console.log('Rapier', Rapier.version());
const g = 9.81, steps = 100, h = 1 / 60, time = steps * h, exact = 10 + 2 * time - 0.5 * g * time * time;
let good = true;
for (const iterations of [1, 4, 16]) {
    const world = new Rapier.World({ x: 0, y: -g, z: 0 });
    world.numSolverIterations = iterations;
    const balls = [0, 4, 60].map((more, i) => {
        const body = world.createRigidBody(Rapier.RigidBodyDesc.dynamic().setTranslation(50 * i, 10, 0).setLinvel(0, 2, 0)
            .setAdditionalSolverIterations(more));
        world.createCollider(Rapier.ColliderDesc.ball(0.2), body);
        return { more, body };
    });
    for (let i = 0; i < steps; ++i) world.step();
    for (const { more, body } of balls) {
        const low = exact - body.translation().y, expected = (g * h * time) / 2 / (iterations + more);
        console.log(`${iterations} iterations, ${more} more for this ball: ${(1000 * low).toFixed(1)} mm too low, ` +
            `g h T / (2 n) = ${(1000 * expected).toFixed(1)} mm`);
        good &&= Math.abs(low - expected) < 0.02 * expected + 0.0008;
    }
}
if (!good) {
    console.error('this is another behaviour than the one described');
    process.exit(1);
}
JS
node fall.mjs
