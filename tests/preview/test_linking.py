"""Modules become one script that does what they do."""

import subprocess

import pytest
from tests.vscode.browser import require

from kindsl.frontends.preview.linking import LinkingError, linked


def output(modules, entry="main.js"):
    """Return what the linked script prints."""
    command = [require("node", "nodejs"), "-e", linked(entry, modules.__getitem__)]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def test_each_module_has_names_of_its_own():
    modules = {
        "main.js": 'import { area as of, SIDE } from "./shapes/square.js";\n'
        "const half = 2;\nconsole.log(of(SIDE), half);\n",
        "shapes/square.js": 'import { twice } from "../numbers.js";\nconst half = 0.5;\n'
        "export const SIDE = 3;\nexport function area(side) { return half * twice(side ** 2); }\n",
        "numbers.js": "export class Half {}\nexport const twice = (n) => 2 * n;\n",
    }
    assert output(modules) == "9 2\n"


def test_a_module_that_two_import_runs_once_and_first():
    modules = {
        "main.js": 'import {\n  b,\n} from "./b.js";\nimport { a } from "./a.js";\n'
        "console.log(a === b);\n",
        "a.js": 'console.log("a");\nexport const a = {};\n',
        "b.js": 'import { a } from "./a.js";\nconsole.log("b");\nexport const b = a;\n',
    }
    assert output(modules) == "a\nb\ntrue\n"


def test_the_script_is_strict():
    assert output({"main.js": "console.log((function () { return this; })());\n"}) == "undefined\n"


def test_modules_that_import_each_other_are_refused():
    modules = {
        "a.js": 'import { b } from "./b.js";\nexport const a = 1;\n',
        "b.js": 'import { a } from "./a.js";\nexport const b = 1;\n',
    }
    with pytest.raises(LinkingError, match=r"a\.js"):
        linked("a.js", modules.__getitem__)


@pytest.mark.parametrize(
    "line",
    [
        'import * as all from "./b.js";',
        'import b from "./b.js";',
        'import { b } from "elsewhere";',
        "export default 1;",
        "export let a = 1;",
        "export { a };",
        'export * from "./b.js";',
    ],
)
def test_what_says_more_than_names_is_refused(line):
    with pytest.raises(LinkingError, match=r"'a\.js' says more than names"):
        linked("a.js", {"a.js": f"{line}\n", "b.js": ""}.__getitem__)
