# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Utilities/demo.sh refuses arguments that make no sense, before it does anything."""
import os
import subprocess
import sys

import scripttest


def run(*arguments, **variables):
    environment = {k: v for k, v in os.environ.items() if k != "DISPLAY"}
    result = subprocess.run(["bash", sys.argv[1], *arguments], env=dict(environment, **variables),
                            capture_output=True, text=True, timeout=60)
    return result.returncode, result.stdout, result.stderr


code, output, _ = run("--help")
scripttest.check(code == 0 and "usage:" in output, "--help")
for arguments, word in [
    (["a", "b"], "'b'"),
    ([""], "''"),
    (["--nonsense"], "'--nonsense'"),
    (["--data"], "--data needs a value"),
    (["--data", "x.vti"], "--data needs --state"),
    (["--state", "x.tfc.json"], "--state needs --data"),
    (["--radius", "3"], "need --data"),
    (["--data", "x.vti", "--state", "x.tfc.json", "--radius", "0"], "--radius"),
    (["--data", "x.vti", "--state", "x.tfc.json", "--eta", "-1"], "--eta"),
]:
    code, output, errors = run(*arguments)
    scripttest.check(code == 2 and word in errors and "usage:" in errors and not output,
                     "%s: %s" % (" ".join(arguments), errors.split("\n")[0]))
code, _, errors = run("--data", "no.vti", "--state", "no.tfc.json")
scripttest.check(code == 1 and "no.vti: no such file" in errors, errors.strip())
code, _, errors = run("--gui")
scripttest.check(code == 1 and "DISPLAY" in errors, errors.strip())
