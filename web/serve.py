"""Serve the playground on the loopback interface, and print its address.

Only for looking at it: any web server can show the folder.
"""

import argparse
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from typing import Any, ClassVar


class Handler(SimpleHTTPRequestHandler):
    """Tells media types that not every system knows, and logs nothing."""

    extensions_map: ClassVar[dict[str, str]] = {
        **SimpleHTTPRequestHandler.extensions_map,
        ".wasm": "application/wasm",
        ".js": "text/javascript",
        ".kindsl": "text/plain; charset=utf-8",
    }
    protocol_version = "HTTP/1.1"

    def log_message(self, *_: Any) -> None:
        """Say nothing."""


def main(folder: str, port: int = 0) -> None:
    """Serve until interrupted."""
    with ThreadingHTTPServer(("127.0.0.1", port), partial(Handler, directory=folder)) as server:
        print(f"http://127.0.0.1:{server.server_port}/", flush=True)
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            print("stopped")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", metavar="FOLDER", help="what `make playground` has built")
    parser.add_argument("port", metavar="PORT", nargs="?", type=int, default=0)
    main(**vars(parser.parse_args()))
