#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Installs the Debian or Ubuntu packages that building and testing need: scripts/packages.txt, and the lists named as
# arguments. Needs neither network nor rights when all of them are there.
set -euo pipefail
cd "$(dirname "$0")"
export LC_ALL=C

wanted=$(sed 's/#.*//' packages.txt "$@")
if ! command -v dpkg-query > /dev/null; then
  echo "setup: this is not Debian or Ubuntu; make sure that you have what these packages hold:" $wanted >&2
  exit 0
fi
missing=()
for package in $wanted; do
  dpkg-query -W -f '${db:Status-Status}\n' "$package" 2> /dev/null | grep -qx installed || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo > /dev/null || { echo "setup: become root, or install: ${missing[*]}" >&2; exit 1; }
  as_root=(sudo)
fi
echo "setup: installing ${missing[*]}" >&2
# No questions: time zones and the like keep their defaults. Locks of a running apt are waited for.
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -qq -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3)
"${apt[@]}" update
"${apt[@]}" install -y --no-install-recommends "${missing[@]}" > /dev/null
