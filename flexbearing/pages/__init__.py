"""Reports of results and studies as files: HTML or PDF."""
