"""Sensitivity of models that the script runs itself."""
