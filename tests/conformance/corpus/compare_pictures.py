#!/usr/bin/python3
"""Previews scenes of the corpus and compares them with the pictures that came with it.

usage: compare_pictures.py PLUGC SHARED_FOLDER

Exit status 77 (skipped) when the corpus or what the comparison needs is not there. A scene passes when the comparison
calls it `same` or `close` against the better of two sets of reference pictures.
"""
import importlib.util
import os
import re
import subprocess
import sys
import tempfile

SKIPPED = 77

SCENES = """
compositing_shaders/composed_shader_using_plugs
compositing_shaders/force_flat_shading
compositing_shaders/fresnel_and_toon
compositing_shaders/grayscale_texture_effect
compositing_shaders/store_linear_distance_in_red_color
compositing_shaders/texture_coord_generate
compositing_shaders/texture_effect_multi
compositing_shaders/time_to_shader
shaders/attributes
shaders/shaders_inlined
shaders/two_textures
shadow_maps/castle_with_trees/castle_with_trees_processed
shadow_maps/primitives_with_commonsurfaceshader
shadow_maps/projective_texturing_simple
shadow_maps/teapot
shadow_volumes/shadows_worm_in_a_room
""".split()


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


def check_needs(corpus, compare):
    for path in (corpus, compare):
        if not os.path.exists(path):
            skip(f"{path} is not there")
    for module in ("PIL", "numpy", "skimage"):
        if importlib.util.find_spec(module) is None:
            skip(f"Python has no {module}")


def preview(plugc, scene, picture):
    command = [plugc, "preview", scene, "-o", picture, "--size", "800x450", "--samples", "4"]
    result = subprocess.run(command, capture_output=True, text=True)
    # 1: the scene has mistakes of its own; what could be made is drawn all the same
    if result.returncode not in (0, 1) or not os.path.exists(picture):
        return f"plugc ended with {result.returncode}: {result.stderr.strip()}"
    return ""


def verdict(compare, picture, references):
    result = subprocess.run(["/usr/bin/python3", compare, "--bg", picture, *references], capture_output=True, text=True)
    found = re.search(r"\t(same|close|differs|size differs)", result.stdout)
    return found.group(1) if found else result.stderr.strip(), result.stdout.strip()


def judge(plugc, compare, corpus, name, folder):
    file_name = name.replace("/", "__") + ".x3dv.png"
    picture = os.path.join(folder, file_name)
    problem = preview(plugc, os.path.join(corpus, "scenes", name + ".x3dv"), picture)
    if problem:
        return False, f"{name}: {problem}"
    sets = (os.path.join(corpus, s, file_name) for s in ("reference-newest", "reference-released"))
    word, text = verdict(compare, picture, [path for path in sets if os.path.exists(path)])
    return word in ("same", "close"), text


def main():
    plugc, shared = sys.argv[1:]
    corpus = os.path.join(shared, "corpus")
    compare = os.path.join(shared, "tools", "compare_images.py")
    check_needs(corpus, compare)
    passed = []
    with tempfile.TemporaryDirectory() as folder:
        for name in SCENES:
            fine, text = judge(plugc, compare, corpus, name, folder)
            passed.append(fine)
            print(("ok    " if fine else "FAILS ") + text, flush=True)
    sys.exit(0 if all(passed) else 1)


main()
