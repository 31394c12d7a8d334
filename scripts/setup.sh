#!/usr/bin/env bash
# Installs what Floorline needs on Debian 12: packages.txt from Debian, requirements.txt from PyPI into .venv.
# Does nothing, quickly, where all of it is there.
source "$(dirname "$0")/common.sh"

missing=()
while read -r package; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
done < <(grep -v '^#' scripts/packages.txt)

if [ ${#missing[@]} -gt 0 ]; then
    command -v apt-get >/dev/null || fail "these packages are missing and there is no apt-get to install them: ${missing[*]}"
    as_root=()
    if [ "$(id -u)" != 0 ]; then
        command -v sudo >/dev/null || fail "run as root, or install sudo: these packages are missing: ${missing[*]}"
        as_root=(sudo)
    fi
    say "installing ${#missing[@]} Debian packages"
    export DEBIAN_FRONTEND=noninteractive
    "${as_root[@]}" apt-get update -qq || fail "apt-get update failed, and these packages are missing: ${missing[*]}; check the network and /etc/apt/sources.list."
    "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >setup-apt.log 2>&1 ||
        { tail -n 20 setup-apt.log >&2; fail "apt-get could not install the packages above; Floorline needs Debian 12 (bookworm)."; }
    rm -f setup-apt.log
fi

if ! cmp -s scripts/requirements.txt .venv/requirements.txt; then
    say "installing Python packages into .venv"
    /usr/bin/python3 -m venv .venv || fail "python3 -m venv failed; is the package python3-venv installed?"
    .venv/bin/pip install -q --disable-pip-version-check -r scripts/requirements.txt ||
        fail "pip could not install these packages: $(grep -v '^#' scripts/requirements.txt | paste -sd ' '); check the network to PyPI."
    cp scripts/requirements.txt .venv/requirements.txt
fi
say "setup complete"
