package rigibo.frontend.puzzle.show;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.geometry.ShapeKind;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Verb;
import rigibo.frontend.puzzle.rules.Link;
import rigibo.frontend.puzzle.rules.Piece;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.rules.Target;
import rigibo.frontend.scene.Words;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/**
 * Names of targets for players who do not see them: the object, the action of a click, and the
 * place in plain words.
 */
final class TargetNames {

    /** Ends of the middle, as shares of the world: legs of a table stand beside it. */
    private static final double LEFT_END = 5.0 / 12;

    private static final double RIGHT_BEGIN = 7.0 / 12;

    private static final List<String> HEIGHTS = List.of("low", "half", "high");

    private final Words words;
    private final PuzzleGame game;

    /** Names in a language, for the present state of a game. */
    TargetNames(Words words, PuzzleGame game) {
        this.words = words;
        this.game = game;
    }

    /** The name of a target. */
    String of(Target target) {
        String side = side(target.x());
        List<Target> column =
                game.targets().stream()
                        .filter(other -> other.isClickable() && side(other.x()).equals(side))
                        .sorted(Comparator.comparingDouble(Target::y))
                        .toList();
        return column.size() < 2
                ? words.of("target.alone", what(target), side)
                : words.of(
                        "target.several",
                        what(target),
                        side,
                        column.indexOf(target) + 1,
                        column.size());
    }

    /** The places of ball and platform at the start. */
    String start() {
        Level level = game.level();
        return words.of(
                "target.start",
                place(level.balls().get(0).x(), level.balls().get(0).y()),
                place(level.platform().x(), level.platform().y()));
    }

    private String place(double x, double y) {
        return words.of("target.place", side(x), height(y));
    }

    private String side(double x) {
        double share = x / game.level().world().width();
        String side = share < LEFT_END ? "left" : share > RIGHT_BEGIN ? "right" : "middle";
        return words.of("target." + side);
    }

    private String height(double y) {
        int third = (int) Math.floor(y / game.level().world().height() * HEIGHTS.size());
        int within = Math.max(0, Math.min(HEIGHTS.size() - 1, third));
        return words.of("target." + HEIGHTS.get(within));
    }

    private String what(Target target) {
        String thing = target instanceof Piece piece ? body(piece) : joint((Link) target);
        boolean isPlain = target.is(Verb.DELETE);
        return isPlain ? thing : words.of("target.act", thing, act(target.verb().orElseThrow()));
    }

    private String act(Verb verb) {
        return words.of("target." + verb.title());
    }

    private String body(Piece piece) {
        if (piece.definition().source().jet().isPresent()) {
            return words.of("editor.fan");
        }
        if (piece.definition().source().pole().isPresent()) {
            return words.of("editor.magnet");
        }
        String material = words.of("editor.material." + piece.substance().title());
        return words.of("target.made", material, words.of("target." + form(piece.body().shape())));
    }

    private static String form(Shape shape) {
        if (shape.kind() == ShapeKind.CIRCLE) {
            return "disc";
        }
        return shape instanceof Polygon polygon && polygon.corners() == 4 ? "box" : "piece";
    }

    private String joint(Link link) {
        return words.of("editor.joint." + link.definition().type().name().toLowerCase(Locale.ROOT));
    }
}
