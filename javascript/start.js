// How the package finds its engine: beside itself, by a URL, or as bytes that are there already.

async function bytesOf(wasm) {
  if (wasm instanceof ArrayBuffer || ArrayBuffer.isView(wasm)) return wasm;
  const place = new URL(wasm, import.meta.url);
  if (place.protocol === "file:" && typeof process === "object") {
    const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ "node:fs/promises");
    return readFile(place);
  }
  const answer = await fetch(place);
  if (!answer.ok) throw new Error(`${place} cannot be read: ${answer.status}`);
  return answer.arrayBuffer();
}

async function start({ wasm = new URL("cncsub.wasm", import.meta.url) } = {}) {
  return new Engine(await cncsubModule({ wasmBinary: new Uint8Array(await bytesOf(wasm)) }));
}

export { start, Engine, Library, Run, Machine, Comparison, MOVE_KINDS };
