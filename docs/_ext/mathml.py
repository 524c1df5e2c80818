"""Equations as MathML, by docutils: pages need neither a network nor scripts."""

from docutils import nodes
from docutils.utils.math.latex2mathml import tex2mathml


def inline(writer, node: nodes.math) -> None:
    writer.body.append(tex2mathml(node.astext()))
    raise nodes.SkipNode


def display(writer, node: nodes.math_block) -> None:
    number = node.get("number")
    writer.body.append(writer.starttag(node, "div", CLASS="equation"))
    writer.body.append(tex2mathml(node.astext(), as_block=True))
    writer.body.append("" if number is None else f'<span class="eqno">({number})</span>')
    writer.body.append("</div>\n")
    raise nodes.SkipNode


def setup(app) -> dict[str, bool]:
    app.add_html_math_renderer("mathml", (inline, None), (display, None))
    app.config.html_math_renderer = "mathml"
    return {"parallel_read_safe": True, "parallel_write_safe": True}
