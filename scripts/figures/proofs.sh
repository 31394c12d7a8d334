#!/usr/bin/env bash
# The formal proofs: how many hold, and how long they take together.
set -euo pipefail
wanted=$(grep -c '^[a-z]' tb/rtl/formal/proofs.txt)
started=$SECONDS
proved=$(./scripts/proofs.sh | grep -c $'\tproved\t' || true)
seconds=$((SECONDS - started))
printf 'proofs.proved\t%d\t= %d\t%s\n' "$proved" "$wanted" "$([ "$proved" = "$wanted" ] && echo ok || echo short)"
printf 'proofs.seconds\t%d\t<= 600\t%s\n' "$seconds" "$([ "$seconds" -le 600 ] && echo ok || echo short)"
