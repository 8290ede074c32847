package rigibo.frontend.editor.pane;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The places where a press has an effect, as drawn last; later ones lie above earlier ones. */
public final class Spots {

    /**
     * A place to press.
     *
     * @param area where
     * @param words what is told while the pointer is on it; empty for nothing
     * @param action what a press does
     */
    public record Spot(Area area, String words, Runnable action) {}

    private final List<Spot> spots = new ArrayList<>();

    /** Nothing is drawn yet. */
    public void clear() {
        spots.clear();
    }

    void add(Area area, String words, Runnable action) {
        spots.add(new Spot(area, words, action));
    }

    /** The uppermost spot at a point, px. */
    public Optional<Spot> at(double x, double y) {
        return spots.stream()
                .filter(spot -> spot.area().contains(x, y))
                .reduce((below, above) -> above);
    }
}
