// Validates GLB files. Prints a line a file: errors, warnings, name; then every message that is worse than a hint.
//   node validate.mjs FILE...
import { readFileSync } from 'node:fs';
import validator from 'gltf-validator';

let bad = 0;
for (const file of process.argv.slice(2)) {
  const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(file)));
  bad += issues.numErrors + issues.numWarnings;
  console.log(`${issues.numErrors} errors, ${issues.numWarnings} warnings: ${file}`);
  for (const { severity, code, message, pointer } of issues.messages.filter((issue) => issue.severity < 2))
    console.log(`  ${severity} ${code} ${pointer}: ${message}`);
}
process.exit(bad > 0 ? 1 : 0);
