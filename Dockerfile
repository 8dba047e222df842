# tremolo on a bare Debian 12, by the README's two commands.
#
#   docker build --target test .                        the whole test suite
#   docker build --target demo -t tremolo .             builds and runs the demo: /tremolo/runs/demo in the image
#   docker run --rm -v "$PWD":/work tremolo run my_slope/case.toml --report
FROM debian:12 AS source
WORKDIR /tremolo
COPY . .

FROM source AS test
RUN scripts/test.sh

FROM source AS demo
RUN scripts/demo.sh
ENV PATH=/tremolo/build/release/bin:$PATH
WORKDIR /work
ENTRYPOINT ["tremolo"]
