package rigibo.frontend.puzzle.hud;

import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;

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

    /** Least distance between two commands that keeps them distinguishable, px. */
    private static final double LEAST_GAP = 3;

    /** Positions of the buttons in the last frame; their widths depend on their words. */
    private final List<Place> places = new ArrayList<>();

    /** Lower edge of the last row, px. */
    private double foot = TOP + HEIGHT;

    private double pointerX = -1;
    private double pointerY = -1;

    /** A button on the screen, px. */
    private record Place(Command command, Plate plate) {}

    /**
     * Whether a point is on a button. The area below the last row counts for that row, so that it
     * is hit without looking.
     */
    private boolean isOn(Place place, double x, double y) {
        return place.plate.contains(x, Math.min(y, foot));
    }

    /** Draws commands as large buttons, without their keys. */
    void drawInHand(
            Canvas canvas, Words words, List<Command> commands, List<Command> lit, Grid grid) {
        places.clear();
        foot = grid.place(commands.size() - 1).bottom();
        for (Command command : commands) {
            Place place = new Place(command, grid.place(places.size()));
            places.add(place);
            Plate at = place.plate;
            Color ink = drawPlate(canvas, place, lit.contains(command), 12);
            String label =
                    Lines.shortened(
                            canvas,
                            command.shortWords(words),
                            SIZE,
                            Canvas.Font.WORDS,
                            at.width() - PADDING);
            double middle = at.y() + at.height() / 2;
            Print.centred(canvas, label, at.x() + at.width() / 2, middle, SIZE, ink);
        }
    }

    /** Describes the commands drawn last to a screen reader, without their keys. */
    void describe(Narrator narrator, Words words) {
        for (Place place : places) {
            narrator.offers(place.plate.button(place.command.shortWords(words), false));
        }
    }

    /**
     * Draws commands at equal distances; an active one is lit. Where they are wider than the scene,
     * they go on beside it. If there is no room for all words, the first commands, which players
     * know longest, show their keys alone.
     */
    void draw(Canvas canvas, Words words, List<Command> commands, List<Command> lit) {
        int gaps = commands.size() + 1;
        double wanted = taken(canvas, words, commands, 0) + gaps * LEAST_GAP;
        double room = Math.max(Scene.WIDTH, Math.min(canvas.layout().width(), wanted));
        int bare = 0;
        while (bare < commands.size()
                && taken(canvas, words, commands, bare) + gaps * LEAST_GAP > room) {
            bare++;
        }
        double gap = (room - taken(canvas, words, commands, bare)) / gaps;
        double left = (Scene.WIDTH - room) / 2 + gap;
        places.clear();
        foot = TOP + HEIGHT;
        for (int i = 0; i < commands.size(); i++) {
            Command command = commands.get(i);
            double width = width(canvas, words, command, i < bare);
            Place place = new Place(command, new Plate(left, TOP, width, HEIGHT));
            places.add(place);
            draw(canvas, words, place, lit.contains(command), i < bare);
            left += width + gap;
        }
    }

    /** Width of all commands, px, if the first ones show their keys alone. */
    private static double taken(Canvas canvas, Words words, List<Command> commands, int bare) {
        double taken = 0;
        for (int i = 0; i < commands.size(); i++) {
            taken += width(canvas, words, commands.get(i), i < bare);
        }
        return taken;
    }

    private static double width(Canvas canvas, Words words, Command command, boolean isBare) {
        double key = canvas.textWidth(command.keyWords(words), SIZE, Canvas.Font.WORDS);
        double label = canvas.textWidth(command.words(words), SIZE, Canvas.Font.WORDS);
        return 2 * PADDING + key + (isBare ? 0 : BETWEEN + label);
    }

    private void draw(Canvas canvas, Words words, Place place, boolean isLit, boolean isBare) {
        Color ink = drawPlate(canvas, place, isLit, 8);
        String key = place.command.keyWords(words);
        double x = place.plate.x() + PADDING;
        Color keyInk = isLit || isOn(place, pointerX, pointerY) ? ink : Color.BRASS;
        Print.left(canvas, key, x, TOP + HEIGHT / 2, SIZE, keyInk);
        if (!isBare) {
            x += canvas.textWidth(key, SIZE, Canvas.Font.WORDS) + BETWEEN;
            Print.left(canvas, place.command.words(words), x, TOP + HEIGHT / 2, SIZE, ink);
        }
    }

    /** Draws the background of a button; returns the colour of the words on it. */
    private Color drawPlate(Canvas canvas, Place place, boolean isLit, double corner) {
        boolean isHot = isOn(place, pointerX, pointerY);
        Plate at = place.plate;
        Color plate = isLit ? Color.BRASS : isHot ? Color.EDGE : Color.PANEL_LIT;
        canvas.panel(at.x(), at.y(), at.width(), at.height(), corner, plate);
        return isLit ? Color.DUSK_TOP : Color.TEXT;
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
        return places.stream().filter(place -> isOn(place, x, y)).map(Place::command).findFirst();
    }
}
