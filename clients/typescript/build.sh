#!/usr/bin/env bash
# Puts the package together: FOLDER/tedit-client.tgz for npm install, and its tests.
# usage: build.sh PROTOCOL FOLDER
# Where npm cannot install what the package needs (no network), that is said and the package is left out until the next
# build; the exit status is 0 all the same: whoever wants TEdit alone needs none of it.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
protocol=$1
folder=$2
mkdir -p "$folder"
cd "$folder"
rm -rf tedit-client.tgz src tests dist dist-tests
same() { cmp -s "$here/package-lock.json" package-lock.json && [ -e node_modules/.package-lock.json ]; }
same || rm -rf node_modules
cp -r "$here"/{package.json,package-lock.json,.npmrc,tsconfig.json,generate.mjs,README.md,src,tests} .
rm -rf src/gen
if [ ! -d node_modules ] && ! timeout 180 npm ci --loglevel=error >npm.log 2>&1; then
  tail -n 5 npm.log >&2
  echo "The TypeScript client is left out: npm could not install what it needs ($folder/npm.log)." >&2
  rm -rf node_modules package-lock.json
  exit 0
fi
node generate.mjs "$protocol"
npx tsc -p .
npx tsc -p tests
npm pack --silent >packed
mv "$(tail -n 1 packed)" tedit-client.tgz
