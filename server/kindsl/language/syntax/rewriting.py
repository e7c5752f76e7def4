"""Values of one target written so that both take them."""

from decimal import Decimal, InvalidOperation

from kindsl.language.syntax.scanner import scan
from kindsl.language.syntax.tree import Node, Token
from kindsl.language.syntax.value_forms import (
    TARGETS_OF_ALL,
    form_kind,
    is_signed_product,
    kinds_accepted_by,
)

_MOST_DIGITS = 9
_SYMBOLS = frozenset({"pi", "parameter"})


def rewritten(node: Node) -> str | None:
    """Return an expression of the same value that both targets take, None where there is none."""
    new = _form(node)
    if new is None:
        return None
    kinds = tuple(form_kind(token) for token in scan(new))
    return new if kinds_accepted_by(kinds) == TARGETS_OF_ALL else None


def _form(node: Node) -> str | None:
    number = _number(node)
    if number is not None:
        return _decimal(number)
    if node.kind == "negate" and isinstance(node.children[1], Node):
        inner = _form(node.children[1])
        return None if inner is None else inner[1:] if inner.startswith("-") else f"-{inner}"
    if node.kind in ("pi", "parameter"):
        return _text(node)
    if node.kind == "divide":
        return _quotient(node)
    if is_signed_product(node):
        product = _product(node)
        return None if product is None else product[1:] if product[0] == "-" else f"-{product}"
    if node.kind in ("multiply", "juxtaposed_pi", "juxtaposed_parameter"):
        return _product(node)
    return None


def _quotient(node: Node) -> str | None:
    left, right = node.children[0], node.children[2]
    divisor = _number(right)
    symbol = _form(left) if isinstance(left, Node) else None
    if symbol is None or divisor is None or "/" in symbol:
        return None
    return f"{symbol}/{_decimal(divisor)}"


def _product(node: Node) -> str | None:
    """Return `2.0*PI` as `PI/0.5`, where the inverse has few digits."""
    factor, symbol = _number(node.children[0]), node.children[-1]
    if isinstance(symbol, Node) and symbol.kind not in _SYMBOLS:
        return None
    if factor is None or not factor or len(node.children) > 3:
        return None
    inverse = 1 / abs(factor)
    if inverse.normalize() != inverse.quantize(Decimal(1).scaleb(-_MOST_DIGITS)).normalize():
        return None
    return f"{'-' if factor < 0 else ''}{_text(symbol)}/{_decimal(inverse)}"


def _number(node: Node | Token) -> Decimal | None:
    if isinstance(node, Token):
        return _literal(node)
    if node.kind == "number":
        return _number(node.children[0])
    if node.kind not in ("negate", "multiply"):
        return None
    values = [_number(part) for part in node.parts]
    known = [value for value in values if value is not None]
    if not known or len(known) != len(values):
        return None
    return -known[0] if node.kind == "negate" else known[0] * known[-1]


def _literal(token: Token) -> Decimal | None:
    try:
        return Decimal(token.text)
    except InvalidOperation:
        return None


def _decimal(number: Decimal) -> str | None:
    if not -30 < number.adjusted() < 30:
        return None
    text = format(number.normalize(), "f")
    return text if "." in text else text + ".0"


def _text(node: Node | Token) -> str:
    return node.text if isinstance(node, Token) else "".join(t.text for t in node.tokens())
