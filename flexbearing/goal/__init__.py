"""Changes of a case that reach a life: each lever alone, and the best pair."""
