#!/usr/bin/env bash
# outside: the shipped example is, byte for byte, what tools/make-example writes.
"$SOURCE_DIR/tools/make-surface" --check || exit 1
exec "$SOURCE_DIR/tools/make-example" "$FLEXSLIP" --check
