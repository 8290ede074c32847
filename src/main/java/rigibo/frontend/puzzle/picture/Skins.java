package rigibo.frontend.puzzle.picture;

import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.scene.Skin;

/** The skin and sound of each material of the levels. */
public final class Skins {

    private Skins() {}

    /** The skin of a substance. */
    public static Skin of(Substance substance) {
        return switch (substance) {
            case RIGIBO -> Skin.RIGIBO;
            case STONE -> Skin.STONE;
            case PLANK -> Skin.WOOD;
            case ICE -> Skin.ICE;
            case RUBBER -> Skin.RUBBER;
            case IRON -> Skin.IRON;
            case BALL -> Skin.BALL;
            case EMBER -> Skin.EMBER;
        };
    }
}
