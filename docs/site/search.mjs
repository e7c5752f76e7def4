// Prints what the search of a built site finds, best first: node docs/site/search.mjs SITE QUERY...
// It runs the site's own search worker on the site's own index; a line of JSON for each query.
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import vm from "node:vm";

const [site, ...queries] = process.argv.slice(2);
const folder = path.join(site, "assets", "javascripts", "workers");
const worker = readdirSync(folder).find((name) => /^search\..*\.js$/.test(name));
const index = JSON.parse(readFileSync(path.join(site, "search", "search_index.json"), "utf8"));

let receive, answered;
const scope = {
  console, URL,
  addEventListener: (_, listener) => { receive = listener; },
  postMessage: (message) => answered(message),
};
scope.self = scope;
vm.runInNewContext(readFileSync(path.join(folder, worker), "utf8"), scope);

const SETUP = 0, QUERY = 2; // the types of the worker's messages
const ask = (type, data) => new Promise((resolve) => { answered = resolve; receive({ data: { type, data } }); });

await ask(SETUP, { ...index, options: { suggest: false } });
for (const query of queries) {
  const { data } = await ask(QUERY, query);
  console.log(JSON.stringify(data.items.map((sections) => sections[0].location)));
}
