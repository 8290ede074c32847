package rigibo.frontend.puzzle;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The keys below the play, which can be clicked like buttons. */
final class KeyStrip {

    private static final double TOP = View.KEYS_TOP + 2;
    private static final double HEIGHT = Scene.HEIGHT - 2 - TOP;
    private static final double SIZE = 16;
    private static final double PADDING = 7;
    private static final double BETWEEN = 5;

    /** Positions of the buttons in the last frame; their widths depend on their words. */
    private final List<Place> places = new ArrayList<>();

    private double pointerX = -1;
    private double pointerY = -1;

    /** A button on the screen, px. */
    private record Place(Command command, double left, double right) {
        boolean contains(double x, double y) {
            return x >= left && x <= right && y >= TOP;
        }
    }

    /** Draws commands at equal distances; one that is switched on is lit. */
    void draw(Canvas canvas, Words words, List<Command> commands, List<Command> lit) {
        double taken = 0;
        for (Command command : commands) {
            taken += width(canvas, words, command);
        }
        double gap = (Scene.WIDTH - taken) / (commands.size() + 1);
        double left = gap;
        places.clear();
        for (Command command : commands) {
            double width = width(canvas, words, command);
            places.add(new Place(command, left, left + width));
            draw(canvas, words, places.get(places.size() - 1), lit.contains(command));
            left += width + gap;
        }
    }

    private static double width(Canvas canvas, Words words, Command command) {
        double label = canvas.textWidth(command.words(words), SIZE, Canvas.Font.WORDS);
        double key = canvas.textWidth(command.keyWords(words), SIZE, Canvas.Font.WORDS);
        return 2 * PADDING + key + BETWEEN + label;
    }

    private void draw(Canvas canvas, Words words, Place place, boolean isLit) {
        boolean isHot = place.contains(pointerX, pointerY);
        Color plate = isLit ? Color.BRASS : isHot ? Color.EDGE : Color.PANEL_LIT;
        canvas.panel(place.left, TOP, place.right - place.left, HEIGHT, 8, plate);
        Color ink = isLit ? Color.DUSK_TOP : Color.TEXT;
        double y = TOP + HEIGHT / 2;
        String key = place.command.keyWords(words);
        double x = place.left + PADDING;
        Color keyInk = isLit || isHot ? ink : Color.BRASS;
        canvas.text(key, x, y, SIZE, Canvas.Font.WORDS, Canvas.Align.LEFT, keyInk);
        x += canvas.textWidth(key, SIZE, Canvas.Font.WORDS) + BETWEEN;
        String label = place.command.words(words);
        canvas.text(label, x, y, SIZE, Canvas.Font.WORDS, Canvas.Align.LEFT, ink);
    }

    void pointerMoved(double x, double y) {
        pointerX = x;
        pointerY = y;
    }

    /** Whether a point lies on the strip. */
    static boolean contains(double y) {
        return y > View.KEYS_TOP;
    }

    /** The button at a point. */
    Optional<Command> at(double x, double y) {
        return places.stream()
                .filter(place -> place.contains(x, y))
                .map(Place::command)
                .findFirst();
    }
}
