"""Limits of what a model neglects, and of where its contacts stand."""

from dataclasses import replace

from flexbearing.findings.finding import DANGER, OUTSIDE, Finding

NEGLECTED = Finding(
    code="neglected-force", label="force that is neglected, over the largest load",
    quantity="neglected", at_most=0.01, grade=OUTSIDE, source="limit of this program", shown="%",
    meaning="loads, contact angles and lives are off by about as much",
    action="take a kind of case that counts it, as angular_contact_ball for fast balls, or a lower speed",
    of_model=True,
)  # fmt: skip
MUCH_NEGLECTED = replace(
    NEGLECTED,
    at_most=0.1,
    grade=DANGER,
    meaning="loads, contact angles and lives are those of another bearing",
)
REVERSED_THRUST = Finding(
    code="reversed-thrust", label="contact angle of the most loaded ball", quantity="loaded_angle",
    at_least=0.0, grade=DANGER, source="the open side of an angular contact bearing", unit="rad", shown="deg",
    meaning="the thrust presses the balls over the low shoulder, the bearing comes apart",
    action="turn the thrust round, or take a second bearing the other way round",
    of_model=True,
)  # fmt: skip
CONTACT_HEIGHT = Finding(
    code="contact-height", label="contact height over ball diameter",
    quantity="contact_height", at_most=0.45, grade=DANGER, source="no race reaches the middle of its ball",
    meaning="the contact is where no race is: it is computed as if the groove had no end",
    action="lower the axial load, or take a bearing with a smaller contact angle or clearance",
)  # fmt: skip
