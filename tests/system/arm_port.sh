# shellcheck shell=bash
# arm_port.sh, read by the tests that start the arm's side; they have a `fail` that ends them with a sentence.

# await_arm LOG: until the arm that writes LOG says where it waits; then $port is there.
await_arm() {
    port=
    for _ in $(seq 100); do
        port=$(sed -n 's/.* waits at 127[.]0[.]0[.]1:\([0-9]*\)[.].*/\1/p' "$1" 2>/dev/null) || true
        [[ -n $port ]] && return
        sleep 0.1
    done
    fail "the arm does not say where it waits"
}
