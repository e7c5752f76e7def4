"""Speaks the language server protocol with an editor.

examples:
  kindsl language-server --tcp 127.0.0.1:2087 --log-level debug
"""

import argparse
import logging
import sys
from pathlib import Path

SUMMARY = "run the language server for an editor"
RUNS_LONG = True
_LEVELS = ("debug", "info", "warning", "error")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument(
        "--stdio", action="store_true", help="communicate over stdin and stdout (default)"
    )
    parser.add_argument(
        "--tcp", metavar="HOST:PORT", type=_address, help="communicate over a socket"
    )
    parser.add_argument(
        "--log-file", metavar="FILE", type=Path, help="log to this file instead of stderr"
    )
    parser.add_argument("--log-level", choices=_LEVELS, default="warning")


def run(args: argparse.Namespace) -> int:
    """Serve until the client says `exit`.

    Returns:
        0 after `shutdown` and `exit`, else 1; 2 when the server cannot start.
    """
    try:
        _log_to(args.log_file, args.log_level)
        return _serve(args.tcp)
    except OSError as error:
        print(f"kindsl language-server: {error}", file=sys.stderr)
        return 2
    except ImportError as error:
        print(f"kindsl language-server: {_missing(error)}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130


def main() -> None:
    """Run as a command of its own."""
    parser = argparse.ArgumentParser(prog="kindsl-language-server", description=__doc__)
    add_arguments(parser)
    sys.exit(run(parser.parse_args()))


def _serve(tcp: tuple[str, int] | None) -> int:
    import asyncio

    from kindsl.frontends.lsp.run import serve_stdio, serve_tcp
    from kindsl.frontends.lsp.server import KindslLanguageServer

    server = KindslLanguageServer()
    return asyncio.run(serve_stdio(server) if tcp is None else serve_tcp(server, *tcp))


def _address(text: str) -> tuple[str, int]:
    host, _, port = text.rpartition(":")
    if not port.isdigit() or int(port) > 65535:
        raise argparse.ArgumentTypeError(f"'{text}' is not HOST:PORT")
    return host or "127.0.0.1", int(port)


def _log_to(file: Path | None, level: str) -> None:
    style = "%(asctime)s %(levelname)s %(name)s: %(message)s"
    logging.basicConfig(filename=file, level=level.upper(), format=style)
    if level != "debug":
        logging.getLogger("pygls").setLevel(logging.ERROR)


def _missing(error: ImportError) -> str:
    return f"{error.msg}; install the server's dependencies with: pip install 'kindsl[server]'"


if __name__ == "__main__":
    main()
