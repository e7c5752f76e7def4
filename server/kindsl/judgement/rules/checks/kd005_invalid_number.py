"""A number in a form that the language does not support.

## What it does
Reports an integer where both generators require a decimal point, a decimal comma, hexadecimal
digits, two points, digits in groups (`1 234.5`, `1'000.0`), strange characters in a number or right
beside it, powers of ten (`1.0*10^-3`), and an `id` that is not a natural number.

## Why is this bad?
`1` for `1.0` is the most common mistake of all: one generator rejects it with "no viable
alternative", the other crashes later, without a line number.

## Example
```kindsl
translation = (1, 0, 0)
```

## Fix
Writes `1.0` for `1` and `0.001` for `1.0*10^-3`. Safe: the value stays. Writes `1.5` for `1,5`,
`1234.5` for `1 234.5` and the like. Unsafe: it is a guess; `1,234` may be either of two numbers.
"""

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.ERROR)
