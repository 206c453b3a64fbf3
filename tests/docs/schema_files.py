"""The schemas of docs/schemas, and documents spoilt so that they must not pass."""
import copy
import json
import pathlib

import jsonschema

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "docs/schemas"
SCHEMAS = {file.name.removesuffix(".schema.json"): json.loads(file.read_text()) for file in sorted(FOLDER.glob("*.json"))}
# References are relative to the folder, as they are for anybody who reads it.
STORE = {f"{FOLDER.as_uri()}/{name}.schema.json": schema for name, schema in SCHEMAS.items()}


def validator_of(name):
    schema = SCHEMAS[name] | {"$id": f"{FOLDER.as_uri()}/{name}.schema.json"}
    jsonschema.Draft202012Validator.check_schema(schema)
    resolver = jsonschema.RefResolver.from_schema(schema, store=STORE)
    return jsonschema.Draft202012Validator(schema, resolver=resolver)


def keys_that_may_be_missing(schema):
    """Names that some object of the schema lists without requiring them."""
    if isinstance(schema, list):
        return set().union(*map(keys_that_may_be_missing, schema))
    if not isinstance(schema, dict):
        return set()
    names = set()
    if isinstance(schema.get("properties"), dict) and schema.get("type") == "object":
        names = set(schema["properties"]) - set(schema.get("required", []))
    return names.union(*map(keys_that_may_be_missing, schema.values()))


def places(document, path=()):
    """Every place in a document, as a path of keys; of an array its first two entries."""
    yield path
    if isinstance(document, dict):
        for key, value in document.items():
            yield from places(value, (*path, key))
    elif isinstance(document, list):
        for index, value in enumerate(document[:2]):
            yield from places(value, (*path, index))


def changed(document, path, change):
    """A copy in which change(parent, key) was done at the place."""
    result = copy.deepcopy(document)
    parent = result
    for key in path[:-1]:
        parent = parent[key]
    change(parent, path[-1])
    return result


def value_at(document, path):
    for key in path:
        document = document[key]
    return document


def put(value):
    return lambda parent, key: parent.__setitem__(key, value)


def spoilt(name, document, is_free=lambda path: False):
    """Pairs of what was done and the document with it: an unknown key in every object, every value of a wrong type, every
    required key left out. Below places that are free everything is allowed."""
    may_be_missing = keys_that_may_be_missing([SCHEMAS[name], SCHEMAS["common"]])
    for path in places(document):
        if is_free(path):
            continue
        where = "/".join(map(str, path))
        value = value_at(document, path)
        if isinstance(value, dict):
            yield f"unknown key in '{where}'", changed(document, (*path, "unheard_of"), put(1))
        if not path:
            continue
        wrong = "text" if not isinstance(value, str) else {"text": value}
        yield f"wrong type of '{where}'", changed(document, path, put(wrong))
        if isinstance(path[-1], str) and path[-1] not in may_be_missing:
            yield f"no '{where}'", changed(document, path, lambda parent, key: parent.pop(key))
