package rigibo.frontend.puzzle.level;

import rigibo.backend.setup.Material;

import java.util.Locale;

/**
 * The materials of level files. Densities are those of plates about 1 m deep, so that their ratios
 * are those of the real materials. Iron is the exception: a fifth of its density keeps stacks
 * within the limits of GAME.
 */
public enum Substance {
    RIGIBO(new Material(500, 0.5, 0.05)),
    STONE(new Material(2400, 0.6, 0)),
    PLANK(new Material(600, 0.4, 0.05)),
    ICE(new Material(900, 0.03, 0.02)),
    RUBBER(new Material(1100, 0.9, 0.7)),
    IRON(new Material(1600, 0.35, 0.1)),
    BALL(new Material(600, 0.5, 0.1).rollingResistance(Substance.BALL_LEVER)),
    /** A fire door, which melts soon after a ball has touched it. */
    EMBER(new Material(2000, 0.5, 0));

    /** A leather ball's lever on wood, m: at r = 0.35 m it brakes by about 0.2 m/s². */
    private static final double BALL_LEVER = 0.01;

    private final Material material;

    Substance(Material material) {
        this.material = material;
    }

    /** The engine's numbers. */
    public Material material() {
        return material;
    }

    /** The name in level files. */
    public String title() {
        return name().toLowerCase(Locale.ROOT);
    }

    static Substance titled(String title) {
        return valueOf(title.toUpperCase(Locale.ROOT));
    }
}
