"""How Sphinx builds the site: `make docs`."""

import hashlib
import os
import sys
from importlib.metadata import version as version_of
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parent
sys.path[:0] = [str(ROOT), str(HERE)]

project = "flexbearing"
author = "The flexbearing developers"
copyright = f"2026, {author}"
release = version = version_of("flexbearing")

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx.ext.mathjax",
    "api_pages",
]
exclude_patterns = ["_build", "jupyter_execute", ".jupyter_cache"]
root_doc = "index"
nitpicky = False

myst_enable_extensions = ["dollarmath", "amsmath", "colon_fence", "deflist", "attrs_block"]
myst_heading_anchors = 4
suppress_warnings = ["myst.header"]

# Executed cells are kept for as long as neither the program nor the shipped cases change.
SOURCES = [
    path
    for folder in ("quasidynamic", "fem", "flexbearing", "configs", "benchmarks")
    for path in sorted((ROOT / folder).rglob("*"))
    if path.suffix in (".py", ".toml", ".step")
]
PROGRAM = hashlib.sha256(b"".join(path.read_bytes() for path in SOURCES)).hexdigest()[:12]
nb_execution_mode = "cache"
nb_execution_cache_path = str(HERE / "_build" / "executed" / PROGRAM)
nb_execution_raise_on_error = True
nb_execution_timeout = 600
nb_merge_streams = True

# Cells run as commands are typed: in the folder of the project, with the programs of this environment.
os.environ["PATH"] = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
os.environ["PYTHONPATH"] = os.pathsep.join(filter(None, [str(ROOT), os.environ.get("PYTHONPATH")]))
os.environ["IPYTHONDIR"] = str(HERE / "_ipython")
os.environ.update(COLUMNS="110", NO_COLOR="1", MPLBACKEND="module://matplotlib_inline.backend_inline")

html_theme = "furo"
html_title = "flexbearing"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sourcelink = False
html_theme_options = {"navigation_with_keys": True}
mathjax_path = "mathjax/tex-svg.js"
# Glyphs from the folder beside the script; no speech, whose worker a browser refuses to load from a file.
mathjax4_config = {
    "loader": {"paths": {"fonts": "[mathjax]/fonts"}},
    "options": {
        "enableMenu": False,
        "menuOptions": {"settings": {"speech": False, "braille": False, "enrich": False}},
    },
}

autodoc_member_order = "bysource"
autodoc_typehints = "none"
autodoc_class_signature = "separated"
napoleon_numpy_docstring = True
napoleon_google_docstring = False
napoleon_custom_sections = ["Source", "Valid"]
napoleon_use_param = False
napoleon_use_rtype = False
