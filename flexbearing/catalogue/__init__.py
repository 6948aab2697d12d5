"""Cases from the page of a maker's catalogue: what a page gives, and what must be assumed besides."""
