"""The tables of the page, made of measurements. Each is written as CSV as well: the page shows no other numbers."""
