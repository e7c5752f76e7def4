// Copy what the extension shares with the rest of the project: grammar, an example, pictures, licence, change log; put the pictures
// into the extension's page, since an editor shows no relative ones and there is no address to fetch them from.
import { copyFile, mkdir, readFile, writeFile } from "node:fs/promises";

await mkdir("syntaxes", { recursive: true });
for (const name of ["dtdsl.tmLanguage.json", "kindsl.tmLanguage.json", "language-configuration.json"]) {
  await copyFile(`../grammar/${name}`, `syntaxes/${name}`);
}
await copyFile("../examples/quadruped.kindsl", "walkthrough/quadruped.kindsl");
for (const name of ["vscode-preview.png", "vscode-problems.png"]) {
  await copyFile(`../docs/images/${name}`, `images/${name}`);
}
for (const name of ["LICENSE", "CHANGELOG.md"]) {
  await copyFile(`../${name}`, name).catch((error) => {
    if (error.code !== "ENOENT") throw error;
    console.warn(`${name} is not there yet, the package goes without it`);
  });
}

await mkdir("out", { recursive: true });
await writeFile("out/README.md", await withPictures(await readFile("README.md", "utf8")));

async function withPictures(page) {
  const names = [...new Set([...page.matchAll(/\]\((images\/[\w-]+\.png)\)/g)].map(([, name]) => name))];
  for (const name of names) {
    const data = (await readFile(name)).toString("base64");
    page = page.replaceAll(`](${name})`, `](data:image/png;base64,${data})`);
  }
  return page;
}
