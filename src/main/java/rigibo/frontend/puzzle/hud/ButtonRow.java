package rigibo.frontend.puzzle.hud;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;

import java.util.List;
import java.util.Optional;

/** Buttons side by side; one of them is selected, by pointer or keys. */
final class ButtonRow {

    static final double HEIGHT = 36;
    static final double GAP = 8;
    private static final double SIZE = 17;
    private static final int NONE = -1;

    private final Grid grid;
    private final List<Command> commands;
    private int chosen;

    /** Buttons of equal width from (left, top), px. */
    ButtonRow(double left, double top, double width, List<Command> commands) {
        this(Grid.of(new Plate(left, top, width, HEIGHT), commands.size(), GAP), commands);
    }

    /** Buttons at the places of a grid. */
    ButtonRow(Grid grid, List<Command> commands) {
        this.grid = grid;
        this.commands = List.copyOf(commands);
    }

    /** Returns these buttons at other places, with the same selection. */
    ButtonRow at(Grid places) {
        ButtonRow moved = new ButtonRow(places, commands);
        moved.chosen = chosen;
        return moved;
    }

    void draw(Canvas canvas, Words words) {
        for (int i = 0; i < commands.size(); i++) {
            Plate at = grid.place(i);
            boolean isChosen = i == chosen;
            Color plate = isChosen ? Color.BRASS : Color.PANEL_LIT;
            canvas.panel(at.x(), at.y(), at.width(), at.height(), 10, plate);
            Color ink = isChosen ? Color.DUSK_TOP : Color.TEXT;
            double middle = at.y() + at.height() / 2;
            Print.centred(
                    canvas, label(canvas, words, i), at.x() + at.width() / 2, middle, SIZE, ink);
        }
    }

    /** Describes the buttons to a screen reader. */
    void describe(Narrator narrator, Words words) {
        for (int i = 0; i < commands.size(); i++) {
            narrator.offers(grid.place(i).button(commands.get(i).shortWords(words), i == chosen));
        }
    }

    /** The words of a button, shortened if the name of its key is long. */
    private String label(Canvas canvas, Words words, int button) {
        Command command = commands.get(button);
        String all = canvas.layout().isInHand() ? command.shortWords(words) : command.words(words);
        return Lines.shortened(canvas, all, SIZE, Canvas.Font.WORDS, grid.first().width());
    }

    /** Chooses the button under a point, if there is one. */
    Optional<Command> point(double x, double y) {
        for (int i = 0; i < commands.size(); i++) {
            if (grid.place(i).contains(x, y)) {
                chosen = i;
                return Optional.of(commands.get(i));
            }
        }
        return Optional.empty();
    }

    /**
     * Selects the next button (+1) or the previous one (−1); after the last comes the first, which
     * is also selected if none was.
     */
    void move(int direction) {
        chosen = chosen == NONE ? 0 : Math.floorMod(chosen + direction, commands.size());
    }

    /** Selects the first button. */
    void begin() {
        chosen = 0;
    }

    /** Clears the selection, since something else was selected. */
    void letGo() {
        chosen = NONE;
    }

    Optional<Command> chosen() {
        return chosen == NONE ? Optional.empty() : Optional.of(commands.get(chosen));
    }
}
