"""A trivial server on pygls: the baseline of the activation benchmark."""

from pygls.lsp.server import LanguageServer

LanguageServer("minimal", "0").start_io()
