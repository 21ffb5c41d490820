#!/usr/bin/env python3
"""The example scenes keep to docs/scene.schema.json, and what the loader refuses, the schema refuses too.
Usage: validate_scenes.py SOURCE_DIR; exit code 77 (skipped) without the module jsonschema."""
import copy
import json
import pathlib
import sys

try:
    from jsonschema import Draft202012Validator
except ImportError:
    print("SKIPPED: no module jsonschema")
    sys.exit(77)

source = pathlib.Path(sys.argv[1])
schema = json.loads((source / "docs/scene.schema.json").read_text())
Draft202012Validator.check_schema(schema)
validator = Draft202012Validator(schema)

scenes = sorted(source.glob("data/*.json"))
assert scenes, "no example scene"
for scene in scenes:
    validator.validate(json.loads(scene.read_text()))

page = (source / "docs/scenes.md").read_text()
blocks = [block.split("```")[0] for block in page.split("```json\n")[1:]]
assert blocks, "no example in docs/scenes.md"
for block in blocks:
    validator.validate(json.loads(block))

identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
good = {"objects": [{"file": "a.obj", "transform": identity}, {"file": "b.ply", "role": "blocker"}]}
validator.validate(good)


def refuses(change):
    scene = copy.deepcopy(good)
    change(scene, scene["objects"][0])
    assert not validator.is_valid(scene), f"the schema takes {scene}"


refuses(lambda scene, first: first.pop("file"))
refuses(lambda scene, first: first.update(role="blocker"))
refuses(lambda scene, first: first.update(role="light"))
refuses(lambda scene, first: first.update(name="a/b"))
refuses(lambda scene, first: first.update(creaseAngle=181))
refuses(lambda scene, first: scene.update(objects=[]))
refuses(lambda scene, first: scene.update(lights=[]))
for transform in (7, identity[:15], identity[:15] + [2], identity[:3] + ["0"] + identity[4:], {"scale": 0},
                  {"scale": [1, 0, 1]}, {"translate": [1, 2]}, {"rotate": {"axis": [0, 0, 0], "degrees": 1}},
                  {"matrix": identity, "scale": 2}):
    refuses(lambda scene, first: first.update(transform=transform))
for material in ({"color": 1}, {"albedo": 1.5}, {"albedo": [1, 1]}, {"albedo": 1, "texture": "t.png"},
                 {"twoSided": 1}, {"emission": -1}, {"glossy": {"reflectance": 1}}, {"vertexColors": "no"}):
    refuses(lambda scene, first: first.update(material=material))
    refuses(lambda scene, first: scene.update(materials={"x": material}))
print(f"{len(scenes)} scenes and {len(blocks)} examples keep to the schema")
