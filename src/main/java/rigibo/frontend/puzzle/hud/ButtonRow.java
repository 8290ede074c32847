package rigibo.frontend.puzzle.hud;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Print;

import java.util.List;
import java.util.Optional;

/** Buttons side by side; one of them is chosen, by the pointer or by keys. */
final class ButtonRow {

    static final double HEIGHT = 36;
    private static final double GAP = 8;
    private static final double SIZE = 17;
    private static final int NONE = -1;

    private final double left;
    private final double top;
    private final double width;
    private final List<Command> commands;
    private int chosen;

    /** Buttons of equal width from (left, top), px. */
    ButtonRow(double left, double top, double width, List<Command> commands) {
        this.left = left;
        this.top = top;
        this.width = (width - (commands.size() - 1) * GAP) / commands.size();
        this.commands = List.copyOf(commands);
    }

    void draw(Canvas canvas, Words words) {
        for (int i = 0; i < commands.size(); i++) {
            double x = left + i * (width + GAP);
            boolean isChosen = i == chosen;
            Color plate = isChosen ? Color.BRASS : Color.PANEL_LIT;
            canvas.panel(x, top, width, HEIGHT, 10, plate);
            Color ink = isChosen ? Color.DUSK_TOP : Color.TEXT;
            Print.centred(
                    canvas, label(canvas, words, i), x + width / 2, top + HEIGHT / 2, SIZE, ink);
        }
    }

    /** As much of a button's words as fits, should the key in them have a long name. */
    private String label(Canvas canvas, Words words, int button) {
        String all = commands.get(button).words(words);
        return Lines.shortened(canvas, all, SIZE, Canvas.Font.WORDS, width);
    }

    /** Chooses the button under a point, if there is one. */
    Optional<Command> point(double x, double y) {
        int under = (int) Math.floor((x - left) / (width + GAP));
        boolean isOn =
                under >= 0
                        && under < commands.size()
                        && x - left - under * (width + GAP) <= width
                        && y >= top
                        && y <= top + HEIGHT;
        if (!isOn) {
            return Optional.empty();
        }
        chosen = under;
        return Optional.of(commands.get(under));
    }

    /**
     * Selects the next button (+1) or the previous one (−1), from the last on to the first; the
     * first if none was selected.
     */
    void move(int direction) {
        chosen = chosen == NONE ? 0 : Math.floorMod(chosen + direction, commands.size());
    }

    /** Selects the first button. */
    void begin() {
        chosen = 0;
    }

    /** Selects no button, since something else was selected. */
    void letGo() {
        chosen = NONE;
    }

    Optional<Command> chosen() {
        return chosen == NONE ? Optional.empty() : Optional.of(commands.get(chosen));
    }
}
