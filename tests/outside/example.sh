#!/usr/bin/env bash
# outside: the shipped example is, byte for byte, what tools/make-example writes.
exec "$SOURCE_DIR/tools/make-example" "$FLEXSLIP" --check
