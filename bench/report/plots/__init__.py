"""Every figure of the page, drawn from its tables: what is plotted is in a CSV too."""
