"""Refusals that the user should read."""

from pygls.exceptions import JsonRpcException

_REQUEST_FAILED = -32803


class RequestFailed(JsonRpcException):
    """A request that makes sense to the protocol but not to the document; says why."""

    def __init__(self, message: str) -> None:
        super().__init__(message, _REQUEST_FAILED)
