package rigibo.frontend.editor;

import rigibo.frontend.editor.draft.Prize;
import rigibo.frontend.editor.pane.Area;
import rigibo.frontend.editor.pane.Pane;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Plate;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * The questions to an author in a handheld window, and the buttons of the tool, at the foot of the
 * draft.
 */
final class HandQuestion {

    private static final double MARGIN = 10;
    private static final double GAP = 6;

    private final Workshop shop;
    private final Pane pane;
    private final Area part;
    private final List<Answer> answers = new ArrayList<>();
    private String asked = "";

    private record Answer(String key, Runnable action) {}

    /** The questions of a workshop, which cover a part of the window. */
    HandQuestion(Workshop shop, Pane pane, Area part) {
        this.shop = shop;
        this.pane = pane;
        this.part = part;
    }

    /** Draws the question, or else the tool's buttons if there is room for them. */
    void draw(boolean hasRoom) {
        if (shop.drawer().offered().isPresent()) {
            asked = words("offer");
            answers.add(new Answer("offer.take", shop::takeUp));
            answers.add(new Answer("offer.refuse", shop::refuse));
        } else if (shop.won().isPresent()) {
            asked = words("won", shop.won().get().clicks().size());
            answers.add(new Answer("won.keep", shop::keepSolution));
            if (Prize.feat(shop.desk().draft()).isPresent()) {
                answers.add(new Answer("won.star", shop::keepForStar));
            }
            answers.add(new Answer("won.leave", shop::forgetSolution));
        } else if (hasRoom) {
            for (Key key : shop.tool().keys()) {
                String name = "hand.key." + key.name().toLowerCase(Locale.ROOT);
                answers.add(new Answer(name, () -> shop.tool().keyPressed(key)));
            }
        }
        if (!answers.isEmpty()) {
            plate();
        }
    }

    private String words(String key, Object... values) {
        return shop.words().of("editor." + key, values);
    }

    private void plate() {
        double finger = pane.canvas().layout().clickable(0);
        List<String> lines = asked.isEmpty() ? List.of() : lines();
        double height = 2 * MARGIN + lines.size() * Pane.LINE + finger;
        Area plate = new Area(part.x(), part.bottom() - height, part.width(), height);
        pane.plate(plate);
        Area inner = plate.inset(MARGIN);
        for (int i = 0; i < lines.size(); i++) {
            double y = inner.y() + i * Pane.LINE;
            Area line = new Area(inner.x(), y, inner.width(), Pane.LINE);
            pane.text(line, lines.get(i), Canvas.Align.LEFT, Color.GOOD);
        }
        Plate row = new Plate(inner.x(), inner.bottom() - finger, inner.width(), finger);
        Grid grid = Grid.of(row, answers.size(), GAP);
        for (int i = 0; i < answers.size(); i++) {
            Answer answer = answers.get(i);
            Area place = Area.of(grid.place(i));
            pane.button(place, words(answer.key), Color.PANEL_LIT, "", answer.action);
        }
    }

    private List<String> lines() {
        double width = part.width() - 3 * MARGIN;
        return Lines.of(pane.canvas(), asked, 16, Canvas.Font.WORDS, width);
    }
}
