package rigibo.frontend.editor.tool;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.desk.Joining;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.Joinery;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.puzzle.picture.JointSketch;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.joint.JointPen;

import java.util.Optional;

/** Joins two items: click one and then the other, or drag from one to the other. */
public final class JointTool implements Tool {

    /** A way that no hand meant, px. */
    private static final double TREMBLING = 6;

    private final Desk desk;
    private final Joining joining;
    private final LevelJoint.Type type;
    private Optional<Joining.End> first = Optional.empty();
    private Point pressed = new Point(0, 0);
    private Point pointer = new Point(0, 0);
    private boolean isSeen;
    private boolean isFresh;

    public JointTool(Desk desk, LevelJoint.Type type) {
        this.desk = desk;
        this.type = type;
        joining = new Joining(desk);
    }

    @Override
    public void pressed(Point at) {
        moved(at);
        pressed = at;
        isFresh = first.isEmpty();
        if (isFresh) {
            first = Optional.of(joining.end(at, Optional.empty()));
        }
    }

    @Override
    public void moved(Point at) {
        pointer = at;
        isSeen = true;
    }

    @Override
    public void released(Point at) {
        moved(at);
        boolean isDragged = at.minus(pressed).length() >= desk.metres(TREMBLING);
        if (first.isPresent() && (isDragged || !isFresh)) {
            finish();
        }
        isFresh = false;
    }

    /** An end that was chosen before stays so. */
    @Override
    public void interrupted() {
        if (isFresh) {
            first = Optional.empty();
        }
    }

    /** The end under the pointer. */
    private Joining.End second() {
        return joining.end(pointer, first.flatMap(Joining.End::item));
    }

    private void finish() {
        Joining.End one = first.orElseThrow();
        Joining.End other = second();
        if (Joining.canJoin(one, other)) {
            joining.join(type, one, other);
            first = Optional.empty();
        }
    }

    @Override
    public boolean cancelled() {
        boolean isJoining = first.isPresent();
        first = Optional.empty();
        return isJoining;
    }

    @Override
    public void draw(Canvas canvas) {
        if (!isSeen) {
            return;
        }
        Joining.End under = second();
        first.ifPresent(one -> mark(canvas, one));
        mark(canvas, under);
        first.filter(one -> Joining.canJoin(one, under)).ifPresent(one -> sketch(canvas, one));
    }

    private void mark(Canvas canvas, Joining.End end) {
        Camera camera = desk.camera();
        Optional<Item> item = end.item();
        if (item.isPresent()) {
            Outlines.draw(canvas, camera, item.get(), Color.BRASS);
        } else if (first.isPresent()) {
            double radius = Joining.HOOK * camera.scale();
            double x = camera.screenX(end.at().x());
            double y = camera.screenY(end.at().y());
            canvas.disc(x, y, radius, Color.IRON);
            canvas.ring(x, y, radius + 2, 2, 1, Color.BRASS);
        }
    }

    private void sketch(Canvas canvas, Joining.End one) {
        Point to = second().at();
        JointPen pen = new JointPen(canvas, desk.camera());
        LevelJoint.of(Joinery.node(type, "", "", one.at(), to))
                .ifPresent(joint -> JointSketch.draw(pen, joint));
    }
}
