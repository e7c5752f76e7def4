"""What a hover tells of values, of parameters and constants in odd places."""

import pytest
from tests.support.cursor import at_cursor

from kindsl.frontends.features.hover.hover import hover
from kindsl.frontends.features.symbol_at import symbol_at
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding


def shown(marked, **bindings):
    values = {name: Binding(value) for name, value in bindings.items()}
    found = hover(*at_cursor(marked, Settings(bindings=values)))
    return None if found is None else found.markdown


def of_mass(value, **bindings):
    """Return what a hover tells of a mass that `value` has a `$0` in."""
    text = f"link l {{ inertia_params {{ mass = {value} CoM = (<c=2.0>, 0.0, 0.0) }} }}"
    return shown(text, **bindings)


@pytest.mark.parametrize(
    ("value", "told"),
    [
        ("<c>*2.0$0", "mass of link `l`: **4 kg**"),
        ("<c>*x*2.0$0", "mass of link `l`: not known, the parameter `x` has no value"),
        ("<d>*2.0$0", "mass of link `l`: not known, the constant `d` has no value"),
        ("x[3.0]*y*2.0$0", "mass of link `l`: not known, the parameter `y` has no value"),
        ("<>*2.0$0", "mass of link `l`: not known, `<>*2.0` is not a number"),
        ("2.0$0/0.0", "mass of link `l`: not known, `2.0/0.0` is not a number"),
        ("2.0$0 - ", "mass of link `l`: not known, `2.0 -` is not a number"),
    ],
)
def test_a_value_tells_what_it_comes_to_or_why_not(value, told):
    assert of_mass(value) == told


def test_of_two_parameters_the_one_without_a_value_is_named():
    assert of_mass("x*y*2.0$0", x=1.0) == (
        "mass of link `l`: not known, the parameter `y` has no value"
    )


@pytest.mark.parametrize(
    ("value", "told"),
    [
        ("<$0d>*2.0", "no value: write `<d=1.0>` somewhere"),
        ("<$0d=1.0>", "value 1"),
        ("<$0d=x>", "no value: the parameter `x` has no value"),
        ("<$0d=1.0/0.0>", "no value: `1.0/0.0` is not a number"),
        ("<$0c>*2.0", "value 2"),
    ],
)
def test_a_constant_tells_its_value(value, told):
    markdown = of_mass(value)
    assert markdown is not None
    assert f"- {told}\n" in markdown
    assert "\n\nmass of link `l`: " in markdown


@pytest.mark.parametrize(
    ("uses", "told"),
    [
        (1, "1 use: mass of link `l0`"),
        (2, "2 uses: mass of link `l0`; mass of link `l1`"),
        (8, "8 uses: " + "; ".join(f"mass of link `l{k}`" for k in range(8))),
        (9, "9 uses: " + "; ".join(f"mass of link `l{k}`" for k in range(8)) + " and 1 more"),
    ],
)
def test_a_parameter_lists_its_first_uses(uses, told):
    links = "".join(f"link l{k} {{ inertia_params {{ mass = m }} }}\n" for k in range(uses))
    markdown = shown(links.replace("= m", "= $0m", 1))
    assert markdown is not None
    assert f"- {told}\n" in markdown


@pytest.mark.parametrize(
    ("low", "high", "told"),
    [
        (None, None, None),
        (0.0, None, "range 0 to …"),
        (None, 2.0, "range … to 2"),
        (-1.0, 2.0, "range -1 to 2"),
    ],
)
def test_a_parameter_tells_its_range(low, high, told):
    bound = Settings(bindings={"m": Binding(1.0, low, high)})
    found = hover(*at_cursor("link l { inertia_params { mass = $0m[3.0] } }", bound))
    assert found is not None
    lines = [line.removeprefix("- ") for line in found.markdown.split("\n")]
    assert "value 1, from the settings" in lines
    assert "default 3, in the document, not used" in lines
    assert [line for line in lines if line.startswith("range")] == ([told] if told else [])


def test_a_frame_of_an_inertia_is_that_of_its_own_link():
    frame = "frames { %s { translation = (%s, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }"
    text = (
        f"link a {{ inertia_params {{ ref_frame = ti$0p mass = 1.0 }} {frame % ('tip', '0.1')} }}\n"
        f"link b {{ {frame % ('tip', '0.2')} }}\n"
    )
    assert "origin (0.1, 0, 0) m" in (shown(text) or "")
    assert shown(text.replace("tip {", "top {")) == "There is no frame `tip`."
    assert shown(f"link a {{ }} {text.replace('link a', 'link')}") == "There is no frame `tip`."


def test_an_inertia_in_a_frame_that_nobody_declares_is_not_known():
    body = "mass = 1.0 CoM = (0.0, 0.0, 0.0) Ix=1.0 Iy=1.0 Iz=1.0 Ixy=0.0 Ixz=0.0 Iyz=0.0"
    text = f"link $0a {{ inertia_params {{ ref_frame = gone {body} }} }}"
    assert "mass properties are not known: it has no frame `gone`" in (shown(text) or "")


def test_a_keyword_of_a_value_tells_both():
    text = "link l { frames { f { rotation = (P$0I, 0.0, 0.0) } } }"
    told = shown(text) or ""
    assert told.startswith("rotation about x of frame `f`: **3.142 rad = 180°**\n\n**`PI`**")
    assert (shown(text.replace("P$0I", "p$0i")) or "").endswith("Write `PI` for the number.")


def test_names_end_where_they_end():
    marked = "link l { inertia_params { mass = am$0 + b } }"
    analysis, offset = at_cursor(marked)
    found = [symbol_at(analysis, offset + k) for k in (-3, -2, 0, 1, 3, 4, 5)]
    assert [s.entity.name if s else "" for s in found] == ["", "am", "am", "", "b", "b", ""]


def test_the_names_of_an_endless_sum_are_not_links():
    text = "link l { inertia_params { mass = a$0 + " + "b + " * 3000 + "1.0 } }"
    assert "There is no link" not in (shown(text) or "")
