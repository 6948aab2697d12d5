"""One touching pair in its own frame: numbers in, numbers out, with derivatives.

The bearing around the pair, its balance and its iterations stand elsewhere; `raceways` joins line contact,
film and traction. A contact law is one module in its room; rooms export what others may use.
"""
