package rigibo.frontend.editor.pane;

import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Narrator;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The places where a press has an effect, as drawn last; later ones lie above earlier ones. */
public final class Spots {

    /**
     * A place to press.
     *
     * @param area its area
     * @param name its name; empty for a plate that only keeps presses from what lies below
     * @param kind whether it is a switch
     * @param words the sentence shown while the pointer is on it; may be empty
     * @param action what a press does
     */
    public record Spot(Area area, String name, Control.Kind kind, String words, Runnable action) {

        private Control control() {
            return new Control(
                    name, kind, area.x(), area.y(), area.width(), area.height(), 0.5, false);
        }
    }

    private final List<Spot> spots = new ArrayList<>();

    /** Nothing is drawn yet. */
    public void clear() {
        spots.clear();
    }

    void add(Area area, String name, String words, Runnable action) {
        add(area, name, Control.Kind.BUTTON, words, action);
    }

    void add(Area area, String name, Control.Kind kind, String words, Runnable action) {
        spots.add(new Spot(area, name, kind, words, action));
    }

    /** Whether something lies there, px. */
    public boolean covers(double x, double y) {
        return at(x, y).isPresent();
    }

    /** Tells of all that have a name and lie above all others in their middle. */
    public void describe(Narrator narrator) {
        for (Spot spot : spots) {
            boolean isSeen =
                    at(spot.area().middleX(), spot.area().middleY())
                            .filter(spot::equals)
                            .isPresent();
            if (isSeen && !spot.name().isEmpty()) {
                narrator.offers(spot.control());
            }
        }
    }

    /** The uppermost spot at a point, px. */
    public Optional<Spot> at(double x, double y) {
        return spots.stream()
                .filter(spot -> spot.area().contains(x, y))
                .reduce((below, above) -> above);
    }
}
