"""The headers of parameters, and what other headers do with them."""

from collections.abc import Sequence

from kindsl.language.semantics.declarations import ValueKind
from kindsl.products.codegen.filling import template
from kindsl.products.codegen.robcogen.robot import GeneratedRobot

KINEMATIC = {"lengths": ValueKind.LENGTH, "angles": ValueKind.ANGLE}

_STRUCT = """\
struct @STRUCT@ {
@FIELDS@    void defaults() { *this = @STRUCT@(); }
};
"""

_GETTER = """\
class @GETTER@ {
public:
    virtual ~@GETTER@() {}
@METHODS@};
"""

_KINEMATICS = template("robcogen/kinematics_parameters.h")
_DYNAMICS = template("robcogen/dynamics_parameters.h")
_DEFAULT = template("robcogen/default_dynparams_getter.h")


def parameter_headers(robot: GeneratedRobot) -> dict[str, str]:
    """Return the headers by their names."""
    structs = "\n".join(_struct(robot, f"Params_{g}", kind) for g, kind in KINEMATIC.items())
    getters = "\n".join(_getter(robot, f"ParamsGetter_{g}", kind) for g, kind in KINEMATIC.items())
    defaults = "".join(_methods(robot, kind, f"{g}.@NAME@") for g, kind in KINEMATIC.items())
    of_inertia = _struct(robot, "RuntimeInertiaParams", ValueKind.DYNAMICS)
    getter = _getter(robot, "RuntimeParamsGetter", ValueKind.DYNAMICS)
    values = _methods(robot, ValueKind.DYNAMICS, "values.@NAME@")
    contents = {
        "kinematics_parameters.h": robot.filled(
            _KINEMATICS, STRUCTS=structs, GETTERS=getters, DEFAULTS=defaults
        ),
        "dynamics_parameters.h": robot.filled(_DYNAMICS, STRUCT=of_inertia, GETTER=getter),
        "default_dynparams_getter.h": robot.filled(_DEFAULT, METHODS=values),
    }
    includes = {"default_dynparams_getter.h": ["<Eigen/Core>", '"dynamics_parameters.h"']}
    return {
        name: robot.header(name, includes.get(name, ["<limits>"]), body)
        for name, body in contents.items()
    }


def names_of(robot: GeneratedRobot, kind: ValueKind) -> list[tuple[int, str]]:
    """Return place and name of the parameters of a class."""
    library = robot.library
    named = enumerate(library.parameter_names.items())
    return [(i, safe) for i, (name, safe) in named if kind in library.parameter_kinds[name]]


def groups(robot: GeneratedRobot) -> list[str]:
    """Return the classes of kinematic parameters that the robot has."""
    return [group for group, kind in KINEMATIC.items() if names_of(robot, kind)]


def parameter_array(robot: GeneratedRobot, indent: str) -> str:
    """Return the statement that lists all parameters; a transform reads kinematic ones."""
    texts = ["Scalar(0)"] * len(robot.library.robot.parameters)
    for group, kind in KINEMATIC.items():
        for place, name in names_of(robot, kind):
            texts[place] = f"Scalar({group}_values.{name})"
    return f"{indent}const Scalar p[] = {{{', '.join(texts)}}};\n"


def parameters_of_class(robot: GeneratedRobot) -> str:
    """Return the members in which a transform keeps parameters."""
    return "".join(f"        Params_{group} {group}_values;\n" for group in groups(robot))


def setters(robot: GeneratedRobot, name: str, dependent: Sequence[str]) -> tuple[str, str]:
    """Return how a container gets parameters, and the members that keep them.

    Args:
        robot: The robot.
        name: The container's class.
        dependent: Its members that depend on parameters.
    """
    given = groups(robot)
    both = "const Params_lengths&@L@, const Params_angles&@A@"
    if not given:
        takes = both.replace("@L@", "").replace("@A@", "")
        return (
            f"    {name}() {{}}\n    void updateParameters() {{}}\n"
            f"    void updateParameters({takes}) {{}}\n    void updateParams({takes}) {{}}\n"
            + ("    void parameters(Scalar*) const {}\n" if robot.has_parameters else ""),
            "",
        )
    getters = ", ".join(f"const ParamsGetter_{g}& {g}" for g in given)
    initial = ", ".join(f"valuesGetter_{g}(&{g})" for g in given)
    none = ", ".join(f"valuesGetter_{g}(nullptr)" for g in given)
    read = "".join(_read(robot, group) for group in given)
    takes = both.replace("@L@", " lengths").replace("@A@", " angles")
    unused = "".join(f"        (void){g};\n" for g in KINEMATIC if g not in given)
    kept = "".join(f"        values_{g} = {g};\n" for g in given)
    handed = "".join(f"        {m}.{g}_values = values_{g};\n" for m in dependent for g in given)
    listed = "".join(
        f"        p[{place}] = Scalar(values_{g}.{field});\n"
        for g in given
        for place, field in names_of(robot, KINEMATIC[g])
    )
    construction = f"""\
    /** With the values that parameters had when this was generated; NaN where they had none. */
    {name}() : {none} {{}}
    explicit {name}({getters}) : {initial} {{ updateParameters(); }}
    /** Asks for the values again; matrices change when they are updated next. */
    void updateParameters()
    {{
{read}        handOn();
    }}
    void updateParameters({takes})
    {{
{unused}{kept}        handOn();
    }}
    void updateParams({takes}) {{ updateParameters(lengths, angles); }}
    /** Fills in the kinematic ones of all parameters. */
    void parameters(Scalar* p) const
    {{
{listed}    }}
"""
    values = "".join(
        f"    Params_{g} values_{g};\n    const ParamsGetter_{g}* valuesGetter_{g};\n"
        for g in given
    )
    return construction, f"\nprivate:\n    void handOn()\n    {{\n{handed}    }}\n\n{values}"


def _read(robot: GeneratedRobot, group: str) -> str:
    lines = "".join(
        f"            values_{group}.{name} = valuesGetter_{group}->getValue_{name}();\n"
        for _, name in names_of(robot, KINEMATIC[group])
    )
    return f"        if (valuesGetter_{group} != nullptr) {{\n{lines}        }}\n"


def _struct(robot: GeneratedRobot, name: str, kind: ValueKind) -> str:
    defaults = list(robot.library.defaults.values())
    texts = ["std::numeric_limits<double>::quiet_NaN()" if v is None else repr(v) for v in defaults]
    fields = [f"    double {field} = {texts[place]};\n" for place, field in names_of(robot, kind)]
    return robot.filled(_STRUCT, STRUCT=name, FIELDS="".join(fields))


def _getter(robot: GeneratedRobot, name: str, kind: ValueKind) -> str:
    methods = "".join(
        f"    virtual double getValue_{field}() const = 0;\n" for _, field in names_of(robot, kind)
    )
    return robot.filled(_GETTER, GETTER=name, METHODS=methods)


def _methods(robot: GeneratedRobot, kind: ValueKind, place: str) -> str:
    return "".join(
        f"    double getValue_{field}() const override\n"
        f"    {{\n        return {place.replace('@NAME@', field)};\n    }}\n"
        for _, field in names_of(robot, kind)
    )
