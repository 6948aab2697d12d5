"""Evidence: what is known beside what is computed, one page a case, with a verdict.

`python -m evidence` computes all cases, stores their numbers in `docs/evidence/numbers` and writes the pages;
`python -m evidence --check` computes them again and fails where one moved by more than its page allows.
Known numbers stand in `tests/literature`, beside the tests that use them; measurements
in `evidence/measured`.
"""
