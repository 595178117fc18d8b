# SPDX-License-Identifier: MIT
# docs/developing.md says how to build and use it. `./dev package --container` runs these steps without Docker.
FROM debian:12-slim AS build
WORKDIR /fantail
# The list of packages alone: as long as it stays, they need not be installed again.
COPY dev ./
COPY tools/dev tools/dev
RUN apt-get update && ./dev packages package | xargs apt-get install -y --no-install-recommends
COPY . .
RUN ./dev package

FROM debian:12-slim
COPY --from=build /fantail/build/packages/*.deb /tmp/
RUN apt-get update && apt-get install -y --no-install-recommends /tmp/fantail_*.deb && rm -rf /tmp/*.deb /var/lib/apt/lists/*
RUN useradd --home-dir /flights --create-home fantail
USER fantail
WORKDIR /flights
ENTRYPOINT ["fantail"]
CMD ["--help"]
