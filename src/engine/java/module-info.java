/**
 * A rigid-body engine in two dimensions: {@link rigibo.backend.Pool} is where it begins. SI units
 * everywhere: m, kg, s, rad, N; y points up. It needs nothing but {@code java.base}: no window, no
 * file, no clock and no random number.
 */
module rigibo.backend {
    exports rigibo.backend;
    exports rigibo.backend.geometry;
    exports rigibo.backend.setup;
    exports rigibo.backend.effect;
}
