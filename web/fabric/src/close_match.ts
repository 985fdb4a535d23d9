/** The known word that is closest to a misspelt one. */

/** The known word most like `word`, by shared runs of letters (Ratcliff and Obershelp); null below `cutoff`. */
export function closeMatch(word: string, known: readonly string[], cutoff = 0.6): string | null {
  let best: string | null = null;
  let most = cutoff;
  for (const choice of known) {
    const likeness = (2 * sharedLetters(word, choice)) / Math.max(word.length + choice.length, 1);
    if (likeness > most || (likeness === most && best === null)) [best, most] = [choice, likeness];
  }
  return best;
}

/** Letters in the longest common run, and in those to its left and right. */
function sharedLetters(a: string, b: string): number {
  let [length, inA, inB] = [0, 0, 0];
  for (let i = 0; i < a.length; i++)
    for (let j = 0; j < b.length; j++) {
      let run = 0;
      while (i + run < a.length && j + run < b.length && a[i + run] === b[j + run]) run++;
      if (run > length) [length, inA, inB] = [run, i, j];
    }
  if (length === 0) return 0;
  const left = sharedLetters(a.slice(0, inA), b.slice(0, inB));
  return length + left + sharedLetters(a.slice(inA + length), b.slice(inB + length));
}
