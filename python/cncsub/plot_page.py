"""A figure as one page of HTML that needs no network, dark or light as its reader likes it."""

from __future__ import annotations

from typing import Any

_STYLE = """
:root { color-scheme: light dark; }
html, body { margin: 0; height: 100%; background: #fff; }
@media (prefers-color-scheme: dark) { html, body { background: #14181b; } }
#picture { width: 100%; min-height: 100vh; }
"""
# A scene fills the window; where that is narrow it is drawn smaller, and what is told under a
# picture gets shorter lines.
_SCRIPT = """
(function () {
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
      var width = at.clientWidth;
      window.addEventListener('resize', function () {
        if (at.clientWidth === width) return;
        width = at.clientWidth;
        var layout = laid();
        if (scene) {  // what was turned stays as it is
          layout['scene.aspectratio'] = layout.scene.aspectratio;
          delete layout.scene;
        }
        Plotly.relayout(at, layout);
      });
    });
})();
"""


def page_of(figure: Any) -> str:
    from plotly.offline import get_plotlyjs

    title = figure.layout.title.text or "plot"
    data = figure.to_json().replace("</", "<\\/")  # no text of a program ends the script
    allowed = (
        "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline' 'unsafe-eval';"
        " img-src data: blob:"
    )
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{allowed}">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{title}</title><style>{_STYLE}</style></head>\n"
        f'<body><div id="picture"></div><script>{get_plotlyjs()}</script>\n'
        f"<script>var figure = {data};{_SCRIPT}</script></body></html>\n"
    )
