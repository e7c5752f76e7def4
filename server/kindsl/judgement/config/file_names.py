"""Names of configuration files and of the documents beside robots."""

OWN_FILE = "kindsl.toml"
PYTHON_FILE = "pyproject.toml"
# Where our keys are in the latter.
PYTHON_TABLE = ("tool", "kindsl")
TRANSFORMS_SUFFIX = ".dtdsl"
