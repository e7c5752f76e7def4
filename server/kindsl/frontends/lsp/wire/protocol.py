"""The message loop's rules: life cycle, errors and cancellation as the specification has them.

pygls leaves a few of them open. Here a request always gets exactly one answer: invalid parameters
-32602, before `initialize` -32002, after `shutdown` -32600, cancelled -32800, our own fault -32603
with one clean sentence. What went wrong inside is logged, never shown in a box.
"""

import asyncio
import contextlib
import contextvars
import inspect
import json
import logging
import math
from collections.abc import Callable
from concurrent.futures import Future, InvalidStateError
from typing import Any, NamedTuple, TypeVar

from cattrs import Converter, transform_error
from lsprotocol import types
from pygls.exceptions import (
    JsonRpcException,
    JsonRpcInternalError,
    JsonRpcInvalidParams,
    JsonRpcInvalidRequest,
    JsonRpcParseError,
    JsonRpcRequestCancelled,
    JsonRpcServerNotInitialized,
)
from pygls.lsp.server import LanguageServer
from pygls.protocol import LanguageServerProtocol, lsp_method

import kindsl
from kindsl.frontends.lsp.text.open_documents import Documents
from kindsl.frontends.lsp.wire.client import Client

logger = logging.getLogger(__name__)

T = TypeVar("T")

_REQUEST_FAILED = -32803


class Encoded(NamedTuple):
    """A result that is JSON already, made where it does not keep the message loop waiting."""

    json: str


