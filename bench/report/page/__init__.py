"""What shows the chapters: the page, Markdown, the README's part, text; and what writes all of it."""
