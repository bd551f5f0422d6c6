// SPDX-License-Identifier: GPL-3.0-or-later
// node validate.mjs MODULES FILE.glb...: what Khronos' validator says of each file. The status is 1
// where it says anything.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename } from "node:path";

const [modules, ...files] = process.argv.slice(2);
const validator = createRequire(`${modules}/`)("gltf-validator");
let said = files.length > 0 ? 0 : 1;
for (const file of files) {
  const { issues, info } = await validator.validateBytes(new Uint8Array(readFileSync(file)));
  const { numErrors, numWarnings, numInfos, numHints } = issues;
  console.log(`${basename(file)}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} notes, ` +
              `${numHints} hints; ${info.totalVertexCount} vertices, ` +
              `${info.animationCount} animation`);
  for (const { code, message, pointer } of issues.messages) console.log(`  ${code} ${pointer}: ${message}`);
  said += numErrors + numWarnings + numInfos + numHints;
}
process.exit(said > 0 ? 1 : 0);
