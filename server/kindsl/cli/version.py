"""The version of what is installed."""


def version() -> str:
    """Return the version of the distribution, `unknown` where it is not installed."""
    import kindsl

    return str(kindsl.__version__)
