//! What exactness is made of: exponent ranges, filters, rationals.
