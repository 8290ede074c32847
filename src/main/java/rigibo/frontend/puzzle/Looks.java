package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.rules.Piece;
import rigibo.frontend.scene.Skin;

/** What the substances of level files look like. */
final class Looks {

    private Looks() {}

    /** The skin of a piece. */
    static Skin of(Piece piece) {
        return switch (piece.definition().substance()) {
            case RIGIBO -> Skin.RIGIBO;
            case STONE -> Skin.STONE;
            case PLANK -> Skin.WOOD;
            case ICE -> Skin.ICE;
            case RUBBER -> Skin.RUBBER;
            case IRON -> Skin.IRON;
            case BALL -> Skin.BALL;
        };
    }
}
