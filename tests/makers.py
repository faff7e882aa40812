"""A control of each maker that has a folder of examples."""

CONTROLS = {
    "fanuc": "fanuc-0i-f", "grblhal": "grblhal", "gsk": "gsk-988ta", "haas": "haas-ngc", "hnc": "hnc-21m",
    "linuxcnc": "linuxcnc", "mazak": "mazak-smooth", "mitsubishi": "mitsubishi-m800", "okuma": "okuma-osp-p300",
    "siemens": "siemens-one",
    "syntec": "syntec-22ma",
}  # fmt: skip
