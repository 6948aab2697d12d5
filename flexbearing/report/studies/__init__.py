"""Tables and pictures of studies, which run one case many times."""
