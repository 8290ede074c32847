package rigibo.frontend.editor;

import rigibo.frontend.editor.desk.Finding;
import rigibo.frontend.editor.desk.Joining;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.JointEntry;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.editor.draft.Prize;
import rigibo.frontend.editor.pane.Area;
import rigibo.frontend.editor.pane.Bar;
import rigibo.frontend.editor.pane.EffectPane;
import rigibo.frontend.editor.pane.FieldPane;
import rigibo.frontend.editor.pane.Pages;
import rigibo.frontend.editor.pane.Pane;
import rigibo.frontend.editor.pane.ProblemPane;
import rigibo.frontend.editor.pane.Spots;
import rigibo.frontend.editor.pane.ToolPane;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Draws everything around the draft. */
final class Panes {

    private static final double ROW = 22;

    /** Heights of the plates at the top and at the foot, px. */
    private static final double MARGIN = 7;

    /** Radius of the ring around what a problem concerns, px. */
    private static final double RING = 22;

    /** Below the chips of the effects, px. */
    private static final double GAP = 3;

    /** Height of the lines below the chips, with their margins, px. */
    private static final double LINES = 79;

    private final Workshop shop;
    private final Pane pane;
    private final List<Finding> findings;

    /** The foot, and how much higher it is than usual: as the chips of the effects need, px. */
    private final Area foot;

    private final double risen;
    private Optional<Finding> pointedAt = Optional.empty();

    private Panes(Workshop shop, Pane pane, List<Finding> findings) {
        this.shop = shop;
        this.pane = pane;
        this.findings = findings;
        double chips = EffectPane.height(pane, View.FOOT.inset(MARGIN));
        risen = chips + LINES - View.FOOT.height();
        foot = View.FOOT.raised(risen);
    }

    static void draw(Workshop shop, Pane pane, List<Finding> findings) {
        Panes panes = new Panes(shop, pane, findings);
        panes.top();
        ToolPane.draw(
                pane, View.TOOLS.shortened(panes.risen), shop.desk(), shop.craft(), shop::take);
        FieldPane.draw(pane, View.FIELDS, shop.desk(), shop.typing(), new Pages());
        panes.problems();
        panes.foot();
        shop.list().ifPresent(list -> list.draw(pane, View.DRAFT.inset(20)));
    }

    private void problems() {
        pointedAt =
                ProblemPane.draw(
                        pane, View.PROBLEMS.shortened(risen), findings, shop.desk()::choose);
        pointedAt
                .flatMap(finding -> shop.desk().draft().item(finding.item()))
                .ifPresent(item -> pointAt(item.toWorld(item.form().centre())));
    }

    /** Selects the thing that the problem under the pointer is about. */
    private void pointAt(Point at) {
        Camera camera = shop.desk().camera();
        double x = camera.screenX(at.x());
        double y = camera.screenY(at.y());
        pane.canvas().line(View.PROBLEMS.x(), pane.pointerY(), x, y, 2, Color.BRASS);
        pane.canvas().ring(x, y, RING, 3, 1, Color.BRASS);
    }

    private void top() {
        pane.plate(View.TOP);
        Bar bar = new Bar(pane, View.TOP.inset(MARGIN));
        bar.button("undo", shop.desk().history().canUndo(), shop::undo);
        bar.button("redo", shop.desk().history().canRedo(), shop::redo);
        bar.button("new", true, shop::beginNew);
        bar.button("open", true, shop::showFiles);
        bar.button("save", !shop.drawer().isSaved(shop.desk().draft()), shop::save);
        bar.button("settle", true, shop::settle);
        bar.button("test", true, shop::startTest);
        bar.button("check", !shop.isProving(), shop::check);
        bar.button("code", true, shop::copyCode);
        if (shop.handsOver()) {
            bar.button("file", true, shop::handOver);
        }
        String name = shop.drawer().file().map(Panes::nameOf).orElse("");
        String star = shop.drawer().isSaved(shop.desk().draft()) ? "" : "* ";
        pane.text(bar.rest(), star + name, Canvas.Align.RIGHT, Color.TEXT_DIM);
    }

    /** All levels have the same ending, for which there is no room. */
    private static String nameOf(Path file) {
        return file.getFileName().toString().replaceFirst("\\.json$", "");
    }

    private void foot() {
        pane.plate(foot);
        Area inner = foot.inset(MARGIN);
        EffectPane.draw(pane, inner, shop.desk());
        status(line(inner, 0));
        Optional<Finding> finding = pointedAt.or(this::findingUnderPointer);
        Optional<String> told = told();
        if (finding.isPresent()) {
            String plain = ProblemPane.told(pane, finding.get());
            sentence(line(inner, 1), line(inner, 2), plain, Color.TEXT);
        } else if (told.isPresent()) {
            sentence(line(inner, 1), line(inner, 2), told.get(), Color.TEXT);
        } else {
            String keys = pane.words().of("editor.keys." + shop.craft().hint());
            sentence(line(inner, 1), line(inner, 2), keys, Color.TEXT_DIM);
        }
    }

    private Area line(Area inner, int i) {
        double top = inner.y() + EffectPane.height(pane, inner) + GAP;
        return new Area(inner.x(), top + i * ROW, inner.width(), ROW);
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
            if (Prize.feat(shop.desk().draft()).isPresent()) {
                bar.button("won.star", true, shop::keepForStar);
            }
            bar.button("won.leave", true, shop::forgetSolution);
        } else {
            pane.text(line, shop.remark(), Canvas.Align.LEFT, Color.BRASS);
        }
    }

    /** The note on the button under the pointer. */
    private Optional<String> told() {
        return pane.spots()
                .at(pane.pointerX(), pane.pointerY())
                .map(Spots.Spot::words)
                .filter(words -> !words.isEmpty());
    }

    /** The problem of the thing under the pointer on the desk. */
    private Optional<Finding> findingUnderPointer() {
        if (pane.spots().at(pane.pointerX(), pane.pointerY()).isPresent()) {
            return Optional.empty();
        }
        Camera camera = shop.desk().camera();
        Point at = new Point(camera.worldX(pane.pointerX()), camera.worldY(pane.pointerY()));
        String under =
                new Joining(shop.desk())
                        .at(at)
                        .map(JointEntry::pointer)
                        .or(() -> shop.desk().at(at).map(Item::pointer))
                        .orElse("-");
        return findings.stream().filter(finding -> finding.item().equals(under)).findFirst();
    }

    /** Breaks the text into two lines if it is too long for one. */
    private void sentence(Area first, Area second, String words, Color ink) {
        double room = first.width() - ROW;
        int end = words.length();
        while (pane.canvas().textWidth(words.substring(0, end), 16, Canvas.Font.WORDS) > room) {
            int space = words.lastIndexOf(' ', end - 1);
            end = space > 0 ? space : end - 1;
        }
        pane.text(first, words.substring(0, end), Canvas.Align.LEFT, ink);
        pane.text(second, words.substring(end).trim(), Canvas.Align.LEFT, ink);
    }
}
