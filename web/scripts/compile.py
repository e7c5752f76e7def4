"""Zip the standard library and the site with .pyc for .py; runs in Pyodide at build time."""

import importlib._bootstrap_external as bootstrap
import importlib.util
import re
import zipfile
from pathlib import Path

WORK = Path("/build")
# Of the standard library: programs, tests, mail, servers, other processes.
UNUSED = re.compile(
    r"(_pyrepl|bdb|cProfile|cmd|colorsys|compileall|doctest|ftplib|imaplib|mailbox|modulefinder"
    r"|multiprocessing|netrc|pdb|pickletools|plistlib|poplib|profile|pstats|pyclbr|pydoc|pydoc_data"
    r"|rlcompleter|sched|shelve|smtplib|socketserver|tabnanny|timeit|trace|unittest|wave|wsgiref"
    r"|xmlrpc|zipapp)(/|\.py$)"
)


def compiled(name, data):
    """Return a file as it is stored: code compiled and bound to its source, the rest as it is."""
    if not name.endswith(".py"):
        return name, data
    code = compile(data, name, "exec", dont_inherit=True)
    hashed = importlib.util.source_hash(data)
    return name + "c", bytes(bootstrap._code_to_hash_pyc(code, hashed, False))


def write(archive, files):
    """Write files, given as pairs of name and bytes."""
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as target:
        for name, data in files:
            stored, content = compiled(name, data)
            target.writestr(zipfile.ZipInfo(stored), content, zipfile.ZIP_DEFLATED)


with zipfile.ZipFile(WORK / "stdlib.zip") as library:
    names = [entry.filename for entry in library.infolist() if not entry.is_dir()]
    kept = ((name, library.read(name)) for name in names if not UNUSED.match(name))
    write(WORK / "compiled_stdlib.zip", kept)
site = WORK / "site"
sources = sorted(path for path in site.rglob("*") if path.is_file())
write(
    WORK / "compiled_site.zip",
    ((path.relative_to(site).as_posix(), path.read_bytes()) for path in sources),
)
