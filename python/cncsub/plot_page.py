"""A figure as one page of HTML that needs no network, dark or light as its reader likes it."""

from __future__ import annotations

from typing import Any

_STYLE = """
:root { color-scheme: light dark; }
html, body { margin: 0; height: 100%; background: #fff; }
@media (prefers-color-scheme: dark) { html, body { background: #14181b; } }
#picture { width: 100%; min-height: 100vh; }
"""
# A scene fills the window; where that is narrow, what is told under it gets smaller lines.
_SCRIPT = """
(function () {
  var at = document.getElementById('picture');
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
    if (figure.layout.scene) layout.height = Math.max(least, window.innerHeight);
    return layout;
  }
  Plotly.newPlot(at, figure.data, Object.assign({}, figure.layout, laid()),
    { responsive: true, displaylogo: false }).then(function () {
      if (figure.frames) Plotly.addFrames(at, figure.frames);
      var width = at.clientWidth;
      window.addEventListener('resize', function () {
        if (at.clientWidth !== width) { width = at.clientWidth; Plotly.relayout(at, laid()); }
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
