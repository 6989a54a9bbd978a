// The sentence of a question that is nearest to what was heard.
//
//   distance = letters to be put in, left out or changed, and spoken_as_wrong for each choice that is an error of form
//   share    = distance / letters of the longer of both
// Spaces count nothing: "water melon" is the watermelon. All ways through the graph are tried at once, letter by letter of its words:
// at each node stands, for each beginning of what was heard, the least distance of a way there.
//
// Source: V. Levenshtein 1966, Binary codes capable of correcting deletions, insertions, and reversals, Soviet Physics Doklady 10;
//   over a graph: E. Myers, W. Miller 1989, Approximate matching of regular expressions, Bulletin of Mathematical Biology 51.

const spoken_as_wrong = 0.2; // letters: of two sentences that are as near, the one with fewer errors

export function letters_of(text) {
  return text.toLowerCase().replace(/[^\p{Letter}\p{Number}]/gu, "");
}

/// The rows of a word's letters below a row of least distances; `from` says where each of the last row's ways began.
function pass_word(row, word, heard) {
  let now = row.map((distance, i) => ({ distance, from: i }));
  for (const letter of word) {
    const next = [{ distance: now[0].distance + 1, from: now[0].from }];
    for (let i = 1; i < now.length; ++i) {
      const changed = now[i - 1].distance + (heard[i - 1] === letter ? 0 : 1);
      const put_in = now[i].distance + 1;
      const left_out = next[i - 1].distance + 1;
      const least = Math.min(changed, put_in, left_out);
      next.push({
        distance: least,
        from: least === changed ? now[i - 1].from : least === put_in ? now[i].from : next[i - 1].from,
      });
    }
    now = next;
  }
  return now;
}

/// The arcs in such an order that all into a node come before all out of it; those of a circle are left out.
function in_order(graph) {
  const leaving = Array.from({ length: graph.nodes }, () => []);
  const waiting = new Array(graph.nodes).fill(0);
  for (const arc of graph.arcs) {
    leaving[arc[0]].push(arc);
    ++waiting[arc[1]];
  }
  const ready = [...waiting.keys()].filter((node) => waiting[node] === 0);
  const arcs = [];
  while (ready.length > 0) {
    for (const arc of leaving[ready.pop()]) {
      arcs.push(arc);
      if (--waiting[arc[1]] === 0) {
        ready.push(arc[1]);
      }
    }
  }
  return arcs;
}

/// `graph` as in the line to listen: words, nodes, arcs [from, to, word, weight]; from node 0 to the last one.
/// Gives the sentence and its share, or null where the graph has no way to its end.
export function find_nearest(graph, text) {
  const heard = letters_of(text);
  const start = Array.from({ length: heard.length + 1 }, (_, i) => i);
  const rows = Array.from({ length: graph.nodes }, () => null);
  rows[0] = start.map((distance) => ({ distance, before: null }));
  for (const [from, to, word, weight] of in_order(graph)) {
    if (rows[from] === null) {
      continue;
    }
    const letters = word < 0 ? "" : letters_of(graph.words[word]);
    const passed = pass_word(rows[from].map((cell) => cell.distance), letters, heard);
    rows[to] ??= start.map(() => ({ distance: Infinity, before: null }));
    passed.forEach((cell, i) => {
      const distance = cell.distance + (weight < 1 ? spoken_as_wrong : 0);
      if (distance < rows[to][i].distance) {
        rows[to][i] = { distance, before: { node: from, at: cell.from, word } };
      }
    });
  }
  const end = rows[graph.nodes - 1]?.[heard.length];
  if (!end || end.distance === Infinity) {
    return null;
  }
  const words = [];
  for (let step = end.before; step !== null; step = rows[step.node][step.at].before) {
    if (step.word >= 0) {
      words.unshift(graph.words[step.word]);
    }
  }
  const sentence = words.join(" ");
  const longer = Math.max(heard.length, letters_of(sentence).length, 1);
  return { sentence, share: Math.min(end.distance / longer, 1) };
}
