"""The style sheet of the page. LIGHT and DARK stand for the colours of the themes."""

STYLE = """
:root { color-scheme: light dark; --font: system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; LIGHT }
@media (prefers-color-scheme: dark) { :root { DARK } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.6 var(--font); }
main, header { max-width: 72rem; margin: 0 auto; padding: 0 1.1rem; }
header { padding-top: 2.6rem; }
h1 { font-size: clamp(1.6rem, 5vw, 2.3rem); line-height: 1.2; margin: 0 0 .5rem; letter-spacing: -.01em; }
h2 { font-size: 1.35rem; line-height: 1.3; margin: 3.2rem 0 .6rem; padding-top: .8rem;
     border-top: 1px solid var(--grid); }
p { max-width: 46rem; margin: .7rem 0; overflow-wrap: break-word; }
.answer { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 22rem), 1fr)); gap: .6rem 3rem;
          align-items: center; margin: 1rem 0 1.6rem; }
.answer p { font-size: clamp(1.08rem, 2.2vw, 1.28rem); line-height: 1.45; margin: 0 0 1rem; }
.lead { color: var(--muted); font-size: .92rem; }
.warning { border-left: 3px solid var(--wrong); padding-left: .8rem; }
a { color: var(--accent); }
code { font: .92em ui-monospace, "DejaVu Sans Mono", monospace; background: var(--panel); padding: .05em .3em;
       border-radius: 3px; }
nav { display: flex; flex-wrap: wrap; gap: .25rem 1rem; margin: 1.2rem 0 0; font-size: .92rem; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 27rem), 1fr)); gap: 1.2rem 2rem;
           margin: 1.1rem 0; align-items: start; }
figure { margin: 0; min-width: 0; }
figure.wide { max-width: 34rem; }
.figures > figure { max-width: 30rem; }
figure svg { display: block; width: 100%; height: auto; }
figcaption, .caption { font-size: .88rem; line-height: 1.45; color: var(--muted); margin: .35rem 0 .4rem;
                       max-width: 46rem; }
.hint { display: none; }
@media (max-width: 48rem) { .hint { display: block; font-size: .82rem; color: var(--muted); margin: 0 0 .2rem; } }
.scroll { background: linear-gradient(to left, var(--paper) 30%, transparent) right / 2.5rem 100% no-repeat local,
          linear-gradient(to left, color-mix(in srgb, var(--ink) 28%, transparent), transparent)
          right / 1rem 100% no-repeat scroll;
          overflow-x: auto; max-width: 100%; margin: 0 0 1.3rem;
          border-top: 1px solid var(--grid); border-bottom: 1px solid var(--grid); }
table { border-collapse: collapse; font-size: .87rem; font-variant-numeric: tabular-nums; }
th, td { padding: .28rem .7rem; text-align: right; white-space: nowrap; }
th { font-weight: 600; vertical-align: bottom; white-space: normal; min-width: 4rem; line-height: 1.3;
     border-bottom: 1px solid var(--grid); }
th:first-child, td:first-child { text-align: left; position: sticky; left: 0; background: var(--paper);
                                 padding-left: 0; }
th.text, td.text { text-align: left; }
tbody tr:nth-child(even) td { background: color-mix(in srgb, var(--muted) 7%, transparent); }
tbody tr:nth-child(even) td:first-child { background: var(--panel); }
.tall { max-height: 28rem; overflow: auto; }
.tall thead th { position: sticky; top: 0; background: var(--paper); z-index: 1; }
details { margin: .9rem 0; max-width: 46rem; } details[open] { max-width: none; }
summary { cursor: pointer; color: var(--accent); font-size: .92rem; }
footer { margin: 4rem 0 2rem; color: var(--muted); font-size: .88rem; }
"""
