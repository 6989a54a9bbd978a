// A model for tests: each sample, -1 to 1 of 16 bits, is a letter.
export const name = "speller";
export async function load() {
  return async (samples) => String.fromCharCode(...samples.map((x) => Math.round(32_768 * x)));
}
