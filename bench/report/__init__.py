"""`./run report`: measures, compares, and writes one page that shows it all.

plan -> stages (programs are run, results kept) -> measurements (what they say) -> fits, tables, plots -> page.
"""
