// What was said, by Moonshine tiny: an encoder of the whole utterance, and a decoder that gives one piece of a word after the other,
// always the likeliest, until it gives the end.
//
// Source: N. Jeffries and others 2024, Moonshine: Speech recognition for live transcription and voice commands. The weights come with
//   the npm package @moonshine-ai/moonshine-js (MIT).
import { readFile } from "node:fs/promises";
import tokenizer from "llama-tokenizer-js";
import * as ort from "onnxruntime-web";

const rate_Hz = 16_000;
const layers = 6;
const heads = 8;
const head_size = 36;
const first_piece = 1;
const last_piece = 2;
const most_pieces_per_s = 6; // a model that has lost its way repeats itself
const least_s = 0.3;

const folder = new URL("./node_modules/@moonshine-ai/moonshine-js/dist/model/tiny/quantized/", import.meta.url);

/// What each layer of the decoder remembers, by name: of what it has written, and of what it was told by the encoder.
function empty_memory() {
  const memory = {};
  for (let layer = 0; layer < layers; ++layer) {
    for (const of of ["decoder", "encoder"]) {
      for (const part of ["key", "value"]) {
        memory[`${layer}.${of}.${part}`] = new ort.Tensor("float32", new Float32Array(0), [0, heads, 1, head_size]);
      }
    }
  }
  return memory;
}

function likeliest(scores) {
  let best = 0;
  for (let i = 1; i < scores.length; ++i) {
    best = scores[i] > scores[best] ? i : best;
  }
  return best;
}

export const name = "moonshine";

/// Loads the model; gives a function from samples (-1 to 1, 16 kHz) to text.
export async function load() {
  ort.env.wasm.numThreads = 1; // a lesson runs beside it
  ort.env.logLevel = "error";
  const open = async (file) => ort.InferenceSession.create(await readFile(new URL(file, folder)));
  const encoder = await open("encoder_model.onnx");
  const decoder = await open("decoder_model_merged.onnx");

  return async (samples) => {
    if (samples.length < least_s * rate_Hz) {
      return "";
    }
    const sound = new ort.Tensor("float32", samples, [1, samples.length]);
    const { last_hidden_state } = await encoder.run({ input_values: sound });
    const memory = empty_memory();
    const pieces = [];
    let piece = first_piece;
    for (let i = 0; i < (samples.length / rate_Hz) * most_pieces_per_s + 2; ++i) {
      const feeds = {
        input_ids: new ort.Tensor("int64", BigInt64Array.of(BigInt(piece)), [1, 1]),
        encoder_hidden_states: last_hidden_state,
        use_cache_branch: new ort.Tensor("bool", [i > 0], [1]),
      };
      for (const [part, tensor] of Object.entries(memory)) {
        feeds[`past_key_values.${part}`] = tensor;
      }
      const answer = await decoder.run(feeds);
      piece = likeliest(answer.logits.data);
      if (piece === last_piece) {
        break;
      }
      pieces.push(piece);
      // What the encoder said is remembered once.
      for (const part of Object.keys(memory)) {
        memory[part] = i === 0 || part.includes("decoder") ? answer[`present.${part}`] : memory[part];
      }
    }
    return tokenizer.decode(pieces, false, false).trim();
  };
}
