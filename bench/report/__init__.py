"""`./run report`: measures, compares, and writes one page that shows it all. `python3 -m report` is its command line.

    plan -> stages -> measurements -> tables -> chapters -> page

plan       which programs are run with which arguments; `student_report`: what everything is set beside
stages     runs them and keeps what each gave; `benchmarks`, `machine`, `progress`, `files` are its hands
measurements  what the stages say; `repetitions`, `judged_caps`, `fits`: what follows from it
tables     the numbers, as they are shown and as CSV
chapters   sections of sentences, tables and figures
plots      the figures, drawn from tables
page       chapters as HTML, Markdown and text
"""
