"""Pages and pictures of four-point and angular-contact ball bearings."""
