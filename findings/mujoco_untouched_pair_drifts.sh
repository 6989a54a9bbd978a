#!/usr/bin/env bash
# mujoco_untouched_pair_drifts.sh: MuJoCo 3.3.8 (npm's mujoco-js 0.0.7) in Node.js.
#
# Guessed: two bodies on a hinge that float in empty space, untouched, with no momentum and each turning the other way, stay where they
# are: an engine in joint coordinates cannot open the hinge, and a semi-implicit step of 2 ms keeps momentum like any sum of equal and
# opposite impulses. Expected over 100 s: less than 1 mm.
# Seen: with the usual integrator Euler, and implicitfast, their centre of mass has moved by 85 cm after 100 s, and 13 % of the angular
# momentum and 33 % of the energy are gone. With "implicit" it has moved by 40 cm, and momentum and energy have grown, by 33 and 113 %.
# A quarter of the step makes all of that about four times smaller. With RK4 it moves by 33 nm. In joint coordinates momentum depends on
# positions as well as on velocities: a step that takes its velocities at one position and is at another one afterwards has changed it.
# So what is thrown, jumps or floats and has joints needs RK4, or a check of where its centre of mass goes.
#
# Fails when that changes. Needs npm and node; leaves nothing behind.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --ignore-scripts --prefix . mujoco-js@0.0.7 >/dev/null 2>&1 ||
    { echo "npm could not install mujoco-js 0.0.7" >&2 && exit 1; }

cat >pair.mjs <<'JS'
import load from 'mujoco-js';
const mujoco = await load();
console.log('MuJoCo', mujoco.mj_versionString());
mujoco.FS.mkdir('/scene');
mujoco.FS.mount(mujoco.MEMFS, { root: '.' }, '/scene');

// Two boxes of 1 kg, 0.8 m long and 0.4 m wide, whose centres are half a metre from the hinge; all in the plane of x and y.
const inertia = (0.8 ** 2 + 0.4 ** 2) / 12;
function state({ qpos: q, qvel: u }) {
    const turned = 2 * Math.atan2(q[6], q[3]), bent = turned + q[7], w = u[5], v = u[5] + u[6];
    const x = q[0] + 0.5 * (Math.cos(turned) + Math.cos(bent)), y = q[1] + 0.5 * (Math.sin(turned) + Math.sin(bent));
    const vx = u[0] - 0.5 * (w * Math.sin(turned) + v * Math.sin(bent)), vy = u[1] + 0.5 * (w * Math.cos(turned) + v * Math.cos(bent));
    return { centre: [(q[0] + x) / 2, (q[1] + y) / 2], momentum: [u[0] + vx, u[1] + vy],
        angular: inertia * (w + v) + 0.5 * ((x - q[0]) * (vy - u[1]) - (y - q[1]) * (vx - u[0])),
        energy: 0.5 * (u[0] ** 2 + u[1] ** 2 + vx ** 2 + vy ** 2 + inertia * (w * w + v * v)) };
}
function run(integrator, step) {
    const box = `<geom type='box' size='.4 .2 .1' mass='1' contype='0' conaffinity='0'/>`;
    mujoco.FS.writeFile('/scene/scene.xml', `<mujoco><option gravity='0 0 0' integrator='${integrator}' timestep='${step}'/><worldbody>
        <body pos='-.5 0 0'><freejoint/>${box}<body pos='1 0 0'><joint type='hinge' axis='0 0 1' pos='-.5 0 0'/>${box}</body></body>
        </worldbody></mujoco>`);
    const model = mujoco.MjModel.loadFromXML('/scene/scene.xml'), data = new mujoco.MjData(model);
    data.qvel[5] = 3;
    data.qvel[6] = -7;
    const { momentum } = state(data);
    data.qvel[0] -= momentum[0] / 2;
    data.qvel[1] -= momentum[1] / 2;
    mujoco.mj_forward(model, data);
    const first = state(data), steps = Math.round(100 / step);
    for (let i = 0; i < steps; ++i) mujoco.mj_step(model, data);
    const last = state(data), result = { moved: Math.hypot(last.centre[0] - first.centre[0], last.centre[1] - first.centre[1]),
        angular: last.angular / first.angular, energy: last.energy / first.energy };
    console.log(`${integrator}, step ${step} s: momentum ${Math.hypot(...first.momentum).toExponential(0)} kg m/s at first; after 100 s ` +
        `moved by ${result.moved.toExponential(2)} m, ${result.angular.toFixed(3)} of the angular momentum, ` +
        `${result.energy.toFixed(3)} of the energy`);
    return result;
}
const euler = run('Euler', 0.002), finer = run('Euler', 0.0005), fast = run('implicitfast', 0.002), implicit = run('implicit', 0.002);
const runge = run('RK4', 0.002);
const good = [euler, fast].every((r) => r.moved > 0.5 && r.angular < 0.95 && r.energy < 0.8) && implicit.moved > 0.2 &&
    implicit.angular > 1.1 && implicit.energy > 1.5 && Math.abs(euler.moved / finer.moved - 4) < 1 &&
    runge.moved < 1e-6 && Math.abs(runge.angular - 1) < 1e-6 && Math.abs(runge.energy - 1) < 1e-6;
if (!good) {
    console.error('this is another behaviour than the one described');
    process.exit(1);
}
JS
node pair.mjs
