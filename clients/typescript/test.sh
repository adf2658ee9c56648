#!/usr/bin/env bash
# Runs the tests of a package that build.sh made. usage: test.sh FOLDER
set -euo pipefail
cd "$1"
if [ ! -e tedit-client.tgz ]; then
  echo "skipped: the package was left out, npm could not install what it needs"
  exit 77
fi
node --test dist-tests/tests/*.test.js
