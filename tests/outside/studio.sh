#!/usr/bin/env bash
# The studio in a browser: every file of studio/tests/ named *_test.mjs, on the page that tools/build-studio made, from file:// with the network off.
# Skipped where page, chromium, node or the packages of studio/page are not there.
set -euo pipefail
export STUDIO=${STUDIO:-$SOURCE_DIR/build/studio/flexslip-studio.html} FLEXSLIP
skip() {
  echo "skipped: $1" >&2
  exit 77
}
[[ -f $STUDIO ]] || skip "no $STUDIO: tools/build-studio makes it"
command -v node > /dev/null || skip "no node"
command -v chromium > /dev/null || command -v chromium-browser > /dev/null || skip "no chromium: apt-get install --no-install-recommends chromium"
[[ -d $SOURCE_DIR/studio/page/node_modules/playwright-core ]] || skip "no playwright-core: npm ci in studio/page"
node --test "$SOURCE_DIR"/studio/tests/*_test.mjs