class KindslProtocol(LanguageServerProtocol):
    """Answers messages; keeps pygls' registry, types and capabilities."""

    is_initialized = False

    def __init__(self, server: LanguageServer, converter: Converter) -> None:
        super().__init__(server, converter)
        self.documents = Documents()

    @property
    def exit_code(self) -> int:
        """The exit status of the process: 0 only after `shutdown`."""
        return 0 if self._shutdown else 1

    def receive(self, body: bytes) -> bool:
        """Handle one message; say whether to go on reading."""
        try:
            data = json.loads(body)
        except (ValueError, RecursionError):
            self._refuse(None, JsonRpcParseError("the message is not JSON"))
            return True
        try:
            self._receive(data)
        except Exception:
            logger.exception("a message could not be handled")
        return not (isinstance(data, dict) and data.get("method") == types.EXIT)

    def _receive(self, data: Any) -> None:
        if not isinstance(data, dict) or data.get("jsonrpc") != self.VERSION:
            self._refuse(None, JsonRpcInvalidRequest("the message is not a JSON-RPC 2.0 object"))
        elif "id" in data and not _is_id(data["id"]):
            self._refuse_id(data)
        elif isinstance(data.get("method"), str):
            self._receive_call(data)
        elif "id" in data and ("result" in data or "error" in data):
            self._receive_response(data)
        else:
            self._refuse(
                None, JsonRpcInvalidRequest("the message is neither a request nor a response")
            )

    def _refuse_id(self, data: dict[str, Any]) -> None:
        """Refuse a request with an id that no answer can carry; an answer is not answered."""
        if "method" in data:
            self._refuse(None, JsonRpcInvalidRequest("the request's id is not a number or string"))
        else:
            logger.warning("an answer without a matching request was ignored")

    def _receive_call(self, data: dict[str, Any]) -> None:
        method = data["method"]
        try:
            self._check_life_cycle(method)
            params = self._structured_params(data)
        except JsonRpcException as error:
            if "id" in data:
                self._refuse(data["id"], error)
            else:
                logger.warning("notification %s was ignored: %s", method, error)
            return
        handle = self._handle_request if "id" in data else self._handle_notification
        arguments = (data["id"], method, params) if "id" in data else (method, params)
        contextvars.copy_context().run(handle, *arguments)

    def _check_life_cycle(self, method: str) -> None:
        if method == types.EXIT:
            return
        if self._shutdown:
            raise JsonRpcInvalidRequest("the server has been shut down")
        if method == types.INITIALIZE and self.is_initialized:
            raise JsonRpcInvalidRequest("the server is already initialized")
        if method != types.INITIALIZE and not self.is_initialized:
            raise JsonRpcServerNotInitialized("the server is not initialized yet")

    def _structured_params(self, data: dict[str, Any]) -> Any:
        known = self.get_message_type(data["method"])
        if known is None:
            return data.get("params")
        try:
            return getattr(self._converter.structure(data, known), "params", None)
        except Exception as error:
            reason = "; ".join(transform_error(error, path="message"))
            raise JsonRpcInvalidParams(f"invalid {data['method']}: {reason}") from None

    def _receive_response(self, data: dict[str, Any]) -> None:
        try:
            message = super().structure_message(data)
        except JsonRpcException as error:
            logger.warning("the client's answer to %s is malformed", data["id"])
            self._handle_response(data["id"], error=error.to_response_error())
        else:
            result, refusal = getattr(message, "result", None), getattr(message, "error", None)
            with contextlib.suppress(InvalidStateError):  # given up meanwhile
                self._handle_response(message.id, result, refusal)

    def _refuse(self, msg_id: Any, error: JsonRpcException) -> None:
        body = {"code": error.code, "message": error.message}
        if error.data is not None:
            body["data"] = error.data
        self._send_data({"jsonrpc": self.VERSION, "id": msg_id, "error": body})

    def _execute_handler(
        self,
        msg_id: Any,
        handler: Callable[..., Any],
        callback: Callable[[Any], None],
        args: tuple[Any, ...] | None = None,
        kwargs: dict[str, Any] | None = None,
    ) -> None:
        """Run a handler; what it returns may be awaitable.

        A handler is called at once, so that it sees the documents as they were when the message
        came. What it awaits starts after the messages that wait already, cancellations among
        them, have been read.
        """
        if inspect.isgeneratorfunction(handler):
            super()._execute_handler(msg_id, handler, callback, args, kwargs)
            return
        future: Any = Future()
        try:
            result = handler(*(args or ()), **(kwargs or {}))
            if inspect.isawaitable(result):
                future = asyncio.ensure_future(result)
                self._request_futures[msg_id] = future
            else:
                future.set_result(result)
        except Exception as error:
            future.set_exception(error)
        future.add_done_callback(callback)

    def _send_handler_result(self, future: Any, *, msg_id: Any) -> None:
        self._request_futures.pop(msg_id, None)
        if future.cancelled():
            self._refuse(msg_id, JsonRpcRequestCancelled("the request was cancelled"))
        elif (error := future.exception()) is None:
            self._send_result(msg_id, future.result())
        elif isinstance(error, JsonRpcException):
            self._refuse(msg_id, error)
        else:
            logger.error("a request failed", exc_info=error)
            self._refuse(msg_id, JsonRpcInternalError(f"internal error: {_sentence(error)}"))

    def _send_result(self, msg_id: Any, result: Any) -> None:
        try:
            answer = self.encoded(result).json
            self._send_text(f'{{"jsonrpc":"2.0","id":{json.dumps(msg_id)},"result":{answer}}}')
        except (TypeError, ValueError) as error:
            logger.error("a result cannot be sent", exc_info=error)
            self._refuse(msg_id, JsonRpcInternalError(f"internal error: {_sentence(error)}"))

    def encoded(self, result: Any) -> "Encoded":
        """Return a result as JSON that every client reads, so without NaN; from any thread."""
        if isinstance(result, Encoded):
            return result
        encode = self._serialize_message
        return Encoded(json.dumps(result, default=encode, separators=(",", ":"), allow_nan=False))

    def structured(self, data: dict[str, Any], type_: type[T]) -> T:
        """Return what is in the protocol's form as one of its types."""
        return self._converter.structure(data, type_)

    def notify_encoded(self, method: str, params: Encoded) -> None:
        """Send a notification whose parameters are JSON already."""
        self._send_text(f'{{"jsonrpc":"2.0","method":"{method}","params":{params.json}}}')

    def _send_data(self, data: Any) -> None:
        self._send_text(self.encoded(data).json)

    def _send_text(self, text: str) -> None:
        body = text.encode("ascii")
        if self.writer is not None:
            self.writer.write(b"Content-Length: %d\r\n\r\n%b" % (len(body), body))

    def _check_handler_result(self, future: Any) -> None:
        error = None if future.cancelled() else future.exception()
        if isinstance(error, JsonRpcException):
            logger.warning("a notification was ignored: %s", error)
        elif error is not None:
            logger.error("a notification failed", exc_info=error)

    def _handle_request(self, msg_id: Any, method_name: str, params: Any) -> None:
        try:
            handler = self._get_handler(method_name)
        except JsonRpcException:
            self._refuse(msg_id, JsonRpcException(f"unknown method '{method_name}'", -32601))
            return
        self._ctx_msg_id.set(msg_id)
        callback = lambda future: self._send_handler_result(future, msg_id=msg_id)  # noqa: E731
        self._execute_handler(msg_id, handler, callback, args=(params,))

    def _handle_cancel_notification(self, msg_id: Any) -> None:
        future = self._request_futures.get(msg_id) if _is_id(msg_id) else None
        if future is not None:
            future.cancel()

    @lsp_method(types.INITIALIZE)
    def lsp_initialize(self, params: types.InitializeParams) -> Any:
        """Agree on capabilities."""
        self.is_initialized = True
        result = yield from super().lsp_initialize(params)
        if not Client(params.capabilities, None).is_invited_to_pull:
            result.capabilities.diagnostic_provider = None
        return result

    @lsp_method(types.SHUTDOWN)
    def lsp_shutdown(self, *_: object) -> None:  # type: ignore[override]
        """Cancel what runs; only `exit` is listened to from now on."""
        for future in tuple(self._request_futures.values()):
            future.cancel()
        self._shutdown = True

    async def settle(self) -> None:
        """Answer what `shutdown` cancelled; editors wait two seconds before they kill a server."""
        futures: Any = self._request_futures.values() if self._shutdown else ()
        if cancelled := [future for future in futures if asyncio.isfuture(future)]:
            await asyncio.wait(cancelled, timeout=1.0)

    @lsp_method(types.WORKSPACE_EXECUTE_COMMAND)
    def lsp_workspace__execute_command(self, params: types.ExecuteCommandParams) -> Any:
        """Run a command with its arguments as they came."""
        command = self.fm.commands.get(params.command)
        if command is None:
            raise JsonRpcInvalidParams(f"unknown command '{params.command}'")
        return command(*(params.arguments or ()))

    @lsp_method(types.EXIT)
    def lsp_exit(self, *_: object) -> None:  # type: ignore[override]
        """End; the message loop stops after this message."""

    @lsp_method(types.TEXT_DOCUMENT_DID_OPEN)
    def lsp_text_document__did_open(self, params: types.DidOpenTextDocumentParams) -> None:
        """Keep the text that the editor shows."""
        self.documents.open(params.text_document)

    @lsp_method(types.TEXT_DOCUMENT_DID_CHANGE)
    def lsp_text_document__did_change(self, params: types.DidChangeTextDocumentParams) -> None:
        """Follow the editor's changes."""
        self.documents.change(params)

    @lsp_method(types.TEXT_DOCUMENT_DID_CLOSE)
    def lsp_text_document__did_close(self, params: types.DidCloseTextDocumentParams) -> None:
        """Forget the text that the editor showed."""
        self.documents.close(params.text_document.uri)


class Editor(LanguageServer):
    """pygls' server with our protocol."""

    protocol: KindslProtocol

    def __init__(self) -> None:
        super().__init__(
            "kindsl",
            kindsl.__version__,
            types.TextDocumentSyncKind.Incremental,
            protocol_cls=KindslProtocol,
        )

    def report_server_error(self, error: Exception, source: Any) -> None:
        """Leave it at the log; a fault of ours never becomes a message box."""


def _is_id(value: object) -> bool:
    if isinstance(value, float):
        return math.isfinite(value)
    return isinstance(value, str | int) and not isinstance(value, bool)


def _sentence(error: BaseException) -> str:
    lines = str(error).splitlines()
    return lines[0] if lines else type(error).__name__


class RequestFailed(JsonRpcException):
    """A request that makes sense to the protocol but not to the document; says why."""

    def __init__(self, message: str, data: dict[str, Any] | None = None) -> None:
        super().__init__(message, _REQUEST_FAILED, data)
