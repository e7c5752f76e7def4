"""A twin that the configuration names cannot be read.

## What it does
Reports the path of a `[[twins]]` table in `kindsl.toml` whose file is missing, is not in its
format, or describes a robot that the language does not support. A `.xacro` file is never read,
since that evaluates expressions in it: name the URDF that it makes. In a workspace that is not
trusted only files in its folders are read, and this is an information.

## Why is this bad?
Nothing is compared, and the files drift apart unnoticed.

## Example
```toml
[[twins]]
document = "hya.kindsl"
file = "../urdf/hya.udrf"
```
"""

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.WARNING)
