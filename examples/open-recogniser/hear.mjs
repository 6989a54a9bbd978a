// Hears for Fulcrum with an open vocabulary: a program for --speech exec: that keeps to dialogue/speech/external/hearing_lines.h.
//
//   line to listen -> the question's graph;  lines of audio, line of the end -> what was said -> its nearest sentence -> line of what was heard
//   confidence = 1 - share / doubtful / 2, not below 0       share: nearest.mjs; a lesson asks again below 0.4
// A model of this kind writes what people mostly say, and so mends a learner's grammar. It therefore says "form": false: it is asked for
// the meaning alone, and nothing it hears is marked as an error or as free of errors.
//
//   node hear.mjs [MODEL.mjs]      another model: a module with `name` and `load`, as moonshine.mjs
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";
import { find_nearest } from "./nearest.mjs";

const doubtful = 0.2; // share at which it is as likely another sentence
const longest_samples = 60 * 16_000;

const say = (line) => process.stdout.write(`${JSON.stringify(line)}\n`);

function to_samples(base64) {
  const bytes = Buffer.from(base64, "base64");
  const samples = new Float32Array(bytes.length >> 1);
  for (let i = 0; i < samples.length; ++i) {
    samples[i] = bytes.readInt16LE(2 * i) / 32_768;
  }
  return samples;
}

function is_graph(line) {
  const is_place = (i, n) => Number.isInteger(i) && i >= 0 && i < n;
  return (
    Array.isArray(line.words) && line.words.every((word) => typeof word === "string") &&
    Number.isInteger(line.nodes) && line.nodes >= 2 && line.nodes <= 1_000_000 && Array.isArray(line.arcs) &&
    line.arcs.every(
      (arc) =>
        Array.isArray(arc) && is_place(arc[0], line.nodes) && is_place(arc[1], line.nodes) &&
        (arc[2] === -1 || is_place(arc[2], line.words.length)) && typeof arc[3] === "number",
    )
  );
}

/// One question at a time; `recognise` gives the text of samples.
class Listener {
  constructor(recognise) {
    this.recognise = recognise;
    this.forget();
  }

  forget() {
    this.question = null;
    this.graph = null;
    this.parts = [];
  }

  listen(line) {
    this.forget();
    if (!is_graph(line)) {
      say({ trouble: "the line to listen has no whole graph" });
      return;
    }
    this.question = line.listen;
    this.graph = line;
    say({ listening: line.listen, unknown: [] });
  }

  take(line) {
    const held = this.parts.reduce((n, part) => n + part.length, 0);
    if (line.audio === this.question && held < longest_samples) {
      this.parts.push(to_samples(line.pcm));
    }
  }

  async answer(line) {
    if (line.end !== this.question || this.graph === null) {
      return;
    }
    const samples = new Float32Array(this.parts.reduce((n, part) => n + part.length, 0));
    let at = 0;
    for (const part of this.parts) {
      samples.set(part, at);
      at += part.length;
    }
    this.parts = [];
    const text = await this.recognise(samples);
    const nearest = text === "" ? null : find_nearest(this.graph, text);
    const confidence = nearest ? Math.max(0, 1 - nearest.share / doubtful / 2) : 0;
    say({ heard: line.end, text: nearest?.sentence ?? "", confidence });
  }

  async obey(line) {
    if (line.listen !== undefined) {
      this.listen(line);
    } else if (line.audio !== undefined && typeof line.pcm === "string") {
      this.take(line);
    } else if (line.end !== undefined) {
      await this.answer(line);
    } else if (line.stop !== undefined) {
      this.forget();
    } else {
      say({ trouble: "the line is none of listen, audio, end and stop" });
    }
  }
}

async function main() {
  const model = await import(process.argv[2] ? pathToFileURL(process.argv[2]).href : "./moonshine.mjs").catch((error) => {
    say({ trouble: `the model is not there (${error.code ?? error.message}); run npm ci --ignore-scripts in this folder` });
    process.exit(1);
  });
  const listener = new Listener(await model.load());
  say({ ready: 1, name: model.name, form: false });
  for await (const text of createInterface({ input: process.stdin })) {
    let line = null;
    try {
      line = JSON.parse(text);
    } catch {
      // As any other line that is none.
    }
    if (line === null || typeof line !== "object") {
      say({ trouble: "the line is no JSON object" });
    } else {
      await listener.obey(line);
    }
  }
}

await main();
