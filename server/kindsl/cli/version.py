"""The version of what is installed."""


def version() -> str:
    """Return the version of the distribution, `unknown` where it is not installed."""
    from importlib.metadata import PackageNotFoundError
    from importlib.metadata import version as installed

    try:
        return installed("kindsl")
    except PackageNotFoundError:
        return "unknown"
