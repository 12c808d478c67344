"""Forces learnt from recorded signals: recordings on their way, what a fit found, and estimators at work."""
