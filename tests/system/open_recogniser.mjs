// Speaks to hear.mjs as Fulcrum does (dialogue/speech/external/hearing_lines.h).
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { createInterface } from "node:readline";
import { find_nearest } from "../../examples/open-recogniser/nearest.mjs";

const here = new URL(".", import.meta.url);

class Ear {
  constructor(...words) {
    const program = new URL("../../examples/open-recogniser/hear.mjs", here).pathname;
    this.child = spawn(process.execPath, [program, ...words], { stdio: ["pipe", "pipe", "inherit"] });
    this.lines = createInterface({ input: this.child.stdout })[Symbol.asyncIterator]();
  }
  send(line) {
    this.child.stdin.write(`${typeof line === "string" ? line : JSON.stringify(line)}\n`);
  }
  async hear() {
    return JSON.parse((await this.lines.next()).value);
  }
  async end() {
    this.child.stdin.end();
    return new Promise((done) => this.child.on("close", done));
  }
}

// the (egg | watermelon) is (the heaviest | most heavy, an error), with a way round that nothing is said on
const graph = {
  words: ["the", "egg", "watermelon", "is", "heaviest", "most", "heavy"],
  nodes: 8,
  arcs: [[0, 1, 0, 1], [0, 1, -1, 0.2], [1, 2, 1, 1], [1, 2, 2, 1], [2, 5, 3, 1], [5, 3, 0, 1], [3, 7, 4, 1], [5, 4, 5, 0.2], [4, 7, 6, 1]],
};
const audio = (question, text) => {
  const bytes = Buffer.alloc(2 * text.length);
  [...text].forEach((letter, i) => bytes.writeInt16LE(letter.charCodeAt(0), 2 * i));
  return { audio: question, pcm: bytes.toString("base64") };
};

// The nearest sentence: spaces and marks count nothing, an error costs a little, what is far is told as far.
assert.deepEqual(find_nearest(graph, "The water melon is the heaviest!"), { sentence: "the watermelon is the heaviest", share: 0 });
assert.equal(find_nearest(graph, "the egg is most heavy").sentence, "the egg is most heavy");
assert.equal(find_nearest(graph, "the eg is the heaviesd").sentence, "the egg is the heaviest");
assert.ok(Math.abs(find_nearest(graph, "the eg is the heaviesd").share - 2 / 19) < 1e-9);
assert.ok(find_nearest(graph, "what time is it now").share > 0.4);
assert.ok(find_nearest(graph, "").share === 1);
assert.equal(find_nearest({ ...graph, arcs: [[0, 1, 0, 1]] }, "the"), null);
// A circle leads nowhere, and does not hang.
assert.equal(find_nearest({ words: ["a"], nodes: 3, arcs: [[0, 1, 0, 1], [1, 1, 0, 1], [1, 2, 0, 1]] }, "a"), null);

const ear = new Ear(new URL("spelling_model.mjs", here).pathname);
assert.deepEqual(await ear.hear(), { ready: 1, name: "speller", form: false });
for (const bad of ["nonsense", "7", "{}", { listen: 1 }, { listen: 1, ...graph, nodes: 3 }, { listen: 1, ...graph, words: [] }]) {
  ear.send(bad);
  assert.ok((await ear.hear()).trouble, JSON.stringify(bad));
}
ear.send({ listen: 4, ...graph });
assert.deepEqual(await ear.hear(), { listening: 4, unknown: [] });
ear.send(audio(3, "of another question"));
ear.send(audio(4, "the water melon"));
ear.send(audio(4, " is the heaviest"));
ear.send({ end: 3 });
ear.send({ end: 4 });
assert.deepEqual(await ear.hear(), { heard: 4, text: "the watermelon is the heaviest", confidence: 1 });
ear.send(audio(4, "what time is it now"));
ear.send({ end: 4 });
assert.ok((await ear.hear()).confidence < 0.4);
ear.send({ end: 4 });
assert.deepEqual(await ear.hear(), { heard: 4, text: "", confidence: 0 });
ear.send({ stop: 4 });
ear.send({ end: 4 });
ear.send({ listen: 5, ...graph });
assert.deepEqual(await ear.hear(), { listening: 5, unknown: [] });
assert.equal(await ear.end(), 0);

// Without its model: one sentence, and the end.
const deaf = new Ear(new URL("no_such_model.mjs", here).pathname);
assert.match((await deaf.hear()).trouble, /the model is not there/);
assert.equal(await deaf.end(), 1);
