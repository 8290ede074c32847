package rigibo.frontend.editor;

import rigibo.frontend.editor.desk.Finding;
import rigibo.frontend.editor.desk.Joining;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.JointEntry;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.editor.pane.Area;
import rigibo.frontend.editor.pane.Bar;
import rigibo.frontend.editor.pane.EffectPane;
import rigibo.frontend.editor.pane.FieldPane;
import rigibo.frontend.editor.pane.Pane;
import rigibo.frontend.editor.pane.ProblemPane;
import rigibo.frontend.editor.pane.Spots;
import rigibo.frontend.editor.pane.ToolPane;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.List;
import java.util.Optional;

/** Draws everything around the draft. */
final class Panes {

    private static final double ROW = 22;

    /** Height of two rows of chips, px. */
    private static final double CHIPS = 58;

    private final Workshop shop;
    private final Pane pane;
    private final List<Finding> findings;

    private Panes(Workshop shop, Pane pane, List<Finding> findings) {
        this.shop = shop;
        this.pane = pane;
        this.findings = findings;
    }

    static void draw(Workshop shop, Pane pane, List<Finding> findings) {
        Panes panes = new Panes(shop, pane, findings);
        panes.top();
        ToolPane.draw(pane, View.TOOLS, shop.desk(), shop.craft(), shop::take);
        FieldPane.draw(pane, View.FIELDS, shop.desk(), shop.typing());
        ProblemPane.draw(pane, View.PROBLEMS, findings, shop.desk()::choose);
        panes.foot();
        shop.list().ifPresent(list -> list.draw(pane, View.DRAFT.inset(20)));
    }

    private void top() {
        pane.plate(View.TOP);
        Bar bar = new Bar(pane, View.TOP.inset(7));
        bar.button("undo", shop.desk().history().canUndo(), shop::undo);
        bar.button("redo", shop.desk().history().canRedo(), shop::redo);
        bar.button("new", true, shop::beginNew);
        bar.button("open", true, shop::showFiles);
        bar.button("save", !shop.drawer().isSaved(shop.desk().draft()), shop::save);
        bar.button("test", true, shop::startTest);
        bar.button("check", !shop.isProving(), shop::check);
        bar.button("code", true, shop::copyCode);
        String name = shop.drawer().file().map(file -> file.getFileName().toString()).orElse("");
        String star = shop.drawer().isSaved(shop.desk().draft()) ? "" : "* ";
        pane.text(bar.rest(), star + name, Canvas.Align.RIGHT, Color.TEXT_DIM);
    }

    private void foot() {
        pane.plate(View.FOOT);
        Area inner = View.FOOT.inset(7);
        EffectPane.draw(pane, inner, shop.desk());
        status(line(inner, 0));
        Optional<String> told = told();
        if (told.isPresent()) {
            sentence(line(inner, 1), line(inner, 2), told.get());
        } else {
            String keys = pane.words().of("editor.keys." + hint());
            pane.text(line(inner, 1), keys, Canvas.Align.LEFT, Color.TEXT_DIM);
        }
    }

    private static Area line(Area inner, int i) {
        return new Area(inner.x(), inner.y() + CHIPS + i * ROW, inner.width(), ROW);
    }

    /** Shows a question to the author, or the last action. */
    private void status(Area line) {
        if (shop.drawer().offered().isPresent()) {
            Bar bar = new Bar(pane, line);
            bar.words(pane.words().of("editor.offer"), Color.BRASS);
            bar.button("offer.take", true, shop::takeUp);
            bar.button("offer.refuse", true, shop::refuse);
        } else if (shop.won().isPresent()) {
            int clicks = shop.won().get().clicks().size();
            Bar bar = new Bar(pane, line);
            bar.words(pane.words().of("editor.won", clicks), Color.GOOD);
            bar.button("won.keep", true, shop::keepSolution);
            bar.button("won.leave", true, shop::forgetSolution);
        } else {
            pane.text(line, shop.remark(), Canvas.Align.LEFT, Color.BRASS);
        }
    }

    private String hint() {
        return switch (shop.craft()) {
            case SELECT -> "select";
            case BOX, DISC, BALL -> "draw";
            case CORNERS -> "corners";
            case REGULAR -> "regular";
            case HINGE, WELD, WHEEL, SLIDE, ROD, ROPE, SPRING -> "joint";
        };
    }

    /** The note on what is under the pointer: a button, or an item with a problem. */
    private Optional<String> told() {
        Optional<Spots.Spot> spot = pane.spots().at(pane.pointerX(), pane.pointerY());
        if (spot.isPresent()) {
            return spot.map(Spots.Spot::words).filter(words -> !words.isEmpty());
        }
        Point at =
                new Point(
                        shop.desk().camera().worldX(pane.pointerX()),
                        shop.desk().camera().worldY(pane.pointerY()));
        String under =
                new Joining(shop.desk())
                        .at(at)
                        .map(JointEntry::pointer)
                        .or(() -> shop.desk().at(at).map(Item::pointer))
                        .orElse("-");
        return findings.stream()
                .filter(finding -> finding.item().equals(under))
                .findFirst()
                .map(finding -> ProblemPane.name(pane, finding) + ": " + finding.words());
    }

    /** Breaks the text into two lines if it is too long for one. */
    private void sentence(Area first, Area second, String words) {
        double room = first.width() - ROW;
        int end = words.length();
        while (pane.canvas().textWidth(words.substring(0, end), 16, Canvas.Font.WORDS) > room) {
            int space = words.lastIndexOf(' ', end - 1);
            end = space > 0 ? space : end - 1;
        }
        pane.text(first, words.substring(0, end), Canvas.Align.LEFT, Color.TEXT);
        pane.text(second, words.substring(end).trim(), Canvas.Align.LEFT, Color.TEXT);
    }
}
