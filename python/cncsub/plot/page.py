"""A figure as one page of HTML that needs no network, dark or light as its reader likes it.

The library that draws and the figure are packed: a browser unpacks them, so that a page of a long
path takes a few megabytes and not twenty.
"""

from __future__ import annotations

import base64
import gzip
import html
import json
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from cncsub.escapes import escape
from cncsub.pages import html_page
from cncsub.plot.still import still_svg, still_text

if TYPE_CHECKING:
    from cncsub.plot.beside import Beside
    from cncsub.program import Program

_MOST_BLOCKS = 5_000  # beside a picture
_STYLE = """
body { max-width: none; padding-bottom: 1rem; }
#picture { min-height: 60vh; min-width: 0; }
#code { overflow: auto; max-height: 40vh; border: 1px solid var(--line); border-radius: .3rem; }
#code h2 { font-size: 1rem; margin: .6rem .6rem .2rem; }
#code table { width: 100%; font: .86rem/1.4 ui-monospace, monospace; }
#code td { border: 0; padding: .05rem .6rem; white-space: pre-wrap; }
#code td:first-child { width: 1%; color: var(--pale); }
#code tr[data-block] { cursor: crosshair; }
#code tr.here { background: var(--part); }
@media (min-width: 64rem) {
  .beside { display: grid; grid-template-columns: minmax(0, 1fr) 24rem; gap: 1rem; }
  #code { max-height: calc(100vh - 7.5rem); }
}
"""
# A scene fills the window. In a narrow window it is drawn smaller, and the text under a picture
# gets shorter lines.
_SCRIPT = """
function unpacked(name) {
  var packed = atob(document.getElementById(name).textContent);
  var bytes = Uint8Array.from(packed, function (letter) { return letter.charCodeAt(0); });
  var plain = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(plain).text();
}
function told(why) {
  document.getElementById('picture').textContent = why;
}
function draw(figure) {
  var at = document.getElementById('picture');
  var scene = figure.layout.scene;
  var fills = scene || (figure.layout.yaxis || {}).scaleanchor;
  figure.layout.title = undefined;  // it stands in the head of the page
  figure.layout.margin.t -= 36;
  var least = figure.layout.height || 400;
  var notes = figure.layout.annotations || [];
  var told = notes.length ? notes[0].text : '';
  var letters = told.replace(/<br>/g, ' ');
  function fold(text, width) {
    var lines = [''];
    text.split(' ').forEach(function (word) {
      var last = lines.length - 1;
      if (lines[last] && (lines[last] + ' ' + word).length > width) lines.push(word);
      else lines[last] += (lines[last] ? ' ' : '') + word;
    });
    return lines;
  }
  var before = told.split('<br>').length;
  var bottom = figure.layout.margin.b;
  function laid() {
    var layout = JSON.parse(JSON.stringify({
      margin: figure.layout.margin, annotations: notes }));
    if (told) {
      var lines = fold(letters, Math.max(20, Math.floor((at.clientWidth - 40) / 6.2)));
      layout.annotations[0].text = lines.join('<br>');
      layout.margin.b = bottom + 15 * (lines.length - before);
    }
    if (fills)
      layout.height = Math.max(least, window.innerHeight - at.getBoundingClientRect().top - 16);
    if (fills && !scene) {  // no higher than the path in a narrow window
      var across = figure.layout.xaxis.range, along = figure.layout.yaxis.range;
      var part = (along[1] - along[0]) / (across[1] - across[0]) * figure.layout.yaxis.scaleratio;
      var high = (at.clientWidth - 60) * part + layout.margin.t + layout.margin.b;
      layout.height = Math.min(layout.height, Math.max(least - 200, high));
    }
    if (scene) {
      var room = layout.height - layout.margin.t - layout.margin.b;
      var share = Math.min(1, 0.66 * (at.clientWidth - 32) / room);
      var ratio = {};
      for (var side in scene.aspectratio) ratio[side] = scene.aspectratio[side] * share;
      layout.scene = Object.assign({}, scene, { aspectratio: ratio });
    }
    return layout;
  }
  var beside = JSON.parse((document.getElementById('blocks') || {}).textContent || 'null');
  if (beside) figure.data.push({
    type: scene ? 'scatter3d' : 'scatter', mode: 'lines+markers', x: [null], y: [null], z: [null],
    line: { color: '#f5c400', width: scene ? 8 : 6 },
    marker: { color: '#f5c400', size: scene ? 3 : 6 },
    hoverinfo: 'skip', showlegend: false, name: 'block' });
  Plotly.newPlot(at, figure.data, Object.assign({}, figure.layout, laid()),
    { responsive: true, displaylogo: false }).then(function () {
      if (figure.frames) Plotly.addFrames(at, figure.frames);
      headed();
      if (beside) pointed(at, beside, figure.data.length - 1);
      var width = at.clientWidth;
      window.addEventListener('resize', function () {
        if (at.clientWidth === width) return;
        width = at.clientWidth;
        var layout = laid();
        if (scene) {  // what was turned stays as it is
          layout['scene.aspectratio'] = layout.scene.aspectratio;
          delete layout.scene;
        }
        Plotly.relayout(at, layout).then(headed);
      });
    });
  function headed() {  // what a legend of many lines needs, so that it does not hide the title
    var legend = at.querySelector('g.legend');
    if (!legend) return;
    var more = Math.ceil(legend.getBoundingClientRect().height) + 12 - at.layout.margin.t;
    if (more <= 0) return;
    var roomy = { 'margin.t': at.layout.margin.t + more };
    if (!fills) roomy.height = at.layout.height + more;
    Plotly.relayout(at, roomy);
  }
}
// A cursor in the code and in the picture: pointing at one shows the place in the other.
function pointed(at, beside, cursor) {
  var rows = {};
  document.querySelectorAll('#code tr[data-block]').forEach(function (row) {
    var block = Number(row.dataset.block);
    rows[block] = row;
    row.addEventListener('pointerenter', function () { marked(block); drawn(block); });
  });
  document.getElementById('code').addEventListener('pointerleave', function () { drawn(-2); });
  var last = null;
  function marked(block) {
    if (last) last.classList.remove('here');
    last = rows[block] || null;
    if (last) last.classList.add('here');
    return last;
  }
  function seen(block) {
    var row = marked(block);
    if (!row) return;
    var list = document.getElementById('code');
    var top = row.offsetTop - list.offsetTop;
    if (top < list.scrollTop + 40 || top > list.scrollTop + list.clientHeight - 60)
      list.scrollTop = top - list.clientHeight / 2;
  }
  function drawn(block) {  // the moves of a block, in the colour of the tool
    var line = { x: [], y: [], z: [] };
    at._fullData.forEach(function (trace) {
      (trace.customdata || []).forEach(function (of, place) {
        if (of !== block || trace.name.indexOf('hole') > 0 || line.x.length > 20000) return;
        [place - 1, place].forEach(function (end) {
          for (var side in line) line[side].push(trace[side] ? trace[side][end] : null);
        });
        for (var side in line) line[side].push(null);
      });
    });
    if (!line.x.length) line = { x: [null], y: [null], z: [null] };
    Plotly.restyle(at, { x: [line.x], y: [line.y], z: [line.z] }, [cursor]);
  }
  at.on('plotly_hover', function (event) {
    var of = event.points[0].customdata;
    if (typeof of === 'number' && of % 1 === 0 && of >= 0) seen(of);
  });
  at.on('plotly_animatingframe', function (event) {
    var of = beside.frames[Number(event.name)];
    if (of !== undefined) seen(of);
  });
}
if (typeof DecompressionStream === 'undefined') {
  told('This page needs a browser of 2023 or later, which can unpack its data.');
} else {
  Promise.all([unpacked('library'), unpacked('figure')]).then(function (texts) {
    var library = document.createElement('script');
    library.textContent = texts[0];
    document.head.appendChild(library);
    draw(JSON.parse(texts[1]));
  }).catch(function (error) { told('The picture cannot be drawn: ' + error); });
}
"""


