"""The documentation site: `python -m sphinx -W --keep-going docs build/site`."""

import sys
from importlib.metadata import version as installed_version
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "_ext"))

project = "exoid"
copyright = "the authors of exoid"
version = release = installed_version("exoid")
extensions = ["myst_parser", "sphinx.ext.autodoc", "catalogue", "commands", "docstrings", "mathml"]
myst_enable_extensions = ["dollarmath", "deflist"]
myst_heading_anchors = 3
exclude_patterns = ["_ext"]
nitpicky = True
smartquotes = False  # they would join the dashes of options

autodoc_typehints = "none"
autodoc_preserve_defaults = True
autodoc_member_order = "bysource"
autodoc_default_options = {"members": True}
add_module_names = False

html_theme = "furo"
html_title = "exoid"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
pygments_style = "friendly"
pygments_dark_style = "github-dark"
