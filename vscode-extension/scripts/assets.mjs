// Copy what the extension shares with the rest of the project: grammar, pictures, licence, change log.
import { copyFile, mkdir } from "node:fs/promises";

await mkdir("syntaxes", { recursive: true });
for (const name of ["kindsl.tmLanguage.json", "language-configuration.json"]) {
  await copyFile(`../grammar/${name}`, `syntaxes/${name}`);
}
for (const name of ["vscode-preview.png", "vscode-problems.png"]) {
  await copyFile(`../docs/images/${name}`, `images/${name}`);
}
for (const name of ["LICENSE", "CHANGELOG.md"]) {
  await copyFile(`../${name}`, name).catch((error) => {
    if (error.code !== "ENOENT") throw error;
    console.warn(`${name} is not there yet, the package goes without it`);
  });
}
