package rigibo.frontend.scene;

/**
 * A colour.
 *
 * @param red 0 to 1
 * @param green 0 to 1
 * @param blue 0 to 1
 * @param alpha 0, clear, to 1
 */
public record Color(float red, float green, float blue, float alpha) {

    /** The palette: a workshop at dusk, warm things on a cool, dim ground. */
    public static final Color DUSK_TOP = of(0x1B1F33);

    public static final Color NIGHT = of(0x0C0E18);
    public static final Color PANEL = of(0x14172A).alpha(0.86f);
    public static final Color PANEL_LIT = of(0x2B3050);
    public static final Color EDGE = of(0x5A5F85);
    public static final Color TEXT = of(0xF4F1E6);
    public static final Color TEXT_DIM = of(0xC9C6D6);
    public static final Color BRASS = of(0xE8C27A);
    public static final Color RIGIBO = of(0xE8A04C);
    public static final Color STONE = of(0x6C7486);
    public static final Color IRON = of(0x39414F);
    public static final Color ICE = of(0xA9DDF0);
    public static final Color RUBBER = of(0xC4527A);
    public static final Color WOOD = of(0xB9783F);
    public static final Color BALL = of(0xF4F1E6);
    public static final Color GOAL = of(0x2C9A80);

    /** The glow in a fire door. */
    public static final Color EMBER = of(0xD9481F);

    public static final Color GOOD = of(0x3FC1A9);
    public static final Color BAD = of(0xF2685E);

    /** An opaque colour from 0xRRGGBB. */
    public static Color of(int rgb) {
        return new Color((rgb >> 16 & 255) / 255f, (rgb >> 8 & 255) / 255f, (rgb & 255) / 255f, 1);
    }

    /** Returns this colour with another opacity. */
    public Color alpha(double opacity) {
        return new Color(red, green, blue, (float) opacity);
    }
}
