"""A figure as one page of HTML that needs no network, dark or light as its reader likes it.

The library that draws and the figure are packed: a browser unpacks them, so that a page of a long
path takes a few megabytes and not twenty.
"""

from __future__ import annotations

import base64
import gzip
from typing import Any

_STYLE = """
:root { color-scheme: light dark; }
html, body { margin: 0; height: 100%; background: #fff; }
@media (prefers-color-scheme: dark) { html, body { background: #14181b; } }
#picture { width: 100%; min-height: 100vh; }
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
      margin: figure.layout.margin, annotations: notes, title: figure.layout.title }));
    if (told) {
      var lines = fold(letters, Math.max(20, Math.floor((at.clientWidth - 40) / 6.2)));
      layout.annotations[0].text = lines.join('<br>');
      layout.margin.b = bottom + 15 * (lines.length - before);
    }
    if (scene) {
      layout.height = Math.max(least, window.innerHeight);
      var room = layout.height - layout.margin.t - layout.margin.b;
      var share = Math.min(1, 0.66 * (at.clientWidth - 32) / room);
      var ratio = {};
      for (var side in scene.aspectratio) ratio[side] = scene.aspectratio[side] * share;
      layout.scene = Object.assign({}, scene, { aspectratio: ratio });
    }
    return layout;
  }
  Plotly.newPlot(at, figure.data, Object.assign({}, figure.layout, laid()),
    { responsive: true, displaylogo: false }).then(function () {
      if (figure.frames) Plotly.addFrames(at, figure.frames);
      headed();
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
    var more = Math.ceil(legend.getBoundingClientRect().height) + 44 - at.layout.margin.t;
    if (more <= 0) return;
    var roomy = { 'margin.t': at.layout.margin.t + more };
    if (!scene) roomy.height = at.layout.height + more;
    Plotly.relayout(at, roomy);
  }
}
if (typeof DecompressionStream === 'undefined') {
  told('This page needs a browser that can unpack what it holds: one of 2023 or later.');
} else {
  Promise.all([unpacked('library'), unpacked('figure')]).then(function (texts) {
    var library = document.createElement('script');
    library.textContent = texts[0];
    document.head.appendChild(library);
    draw(JSON.parse(texts[1]));
  }).catch(function (error) { told('The picture cannot be drawn: ' + error); });
}
"""


def page_of(figure: Any) -> str:
    from plotly.offline import get_plotlyjs

    title = figure.layout.title.text or "plot"
    allowed = (
        "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline' 'unsafe-eval';"
        " img-src data: blob:"
    )
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{allowed}">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{title}</title><style>{_STYLE}</style></head>\n"
        '<body><div id="picture"><noscript>A script draws the picture.</noscript></div>\n'
        f"{_packed('library', get_plotlyjs())}{_packed('figure', figure.to_json())}"
        f"<script>{_SCRIPT}</script></body></html>\n"
    )


def _packed(name: str, text: str) -> str:
    packed = base64.b64encode(gzip.compress(text.encode(), 6, mtime=0)).decode()
    return f'<script type="application/gzip" id="{name}">{packed}</script>\n'
