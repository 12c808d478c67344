"""strainsite from outside: plan, run, plan again with the values so far, analyse."""

import csv
import io
import json
import subprocess

PARAMETERS = {"uniform": ("min", "max"), "normal": ("mean", "std"), "lognormal": ("mu", "sigma")}


def document(model, tolerance, seed):
    """The inputs' document."""
    text = f'[method]\nkind = "auto"\ntolerance = {tolerance!r}\nseed = {seed}\n'
    for i, (kind, *parameters) in enumerate(model.laws):
        values = ", ".join(f"{name} = {value!r}" for name, value in zip(PARAMETERS[kind], parameters))
        text += f'[[inputs]]\nname = "x{i + 1}"\ndistribution = {{ kind = "{kind}", {values} }}\n'
    return text


def auto(program, model, tolerance, seed, folder):
    """Runs until nothing more is asked for: number of runs, true and claimed error, the method that answered."""
    inputs, values = folder / "inputs.toml", folder / "values.csv"
    inputs.write_text(document(model, tolerance, seed))
    values.write_text("id,y\n")

    def call(*arguments):
        command = [program, "gsa", *arguments]
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(f"{' '.join(map(str, command))}: {done.stderr}")
        return done.stdout

    while rows := list(csv.reader(io.StringIO(call("plan", inputs, "--values", values))))[1:]:
        outputs = model.run([[float(x) for x in row[1:]] for row in rows])
        with open(values, "a") as file:
            file.writelines(f"{row[0]},{float(y)!r}\n" for row, y in zip(rows, outputs))
    answer = json.loads(call("analyse", inputs, values, "--json", "-"))
    output = answer["outputs"][0]
    return {
        "runs": answer["evaluations"],
        "error": model.error(output["first_order"]),
        "claimed": output["error"]["total"],
        "method": output["method"],
    }
