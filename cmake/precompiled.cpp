// Nothing but the source that a target needs, here the one of the precompiled headers.
