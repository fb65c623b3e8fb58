#!/usr/bin/env bash
# Every block of shell in the pages is one that bash can read: shell_blocks.bash PAGE...
set -u

# The lines between ```sh and ``` of the file named, or of standard input; a zero ends each block.
blocks() { awk '/^```sh$/ { on = 1; next } /^```$/ { if (on) printf "%c", 0; on = 0 } on' "$@"; }

# The planted fault: a block with a quote that nobody closes is not readable.
if printf '```sh\nsrun "reflectance\n```\n' | blocks | tr -d '\0' | bash -n 2>/dev/null; then
    echo "a broken block passed, so this test finds nothing" >&2
    exit 1
fi

count=0
for page in "$@"; do
    while IFS= read -r -d '' block; do
        count=$((count + 1))
        if ! bash -n <<<"$block"; then
            echo "$page: bash cannot read this:" >&2
            echo "$block" >&2
            exit 1
        fi
    done < <(blocks "$page")
done
[ "$count" -gt 0 ] || { echo "no block was found" >&2; exit 1; }
