package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.rules.Piece;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Scene;

import java.util.List;
import java.util.Optional;

/** The target of a click: the position of the pointer, or a box selected by keys. */
final class Cursor {

    private static final int NONE = -1;

    /** Weight of a distance across the arrow's direction, relative to one along it. */
    private static final double ACROSS = 2;

    private final Camera camera;
    private double x = Scene.WIDTH / 2.0;
    private double y = Scene.HEIGHT / 2.0;
    private int chosen = NONE;

    Cursor(Camera camera) {
        this.camera = camera;
    }

    /** Moves the pointer, px, which drops the selection by keys. */
    void point(double toX, double toY) {
        x = toX;
        y = toY;
        chosen = NONE;
    }

    void letGo() {
        chosen = NONE;
    }

    /** Position on the screen, px: that of the pointer, or of the selected box. */
    double x(PuzzleGame game) {
        return chosen(game).map(piece -> camera.screenX(piece.body().x())).orElse(x);
    }

    /** Screen px. */
    double y(PuzzleGame game) {
        return chosen(game).map(piece -> camera.screenY(piece.body().y())).orElse(y);
    }

    /** The box selected by keys, if it can still be deleted. */
    Optional<Piece> chosen(PuzzleGame game) {
        return chosen == NONE
                ? Optional.empty()
                : Optional.of(game.pieces().get(chosen)).filter(Piece::isDeletable);
    }

    /** The body that is selected by keys, or lies under the pointer. */
    Optional<Piece> under(PuzzleGame game) {
        return chosen(game).or(() -> game.pieceAt(camera.worldX(x), camera.worldY(y)));
    }

    /**
     * Selects the next box that can be deleted (+1), or the previous one (−1), in the order of the
     * file.
     */
    void cycle(PuzzleGame game, int direction) {
        List<Piece> pieces = game.pieces();
        int from = chosen == NONE && direction < 0 ? 0 : chosen;
        for (int i = 1; i <= pieces.size(); i++) {
            int next = Math.floorMod(from + i * direction, pieces.size());
            if (pieces.get(next).isDeletable()) {
                chosen = next;
                return;
            }
        }
    }

    /** Selects the nearest box in an arrow's direction; the first box if none was selected. */
    void move(PuzzleGame game, Key arrow) {
        Optional<Piece> from = chosen(game);
        if (from.isEmpty()) {
            cycle(game, 1);
            return;
        }
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < game.pieces().size(); i++) {
            Piece piece = game.pieces().get(i);
            double way = piece.isDeletable() ? way(from.get(), piece, arrow) : least;
            if (way < least) {
                least = way;
                chosen = i;
            }
        }
    }

    /** Weighted distance of a box, m; infinite if it lies in another direction. */
    private static double way(Piece from, Piece to, Key arrow) {
        double right = to.body().x() - from.body().x();
        double up = to.body().y() - from.body().y();
        double along =
                switch (arrow) {
                    case RIGHT -> right;
                    case LEFT -> -right;
                    case UP -> up;
                    case DOWN -> -up;
                    default -> throw new IllegalArgumentException("no arrow: " + arrow);
                };
        double across = arrow == Key.RIGHT || arrow == Key.LEFT ? up : right;
        return along > 0 ? along + ACROSS * Math.abs(across) : Double.POSITIVE_INFINITY;
    }
}
