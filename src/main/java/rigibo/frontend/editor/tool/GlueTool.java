package rigibo.frontend.editor.tool;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.draft.Gluing;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.Optional;

/** Makes two bodies one: click the one that stays, then the one that becomes part of it. */
public final class GlueTool implements Tool {

    private final Desk desk;
    private String first = "";
    private Point pointer = new Point(0, 0);

    public GlueTool(Desk desk) {
        this.desk = desk;
    }

    @Override
    public void pressed(Point at) {
        pointer = at;
    }

    @Override
    public void released(Point at) {
        pointer = at;
        Optional<Item> under = under();
        Optional<Item> keeper = keeper();
        if (keeper.isEmpty()) {
            first = under.map(Item::pointer).orElse("");
        } else if (under.filter(other -> Gluing.canGlue(keeper.get(), other)).isPresent()) {
            desk.glue(keeper.get(), under.get());
            first = desk.chosen();
        }
    }

    @Override
    public void moved(Point at) {
        pointer = at;
    }

    /** The body that was chosen as the first stays so. */
    @Override
    public void interrupted() {}

    private Optional<Item> keeper() {
        return first.isEmpty() ? Optional.empty() : desk.draft().item(first);
    }

    private Optional<Item> under() {
        return desk.at(pointer).filter(item -> item.kind() == Item.Kind.BODY);
    }

    @Override
    public boolean cancelled() {
        boolean isGluing = !first.isEmpty();
        first = "";
        return isGluing;
    }

    @Override
    public void draw(Canvas canvas) {
        keeper().ifPresent(one -> Outlines.draw(canvas, desk.camera(), one, Color.BRASS));
        boolean isFirst = keeper().isEmpty();
        under().filter(item -> isFirst || Gluing.canGlue(keeper().orElseThrow(), item))
                .ifPresent(item -> Outlines.draw(canvas, desk.camera(), item, Color.BRASS));
    }
}
