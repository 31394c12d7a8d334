#!/usr/bin/env bash
# The formal proofs: how many hold, and how long they take together.
source "$(dirname "$0")/../common.sh"

wanted=$(grep -c '^[a-z]' tb/rtl/formal/proofs.txt)
started=$SECONDS
proved=$(./scripts/proofs.sh | grep -c $'\tproved\t' || true)
seconds=$((SECONDS - started))
figure proofs.proved "$proved" = "$wanted"
figure proofs.seconds "$seconds" '<=' 600
