// The front of a VS Code in a browser: everything goes to its server, /proxy/PORT/ to that port of the machine.
//
// usage: front.mjs PORT SERVER_PORT. Like code-server's own, it leaves the outer Host and Origin as they are.
import http from "node:http";
import net from "node:net";

const [port, serverPort] = process.argv.slice(2).map(Number);
const PROXIED = /^\/proxy\/(\d+)(\/.*)$/;

http
  .createServer((request, response) => {
    const to = http.request(target(request), (answer) => {
      response.writeHead(answer.statusCode, answer.headers);
      answer.pipe(response);
    });
    to.on("error", (error) => response.writeHead(502).end(error.message));
    request.pipe(to);
  })
  .on("upgrade", (request, socket, head) => {
    const { port: there, path, headers } = target(request);
    const to = net.connect(there, "127.0.0.1", () => {
      const lines = Object.entries(headers).map(([name, value]) => `${name}: ${value}`);
      to.write([`GET ${path} HTTP/1.1`, ...lines, "", ""].join("\r\n"));
      to.write(head);
      to.pipe(socket).pipe(to);
    });
    for (const end of [to, socket]) end.on("error", () => (to.destroy(), socket.destroy()));
  })
  .listen(port, "127.0.0.1");

function target({ method, url, headers }) {
  const [, proxied, path] = PROXIED.exec(url) ?? [];
  if (proxied === undefined) return { host: "127.0.0.1", port: serverPort, method, path: url, headers };
  return { host: "127.0.0.1", port: Number(proxied), method, path, headers };
}
