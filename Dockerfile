# The linter for CI systems without Python: docker run --rm -v "$PWD:/models" kdsl-lint .
FROM python:3.12-slim AS build
WORKDIR /source
COPY pyproject.toml README.md LICENSE ./
COPY grammar grammar
COPY docs/rules docs/rules
COPY server server
RUN pip wheel --no-cache-dir --wheel-dir /wheels .

FROM python:3.12-slim
RUN --mount=type=bind,from=build,source=/wheels,target=/wheels \
    pip install --no-cache-dir --no-index --find-links=/wheels kindsl==0.1.0
USER 1000
WORKDIR /models
ENTRYPOINT ["kdsl-lint"]
CMD ["."]
