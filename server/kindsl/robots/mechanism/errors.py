"""Reasons why a document gives no mechanism."""

from kindsl.language.semantics.places import Located


class ModelError(ValueError):
    """The document does not describe a kinematic tree.

    Attributes:
        at: The place that is to blame, None where there is none.
    """

    def __init__(self, message: str, at: Located | None = None) -> None:
        super().__init__(message)
        self.at = at


class UnboundParameterError(ModelError):
    """Parameters have no value.

    Attributes:
        names: The parameters, in the order of the document.
    """

    def __init__(self, names: tuple[str, ...], at: Located | None = None) -> None:
        listed = ", ".join(f"'{name}'" for name in names)
        plural = "s" if len(names) > 1 else ""
        super().__init__(f"no value for the parameter{plural} {listed}", at)
        self.names = names


class UndecidedValueError(ModelError):
    """A value has two meanings, and no target decides which is meant."""

    def __init__(self, owner: str, what: str, text: str, at: Located) -> None:
        message = (
            f"{owner}: '{what}' has two meanings: robcogen2 reads '{text}' as a number, robcogen as"
            " a product with a parameter; set 'target' in kindsl.toml to one of them"
        )
        super().__init__(message, at)


class ParameterValueError(ValueError):
    """A value was given to a parameter that the document does not have, or that cannot be one.

    Attributes:
        name: The parameter.
    """

    def __init__(self, message: str, name: str) -> None:
        super().__init__(message)
        self.name = name
