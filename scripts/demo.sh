#!/usr/bin/env bash
# Install what is missing, build, start dualarm-server on a free loopback port, plan every scenario through gRPC:
# a table on stdout, a drawing of each plan in demo-out/. The last line says whether all went well.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
bin=build/release/bin

scripts/setup.sh
cmake --preset release
cmake --build --preset release --parallel "$(nproc)" --target dualarm dualarm-server

work=$(mktemp -d)
server=
stop_server() {
  if [[ -n $server ]]; then
    kill "$server" 2>/dev/null || true
    wait "$server" || true
  fi
  rm -rf "$work"
}
trap stop_server EXIT

"$bin/dualarm-server" --listen 127.0.0.1:0 --port-file "$work/port" >"$work/log" 2>&1 &
server=$!
for ((tries = 0; tries < 100; ++tries)); do
  [[ -s $work/port ]] && break
  kill -0 "$server" 2>/dev/null || break
  sleep 0.1
done
if [[ ! -s $work/port ]]; then
  cat "$work/log" >&2
  echo "demo: FAILED, the server did not start" >&2
  exit 1
fi
address=127.0.0.1:$(<"$work/port")

echo
echo "dualarm-server listens on $address; planning every scenario through gRPC"
echo
mkdir -p demo-out
if "$bin/dualarm" plan scenarios/*.json --server "$address" --table --svg-folder demo-out; then
  echo
  echo "demo: OK, every scenario is planned and verified; drawings in $PWD/demo-out"
else
  status=$?
  echo
  echo "demo: FAILED, see the table above" >&2
  exit "$status"
fi
