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
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Draws everything around the draft. */
final class Panes {

    /** Radius of the ring around what a problem concerns, px. */
    private static final double RING = 22;

    /** Lines that a sentence has room for below the remark, at least. */
    private static final int LINES = 2;

    private final Workshop shop;
    private final Pane pane;
    private final List<Finding> findings;
    private final List<Bar.Button> commands = new ArrayList<>();
    private final DeskPlaces places;
    private Optional<Finding> pointedAt = Optional.empty();

    Panes(Workshop shop, Pane pane, List<Finding> findings) {
        this.shop = shop;
        this.pane = pane;
        this.findings = findings;
        command("undo", shop.desk().history().canUndo(), shop::undo);
        command("redo", shop.desk().history().canRedo(), shop::redo);
        command("new", true, shop::beginNew);
        command("open", true, shop::showFiles);
        command("save", !shop.drawer().isSaved(shop.desk().draft()), shop::save);
        command("settle", true, shop::settle);
        command("test", true, shop::startTest);
        command("check", !shop.isProving(), shop::check);
        command("code", true, shop::copyCode);
        if (shop.handsOver()) {
            command("file", true, shop::handOver);
        }
        places = DeskPlaces.of(pane, commands);
    }

    private void command(String key, boolean isBright, Runnable action) {
        commands.add(new Bar.Button(key, isBright, action));
    }

    /** Gives the draft its part of the window. */
    void makeRoom() {
        shop.view().see(places.draft(), places.draft());
    }

    void draw() {
        places.plates().forEach(pane::plate);
        top();
        tools();
        FieldPane.draw(pane, places.fields(), shop.desk(), shop.typing(), new Pages());
        problems();
        EffectPane.draw(pane, places.effects(), shop.desk());
        status();
        shop.list().ifPresent(list -> list.draw(pane, places.list()));
    }

    private void tools() {
        if (places.isBeside()) {
            ToolPane.drawInRows(pane, places.tools(), shop.desk(), shop.craft(), shop::take);
        } else {
            ToolPane.draw(pane, places.tools(), shop.desk(), shop.craft(), shop::take);
        }
    }

    private void problems() {
        pointedAt = ProblemPane.draw(pane, places.problems(), findings, shop.desk()::choose);
        pointedAt
                .flatMap(finding -> shop.desk().draft().item(finding.item()))
                .ifPresent(item -> pointAt(item.toWorld(item.form().centre())));
    }

    /** Leads the eye from the problem under the pointer to the thing that it is about. */
    private void pointAt(Point at) {
        Camera camera = shop.desk().camera();
        double x = camera.screenX(at.x());
        double y = camera.screenY(at.y());
        Area list = places.problems();
        double from = x < list.middleX() ? list.x() : list.right();
        pane.canvas().line(from, pane.pointerY(), x, y, 2, Color.BRASS);
        pane.canvas().ring(x, y, RING, 3, 1, Color.BRASS);
    }

    private void top() {
        Bar bar = new Bar(pane, places.commands());
        commands.forEach(bar::button);
        String name = shop.drawer().file().map(Panes::nameOf).orElse("");
        String star = shop.drawer().isSaved(shop.desk().draft()) ? "" : "* ";
        Area rest = places.isBeside() ? bar.below(Pane.LINE) : bar.rest();
        pane.text(rest, star + name, Canvas.Align.RIGHT, Color.TEXT_DIM);
    }

    /** All levels have the same ending, for which there is no room. */
    private static String nameOf(Path file) {
        return file.getFileName().toString().replaceFirst("\\.json$", "");
    }

    private void status() {
        Area area = places.status();
        double gap = places.isBeside() ? DeskPlaces.GAP : 0;
        Area below = area.lowered(remark(area) + gap - area.y());
        Optional<Finding> finding = pointedAt.or(this::findingUnderPointer);
        Optional<String> told = told();
        if (finding.isPresent()) {
            sentence(below, ProblemPane.told(pane, finding.get()), Color.TEXT);
        } else if (told.isPresent()) {
            sentence(below, told.get(), Color.TEXT);
        } else {
            String keys = pane.words().of("editor.keys." + shop.craft().hint());
            sentence(below, keys, Color.TEXT_DIM);
        }
    }

    private double sentence(Area area, String words, Color ink) {
        return pane.lines(area, words, ink);
    }

    /** Shows a question to the author, or the last action; returns what lies below it, px. */
    private double remark(Area area) {
        Bar bar = new Bar(pane, area.resized(Pane.LINE));
        if (shop.drawer().offered().isPresent()) {
            bar.words(pane.words().of("editor.offer"), Color.BRASS);
            bar.button("offer.take", true, shop::takeUp);
            bar.button("offer.refuse", true, shop::refuse);
        } else if (shop.won().isPresent()) {
            int clicks = shop.won().get().clicks().size();
            bar.words(pane.words().of("editor.won", clicks), Color.GOOD);
            bar.button("won.keep", true, shop::keepSolution);
            if (Prize.feat(shop.desk().draft()).isPresent()) {
                bar.button("won.star", true, shop::keepForStar);
            }
            bar.button("won.leave", true, shop::forgetSolution);
        } else if (places.isBeside() && shop.remark().isEmpty()) {
            return area.y();
        } else {
            Area most = area.shortened(LINES * Pane.LINE);
            return sentence(most, shop.remark(), Color.BRASS);
        }
        return bar.below(0).y();
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
}
