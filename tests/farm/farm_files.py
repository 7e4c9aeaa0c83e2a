"""What the files of reference/farm for other engines must have: farm_files.py KUBERNETES ARGO NEXTFLOW.

Debian has no schema of Kubernetes or Argo. This checks what their API servers refuse: the kind and its version, the
required fields of each object, and no field that the kind does not have. Of the step for Nextflow it checks the parts of
a process. Of all three, that they start softgl with options that it has, see farm_test.cpp.
"""
import re
import sys

import yaml

# Fields by path; * stands for items of a list. True: required.
CONTAINER = {"name": True, "image": True, "command": False, "args": False, "workingDir": False, "resources": False,
             "volumeMounts": False}
RESOURCES = {"requests": False, "limits": False}
MOUNT = {"name": True, "mountPath": True, "readOnly": False}
VOLUME = {"name": True, "persistentVolumeClaim": True}
CLAIM = {"claimName": True}
KUBERNETES = {
    "": {"apiVersion": True, "kind": True, "metadata": True, "spec": True},
    "metadata": {"name": True, "labels": False},
    "spec": {"completions": True, "parallelism": False, "completionMode": True, "backoffLimit": False, "template": True},
    "spec.template": {"spec": True, "metadata": False},
    "spec.template.spec": {"restartPolicy": True, "terminationGracePeriodSeconds": False, "containers": True,
                           "volumes": False},
    "spec.template.spec.containers.*": CONTAINER,
    "spec.template.spec.containers.*.resources": RESOURCES,
    "spec.template.spec.containers.*.volumeMounts.*": MOUNT,
    "spec.template.spec.volumes.*": VOLUME,
    "spec.template.spec.volumes.*.persistentVolumeClaim": CLAIM,
}
ARGO = {
    "": {"apiVersion": True, "kind": True, "metadata": True, "spec": True},
    "metadata": {"name": False, "generateName": False},
    "spec": {"entrypoint": True, "arguments": False, "templates": True, "volumes": False},
    "spec.arguments.parameters.*": {"name": True, "value": False},
    "spec.volumes.*": VOLUME,
    "spec.volumes.*.persistentVolumeClaim": CLAIM,
    "spec.templates.*": {"name": True, "inputs": False, "steps": False, "container": False, "retryStrategy": False},
    "spec.templates.*.steps.*.*": {"name": True, "template": True, "arguments": False, "withSequence": False},
    "spec.templates.*.steps.*.*.withSequence": {"start": False, "count": False, "end": False},
    "spec.templates.*.retryStrategy": {"limit": False, "retryPolicy": False},
    "spec.templates.*.container": {**CONTAINER, "name": False},
    "spec.templates.*.container.resources": RESOURCES,
    "spec.templates.*.container.volumeMounts.*": MOUNT,
}


def at(value, path):
    """All values at a path."""
    values = [value]
    for step in path.split(".") if path else []:
        values = [found for each in values for found in (each if step == "*" else [each.get(step)]) if found is not None]
    return values


def check(file, kind, version, table):
    with open(file, encoding="utf8") as text:
        document = yaml.safe_load(text)
    assert document["kind"] == kind and document["apiVersion"] == version, f"{file}: kind or version"
    for path, fields in table.items():
        for value in at(document, path):
            missing = [name for name, required in fields.items() if required and name not in value]
            unknown = [name for name in value if name not in fields]
            assert not missing and not unknown, f"{file}: {path}: missing {missing}, unknown {unknown}"
    return document


def words_of(container):
    return " ".join([*container.get("command", []), *container.get("args", [])])


def main():
    kubernetes, argo, nextflow = sys.argv[1:]
    job = check(kubernetes, "Job", "batch/v1", KUBERNETES)["spec"]
    pod = job["template"]["spec"]
    assert job["completionMode"] == "Indexed" and pod["restartPolicy"] in ("Never", "OnFailure")
    commands = [words_of(container) for container in pod["containers"]]
    assert f"--shard kubernetes/{job['completions']}" in commands[0], "the shards are not the completions"
    mounts = at(pod, "containers.*.volumeMounts.*.name")
    assert set(mounts) == set(at(pod, "volumes.*.name")), "mounts without volumes"

    workflow = check(argo, "Workflow", "argoproj.io/v1alpha1", ARGO)["spec"]
    templates = {template["name"]: template for template in workflow["templates"]}
    steps = at(workflow, "templates.*.steps.*.*")
    assert workflow["entrypoint"] in templates and all(step["template"] in templates for step in steps)
    commands += [words_of(each) for each in at(workflow, "templates.*.container")]
    known = {f"workflow.parameters.{name}" for name in at(workflow, "arguments.parameters.*.name")}
    known |= {f"inputs.parameters.{name}" for name in at(workflow, "templates.*.inputs.parameters.*.name")} | {"item"}
    with open(argo, encoding="utf8") as text:
        used = set(re.findall(r"{{([^}]*)}}", text.read()))
    assert used <= known, f"{argo}: {used - known} are not defined"

    with open(nextflow, encoding="utf8") as text:
        script = re.sub(r"//.*", "", text.read())
    process = re.search(r"process (\w+) \{(.*?)\n\}", script, re.S)
    assert process and all(f"\n    {part}:" in process[2] for part in ("input", "output", "script"))
    assert re.search(r"workflow \{.*" + process[1] + r"\(", script, re.S), "the process is not called"
    assert script.count("{") == script.count("}") and script.count('"""') == 2
    commands.append(process[2].split('"""')[1].replace("\\\n", " "))
    for command in commands:
        print(" ".join(command.split()))


if __name__ == "__main__":
    main()
