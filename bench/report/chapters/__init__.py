"""The page's chapters, one file each: from measurements to sections of sentences, tables and figures."""

from report.chapters import (caps, chains, distribution, fracture, growth, limits, looking, method, models, peers, prepare, proxies,
                             real, summary)
from report.chapters.section import Facts, Section
from report.measurements import Measurements

CHAPTERS = (summary, models, growth, real, prepare, caps, chains, proxies, distribution, looking, fracture, peers, limits, method)


def all_sections(found: Measurements, machine: dict[str, str], facts: Facts) -> list[Section]:
    """In the order of the page. A chapter of which nothing was measured is left out."""
    sections = []
    for module in CHAPTERS:
        facts.section = module.__name__.rsplit(".", 1)[-1]
        written: list[Section] = module.write(found, machine, facts)
        sections += [section for section in written if section.parts]
    return sections
