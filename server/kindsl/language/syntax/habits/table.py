"""The habits, in the order in which they are put right, before any repair is searched.

The search would see several mistakes in them, or take them for something else that fits. Parents
and children are named from below elsewhere; here a parent lists its children, and `parent {` would
be read as `children {`, the contrary. `Ixx` is nearer to `Ixy` than to `Ix`, which it means.

Letters stand for the kinds of tokens, as in `engine.LETTERS`.
"""

from kindsl.language.syntax.habits import values, words
from kindsl.language.syntax.habits.engine import Habit

_KEYWORD = "cVSDRICWvLJB"
_ONE = "[-*/]*[nqPfiem](?:[-*/]+[nqPfiem])*"
_HALF = rf"\((?![^={{}})]*\))(?:{_ONE},){{0,2}}(?:{_ONE})?"
_THREE = r"(?P<quote>[\"']) [if] [if] [if] (?P=quote)|[if] [if] [if](?! [if,])"
_BRACKETED = r"\[[^={}\]),]*,[^={}\])]*\]|\{[^={}),]*,[^={})]*\}"
_VALUE = (
    r"\([^={})]*\)|\[[^={}\])]*[\])]|\{[^={})]*[})]"
    r"|(?P<quote>[\"'])(?: [^\n]){0,3} (?P=quote)|[(\[{\"']|[^\n](?: [ief,])*+"
)
_VECTOR = r"[cV] = (?P<value>\([^={})]*\))"
_PARENTS = "a {0} has no '{1}': parents list their links and joints under 'children'"

HABITS = (
    Habit("parent = base", r"n(?: =)?(?P<value>[^\n=])?", words.relative,
          _PARENTS, "Remove '{2}'"),
    Habit("Ixx = 1.0", r"[^{}]+", words.foreign_words,
          title="Replace '{0}' with '{1}'", code="KD010"),
    Habit("Iyx = 0.0", r"[^{}]+", words.repeated_words,
          "'{0}' means '{1}', which is already given", "Remove '{2}'", code="KD009"),
    Habit("moments = 1.0, 1.0, 1.0, 0.0, 0.0, 0.0",
          rf"n = (?P<list>(?:[^\n{{}}P{_KEYWORD}](?! =) ){{1,58}})", values.obsolete_moments,
          "obsolete 'moments': write 'Ix', 'Iy', 'Iz', 'Ixy', 'Ixz', 'Iyz'",
          "Replace 'moments' by six assignments", is_safe=True, code="KD010"),
    Habit("ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }",
          r"\A[LB](?s:.)*", words.own_frame,
          "{0} '{1}' has a 'ref_frame', which only joints have", "Remove 'ref_frame'"),
    Habit("children { upper via }", r"C \{", words.half_children,
          "expected {0} after '{1}'"),
    Habit("mass = 1.0;", r"(?s:.)*;(?s:.)*", words.semicolons,
          "unexpected ';'", "Remove {0}", is_safe=True),
    Habit("# the upper arm", rf"= (?!#)(?:{_VALUE})|#(?P<words>[^\n={{}}(]+)(?=\n|\Z)",
          words.comment,
          "'#' does not begin a comment", "Write '//'", is_safe=True),
    Habit("CoM = (0.0", rf"[cV] = (?P<half>{_HALF})(?=\n| \}})", values.half_vector,
          "expected {0} after '{1}'", "Insert ')'"),
    Habit("CoM = Ix = 1.0", rf"[cV] =(?= (?:\}}|[{_KEYWORD}](?: [if,])* =))", values.no_vector,
          "expected a vector '(x, y, z)' after '='"),
    Habit('rotation = "0 0 1.57"',
          rf"[cV] = (?P<value>{_THREE})(?! \))", values.three_numbers,
          "expected a vector '(x, y, z)' instead of '{0}'", "Write '{1}'"),
    Habit("CoM = 0.0, 0.0, 0.1", r"[cV] = (?P<value>[fiep] , [if] , [if])(?! [if,)])",
          values.bare_components,
          "vector is not enclosed in '()'", "Insert '()'", is_safe=True),
    Habit("CoM = [0.0, 0.0, 0.1]",
          rf"[cV] = (?P<value>{_BRACKETED})", values.other_brackets,
          "vector is enclosed in '{0}{1}' instead of '()'", "Write '()'", is_safe=True),
    Habit("CoM = (0.0 0.0 0.1)", _VECTOR, values.lost_commas,
          "expected ',' after '{0}'", "Insert ','"),
    Habit("CoM = (0,5, 0.0, x-1.0)", rf"(?P<scalar>S )?= (?![{_KEYWORD}])(?P<value>{_VALUE})(?! =)",
          values.other_numbers),
    Habit("CoM = (0.0, 0.0, 0.1, 1.0)", _VECTOR, values.surplus_components,
          "vector has {0} components instead of 3", "Remove the surplus components"),
    Habit("CoM = (0.0, 0.1)", _VECTOR, values.lacking_components,
          "vector has {0} instead of 3"),
    Habit("mass", r"[{})fi]\n(?P<word>[cVSD])(?=\n| \})(?! [={vW])", words.half_section,
          "expected '=' after '{0}'"),
)  # fmt: skip
