package rigibo.frontend.puzzle.hud;

import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Medal;
import rigibo.frontend.scene.Settings.Motion;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Print;
import rigibo.frontend.scene.widget.Sign;

/**
 * The secret star at the end of a level: stamped after the medals by the game that earned it, shown
 * at once if it was found before, and otherwise a question mark.
 */
final class StarStamp {

    /** Turns until it is stamped, after the three medals. */
    private static final int DUE = (Medal.values().length + 1) * MedalStamps.APART;

    private final String text;
    private final boolean isEarnedNow;
    private final boolean isFound;
    private int turns;

    /**
     * The star of a game's level.
     *
     * @param text states the star's condition
     * @param isFound whether the player has it, from this game or an earlier one
     */
    StarStamp(String text, PuzzleGame game, boolean isFound) {
        this.text = text;
        this.isFound = isFound;
        isEarnedNow = game.hasStar();
    }

    /** After each frame. */
    void turn() {
        turns++;
    }

    private boolean isSeen() {
        return isEarnedNow ? turns >= DUE : isFound;
    }

    /** The star's condition if it is found, stamped yet or not. */
    String told(Words words) {
        return isEarnedNow || isFound ? text : words.of("puzzle.star.hidden");
    }

    /** Draws it at the place after the medals. */
    void draw(Canvas canvas, Words words, PrizePlaces places, Motion motion) {
        int place = Medal.values().length;
        double x = places.x(place);
        double y = places.y(place);
        if (isSeen()) {
            double scale = isEarnedNow ? MedalStamps.scale(turns - DUE, motion) : 1;
            Sign.star(canvas, x, y, 1.2 * MedalStamps.RADIUS * scale);
        } else {
            Sign.outlinedStar(canvas, x, y, 1.1 * MedalStamps.RADIUS, 2, Color.EDGE);
            Print.centred(canvas, "?", x, y + 2, 20, Color.TEXT_DIM);
        }
        Color ink = isSeen() ? Color.TEXT : Color.TEXT_DIM;
        String full = words.of("puzzle.star");
        boolean hasRoom = places.hasRoomFor(canvas, full);
        String name = hasRoom ? full : words.of("puzzle.short.star");
        places.drawWords(canvas, name, place, ink);
    }

    /** The star's condition, as far as the player may know it. */
    String statement(Words words) {
        return isSeen() ? text : words.of("puzzle.star.hidden");
    }
}
