// Asked by test_state_text.py: reads {"hashes": [...], "trees": [...]} and answers what the page makes of them.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const studio = process.argv[2];
const { transformSync } = createRequire(`${studio}/package.json`)("esbuild");
const { code } = transformSync(readFileSync(`${studio}/src/state/state_text.ts`, "utf8"), { loader: "ts", format: "esm" });
const { hashOf, stateOf, stateOfHash } = await import(`data:text/javascript,${encodeURIComponent(code)}`);
const asked = JSON.parse(readFileSync(0, "utf8"));
const { shape } = asked;
const back = (state) => ({ state, again: stateOfHash(hashOf(state, shape), shape), hash: hashOf(state, shape) });
const told = {
  hashes: asked.hashes.map((hash) => back(stateOfHash(hash, shape))),
  trees: asked.trees.map((tree) => back(stateOf(tree, shape))),
  spoilt: {}.spoilt ?? null,
};
console.log(JSON.stringify(told));
