package rigibo.frontend.demo;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** The buttons of a demo in a hand. */
final class HandButtons {

    private static final HandButton[] ALL = HandButton.values();

    private final Words words;
    private List<Plate> places = List.of();

    HandButtons(Words words) {
        this.words = words;
    }

    /** Draws them at places, px, in the order of {@link HandButton}. */
    void draw(Canvas canvas, List<Plate> there, boolean isPaused) {
        places = there;
        for (HandButton button : ALL) {
            boolean isLit = isPaused && button == HandButton.PAUSE;
            Plate at = places.get(button.ordinal());
            Color plate = isLit ? Color.BRASS : Color.PANEL_LIT;
            canvas.panel(at.x(), at.y(), at.width(), at.height(), 10, plate);
            double middle = at.y() + at.height() / 2;
            Color ink = isLit ? Color.DUSK_TOP : Color.TEXT;
            Print.centred(canvas, label(button), at.x() + at.width() / 2, middle, 16, ink);
        }
    }

    private String label(HandButton button) {
        return switch (button) {
            case MENU -> words.of("puzzle.command.menu");
            case PREVIOUS -> "‹";
            case NEXT -> "›";
            case PAUSE -> words.of("puzzle.command.pause");
            case RESTART -> words.of("puzzle.command.restart");
        };
    }

    /** The button at a point, px. */
    Optional<HandButton> at(double x, double y) {
        return Arrays.stream(ALL)
                .filter(button -> button.ordinal() < places.size())
                .filter(button -> places.get(button.ordinal()).contains(x, y))
                .findFirst();
    }

    /** Holds no point until it is drawn again. */
    void hide() {
        places = List.of();
    }
}
