"""The one error of tools."""


class ToolError(Exception):
    """A tool cannot do what it was asked; the message is one sentence that says what is right."""
