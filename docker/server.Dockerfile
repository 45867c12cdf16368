# dualarm-server, and the client for health checks. From the project's root:
#   buildah bud --format docker -t dualarm-server --build-arg REVISION="$(git describe --tags --always --dirty)" \
#       -f docker/server.Dockerfile .
ARG BASE=debian:bookworm-slim

FROM ${BASE} AS build
COPY scripts/setup.sh /src/scripts/setup.sh
RUN /src/scripts/setup.sh
COPY . /src
WORKDIR /src
ARG REVISION=unknown
RUN cmake --preset release -DDUALARM_BUILD_TESTS=OFF -DDUALARM_GIT_DESCRIPTION="$REVISION" \
    && cmake --build --preset release --parallel "$(nproc)" --target dualarm dualarm-server
# The packages whose libraries the two programs load, whatever this base calls them.
RUN ldd build/release/bin/dualarm build/release/bin/dualarm-server \
    | awk '$3 ~ /^\// {print $3}' | sort -u | xargs -n 1 realpath | xargs -n 1 basename | sed 's,^,*/,' \
    | xargs dpkg-query --search | cut -d : -f 1 | sort -u > /runtime-packages

FROM ${BASE}
COPY --from=build /runtime-packages /runtime-packages
RUN apt-get -q update \
    && DEBIAN_FRONTEND=noninteractive xargs -a /runtime-packages apt-get -q install -y --no-install-recommends \
    && rm -rf /var/lib/apt/lists/* \
    && useradd --system --uid 10001 --no-create-home --shell /usr/sbin/nologin dualarm
COPY --from=build /src/build/release/bin/dualarm /src/build/release/bin/dualarm-server /usr/local/bin/
USER 10001
EXPOSE 50051
# Plaintext beyond loopback: inside a container, where the port is published on purpose.
ENV DUALARM_LISTEN=0.0.0.0:50051 DUALARM_ALLOW_INSECURE_REMOTE=true
HEALTHCHECK --interval=10s --timeout=3s --start-period=5s CMD ["dualarm", "health", "--server", "127.0.0.1:50051"]
ENTRYPOINT ["dualarm-server"]
