package rigibo.frontend.demo;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The tabs of a demo's plates; those of open plates are lit. */
final class Tabs {

    /** px. */
    static final double HEIGHT = 26;

    /** Between tabs, px. */
    static final double GAP = 4;

    private final Words words;
    private final Folds folds;
    private final Map<Fold, Plate> places = new EnumMap<>(Fold.class);

    Tabs(Words words, Folds folds) {
        this.words = words;
        this.folds = folds;
    }

    /** Forgets where tabs were. */
    void clear() {
        places.clear();
    }

    /** Draws a row of tabs with its upper left corner at (x, y), px, so wide. */
    void draw(Canvas canvas, List<Fold> row, double x, double y, double width) {
        double each = (width - (row.size() - 1) * GAP) / row.size();
        for (int i = 0; i < row.size(); i++) {
            Plate place = new Plate(x + i * (each + GAP), y, each, HEIGHT);
            places.put(row.get(i), place);
            draw(canvas, row.get(i), place);
        }
    }

    /** Draws tabs at places, px. */
    void draw(Canvas canvas, List<Fold> all, List<Plate> there) {
        for (int i = 0; i < all.size(); i++) {
            places.put(all.get(i), there.get(i));
            draw(canvas, all.get(i), there.get(i));
        }
    }

    private void draw(Canvas canvas, Fold fold, Plate place) {
        boolean isLit = folds.isOpen(fold);
        canvas.panel(
                place.x(),
                place.y(),
                place.width(),
                place.height(),
                8,
                isLit ? Color.BRASS : Color.PANEL);
        Print.centred(
                canvas,
                words.of(fold.key()),
                place.x() + place.width() / 2,
                place.y() + place.height() / 2,
                16,
                isLit ? Color.DUSK_TOP : Color.TEXT_DIM);
    }

    /** Tells of them, where they were last drawn. */
    void describe(Narrator narrator) {
        places.forEach(
                (fold, place) ->
                        narrator.offers(
                                place.control(
                                        words.of(fold.key()),
                                        Control.Kind.of(folds.isOpen(fold)),
                                        0.5,
                                        false)));
    }

    /** The tab at a point, px. */
    Optional<Fold> at(double px, double py) {
        return places.entrySet().stream()
                .filter(tab -> tab.getValue().contains(px, py))
                .map(Map.Entry::getKey)
                .findFirst();
    }
}