def page_of(figure: Any, programs: Mapping[str, Program] | None = None) -> str:
    """Return the page. `programs`: those whose blocks stand beside the picture of a path."""
    from plotly.offline import get_plotlyjs

    title = html.unescape(figure.layout.title.text or "plot")
    allowed = " 'unsafe-eval'; img-src data: blob:"
    code = _code(getattr(figure, "_beside", None), programs or {})
    words = escape(still_text(figure)).replace("\n", "<br>")
    picture = f'<div id="picture"><noscript>{still_svg(figure)}<p>{words}</p></noscript></div>'
    body = [
        f'<div class="beside">{picture}{code}</div>\n' if code else picture,
        _packed("library", get_plotlyjs()),
        _packed("figure", figure.to_json()),
    ]
    return html_page(title, "plot", body, style=_STYLE, script=_SCRIPT, allowed=allowed)


def _code(beside: Beside | None, programs: Mapping[str, Program]) -> str:
    """Return the blocks of the programs that moved."""
    if beside is None:
        return ""
    number = {place: block for block, place in enumerate(beside.blocks)}
    names = dict.fromkeys(name for name, _ in beside.blocks if name in programs)
    if not names:
        return ""
    short = sum(len(programs[name].blocks) for name in names) <= _MOST_BLOCKS
    parts = []
    left = _MOST_BLOCKS
    for name in names:
        rows = []
        for block in programs[name].blocks:
            of = number.get((name, block.line))
            if left and (short or of is not None):
                left -= 1
                marked = "" if of is None else f' data-block="{of}"'
                rows.append(f"<tr{marked}><td>{block.line}</td><td>{escape(block.text)}</td></tr>")
        parts.append(f"<h2>{escape(name)}</h2><table>{''.join(rows)}</table>")
    if not short:
        parts.append('<p class="pale">Only blocks that move are shown.</p>')
    frames = json.dumps({"frames": beside.of_frames})
    held = f'<script type="application/json" id="blocks">{frames}</script>'
    return (
        f'<div id="code" tabindex="0" role="region" aria-label="code">{"".join(parts)}</div>{held}'
    )


def _packed(name: str, text: str) -> str:
    packed = base64.b64encode(gzip.compress(text.encode(), 6, mtime=0)).decode()
    return f'<script type="application/gzip" id="{name}">{packed}</script>\n'
