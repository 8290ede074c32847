package rigibo.frontend.puzzle.show;

import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.rules.Target;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Scene;

import java.util.List;
import java.util.Optional;

/** The aim of a click: the position of the pointer, or a target selected by keys. */
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

    /** Position on the screen, px: that of the pointer, or of the selected target. */
    double x(PuzzleGame game) {
        return chosen(game).map(target -> camera.screenX(target.x())).orElse(x);
    }

    /** Screen px. */
    double y(PuzzleGame game) {
        return chosen(game).map(target -> camera.screenY(target.y())).orElse(y);
    }

    /** The target selected by keys, if it can still be clicked. */
    Optional<Target> chosen(PuzzleGame game) {
        return chosen == NONE
                ? Optional.empty()
                : Optional.of(game.targets().get(chosen)).filter(Target::isClickable);
    }

    /** The target selected by keys, or the one under the pointer. */
    Optional<Target> under(PuzzleGame game) {
        return chosen(game).or(() -> game.targetAt(camera.worldX(x), camera.worldY(y)));
    }

    /**
     * Selects the next target (+1) or the previous one (−1): bodies in the order of the file, then
     * joints.
     */
    void cycle(PuzzleGame game, int direction) {
        List<Target> targets = game.targets();
        int from = chosen == NONE && direction < 0 ? 0 : chosen;
        for (int i = 1; i <= targets.size(); i++) {
            int next = Math.floorMod(from + i * direction, targets.size());
            if (targets.get(next).isClickable()) {
                chosen = next;
                return;
            }
        }
    }

    /** Selects the nearest target in an arrow's direction; the first if none was selected. */
    void move(PuzzleGame game, Key arrow) {
        Optional<Target> from = chosen(game);
        if (from.isEmpty()) {
            cycle(game, 1);
            return;
        }
        double least = Double.POSITIVE_INFINITY;
        List<Target> targets = game.targets();
        for (int i = 0; i < targets.size(); i++) {
            Target target = targets.get(i);
            double way = target.isClickable() ? way(from.get(), target, arrow) : least;
            if (way < least) {
                least = way;
                chosen = i;
            }
        }
    }

    /** Weighted distance of a target, m; infinite if it lies in another direction. */
    private static double way(Target from, Target to, Key arrow) {
        double right = to.x() - from.x();
        double up = to.y() - from.y();
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
