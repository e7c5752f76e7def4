"""`link_data_map.h` and `joint_data_map.h`: one item a link or joint."""

from kindsl.codegen.robcogen.robot import GeneratedRobot

_TEXT = """
namespace iit {
namespace @NS@ {

/** Holds one item for each @WHAT@. */
template <typename T>
class @CLASS@ {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW

    @CLASS@() {}
    @CLASS@(const T& defaultValue) { assign(defaultValue); }
    @CLASS@(const @CLASS@& rhs) { copy(rhs); }

    @CLASS@& operator=(const @CLASS@& rhs)
    {
        if (&rhs != this) {
            copy(rhs);
        }
        return *this;
    }
    @CLASS@& operator=(const T& rhs)
    {
        assign(rhs);
        return *this;
    }

    T& operator[](@ID@ which) { return data[which]; }
    const T& operator[](@ID@ which) const { return data[which]; }

private:
    void copy(const @CLASS@& rhs)
    {
        for (int i = 0; i < @COUNT@; i++) {
            data[i] = rhs.data[i];
        }
    }
    void assign(const T& value)
    {
        for (int i = 0; i < @COUNT@; i++) {
            data[i] = value;
        }
    }

    T data[@COUNT@];
};

template <typename T>
inline std::ostream& operator<<(std::ostream& out, const @CLASS@<T>& map)
{
    static const char* const names[] = {@NAMES@};
    for (int i = 0; i < @COUNT@; i++) {
        out << "   " << names[i] << " = " << map[@ORDERED@[i]];
    }
    return out;
}

}
}
"""


def data_maps(robot: GeneratedRobot) -> dict[str, str]:
    """Return both headers by their names."""
    library = robot.library.robot
    names = {"Link": (library.base_name, *library.link_names), "Joint": library.joint_names}
    return {f"{kind.lower()}_data_map.h": _header(robot, kind, names[kind]) for kind in names}


def _header(robot: GeneratedRobot, kind: str, names: tuple[str, ...]) -> str:
    body = robot.filled(
        _TEXT,
        WHAT=kind.lower(),
        CLASS=f"{kind}DataMap",
        ID=f"{kind}Identifiers",
        COUNT=f"{kind.lower()}sCount",
        ORDERED=f"ordered{kind}IDs",
        NAMES=", ".join(f'"{name}"' for name in names),
    )
    return robot.header(f"{kind.lower()}_data_map.h", ["<ostream>", '"declarations.h"'], body)
