package rigibo.frontend.editor;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.desk.Finding;
import rigibo.frontend.editor.draft.Box;
import rigibo.frontend.editor.draft.Decimal;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.Grid;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.JointEntry;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.editor.pane.ProblemPane;
import rigibo.frontend.editor.tool.Outlines;
import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.puzzle.level.Platform;
import rigibo.frontend.puzzle.picture.Goal;
import rigibo.frontend.puzzle.picture.JointSketch;
import rigibo.frontend.puzzle.picture.Part;
import rigibo.frontend.puzzle.picture.Skins;
import rigibo.frontend.puzzle.picture.VerbMark;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.joint.JointPen;

import tools.jackson.databind.JsonNode;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Draws the draft: its world, its items, the selection and the problems. */
final class DeskView {

    /** Distance on the screen below which grid lines would hide the world, px. */
    private static final double LEAST_PITCH = 14;

    /**
     * Possible distances of grid lines, m; the finest that is wide enough on the screen is drawn.
     */
    private static final double[] PITCHES = {0.05, 0.25, 0.5, 1, 5};

    /** Radius of the ring around an anchor, and of the icon above it, px. */
    private static final double RING = 9;

    private static final double ICON = 10;

    private static final Color LINES = Color.TEXT.alpha(0.08);

    private final Canvas canvas;
    private final Desk desk;
    private final Camera camera;

    private DeskView(Canvas canvas, Desk desk) {
        this.canvas = canvas;
        this.desk = desk;
        camera = desk.camera();
    }

    static void draw(Canvas canvas, Desk desk, List<Finding> findings) {
        DeskView view = new DeskView(canvas, desk);
        canvas.camera(view.camera);
        view.drawItems();
        view.drawJoints();
        view.drawWorld();
        view.drawMarks(findings);
    }

    private void drawItems() {
        Draft draft = desk.draft();
        canvas.gaze(Decimal.read(draft.at("/ball/x"), 0), Decimal.read(draft.at("/ball/y"), 0));
        List<Part> bodies =
                draft.items().stream()
                        .filter(item -> item.kind() == Item.Kind.BODY)
                        .flatMap(item -> part(item).stream())
                        .toList();
        for (Item item : draft.items()) {
            part(item)
                    .ifPresentOrElse(
                            part -> drawItem(item, part, bodies),
                            () -> Outlines.draw(canvas, camera, item, skin(item).color));
        }
    }

    private static Skin skin(Item item) {
        return Skins.of(item.substance());
    }

    private static Optional<Part> part(Item item) {
        Point at = item.toWorld(item.form().centre());
        double angle = Math.toRadians(item.degrees());
        return item.form().shape().map(shape -> new Part(shape, at.x(), at.y(), angle, skin(item)));
    }

    private void drawItem(Item item, Part part, List<Part> bodies) {
        if (item.form() instanceof Box box && item.kind() == Item.Kind.PLATFORM) {
            Platform goal =
                    new Platform(part.x(), part.y(), box.width(), box.height(), part.angle());
            new Goal(goal, bodies).draw(canvas);
        } else {
            part.draw(canvas);
        }
    }

    private void drawJoints() {
        JointPen pen = new JointPen(canvas, camera);
        for (JsonNode node : desk.draft().at("/joints")) {
            LevelJoint.of(node).ifPresent(joint -> draw(pen, joint));
        }
        for (Item item : desk.draft().items()) {
            Reaches.draw(canvas, camera, item);
            Point at = item.toWorld(item.form().centre());
            item.verb().ifPresent(v -> VerbMark.draw(canvas, camera, v, at.x(), at.y()));
        }
        desk.joint().ifPresent(joint -> rings(joint, Color.TEXT));
    }

    private void draw(JointPen pen, LevelJoint joint) {
        JointSketch.draw(pen, joint);
        joint.verb().ifPresent(verb -> VerbMark.draw(canvas, camera, verb, joint));
    }

    private void rings(JointEntry joint, Color color) {
        for (String anchor : joint.anchors()) {
            Point at = joint.point(anchor);
            canvas.ring(camera.screenX(at.x()), camera.screenY(at.y()), RING, 2.5, 1, color);
        }
    }

    private void drawWorld() {
        double width = Decimal.read(desk.draft().at("/world/width"), 0);
        double height = Decimal.read(desk.draft().at("/world/height"), 0);
        double left = camera.screenX(0);
        double top = camera.screenY(height);
        double right = camera.screenX(width);
        double bottom = camera.screenY(0);
        water(left, right, bottom);
        if (desk.grid() == Grid.ON) {
            double pitch = pitch();
            for (int i = 1; i * pitch < width; i++) {
                double x = camera.screenX(i * pitch);
                canvas.line(x, top, x, bottom, 1, LINES);
            }
            for (int i = 1; i * pitch < height; i++) {
                double y = camera.screenY(i * pitch);
                canvas.line(left, y, right, y, 1, LINES);
            }
        }
        canvas.frame(left, top, right - left, bottom - top, 0, Color.EDGE);
    }

    private void water(double left, double right, double bottom) {
        double surface = Decimal.read(desk.draft().at("/world/water/level"), 0);
        if (surface > 0) {
            double y = camera.screenY(surface);
            canvas.panel(left, y, right - left, bottom - y, 0, Color.ICE.alpha(0.22));
        }
    }

    private double pitch() {
        for (double pitch : PITCHES) {
            if (pitch * camera.scale() >= LEAST_PITCH) {
                return pitch;
            }
        }
        return PITCHES[PITCHES.length - 1];
    }

    /**
     * Draws the outline of the selection, and above it an outline and an icon on items with
     * problems.
     */
    private void drawMarks(List<Finding> findings) {
        desk.item().ifPresent(item -> Outlines.draw(canvas, camera, item, Color.TEXT));
        Map<String, Finding> worst = new HashMap<>();
        findings.forEach(finding -> worst.putIfAbsent(finding.item(), finding));
        for (JointEntry joint : JointEntry.all(desk.draft())) {
            Finding finding = worst.get(joint.pointer());
            if (finding != null) {
                rings(joint, finding.problem().isError() ? Color.BAD : Color.BRASS);
                Point from = joint.point(joint.anchors().get(0));
                double y = camera.screenY(from.y()) - RING - ICON;
                ProblemPane.icon(canvas, camera.screenX(from.x()), y, finding);
            }
        }
        for (Item item : desk.draft().items()) {
            Finding finding = worst.get(item.pointer());
            if (finding != null) {
                Color color = finding.problem().isError() ? Color.BAD : Color.BRASS;
                Outlines.draw(canvas, camera, item, color);
                Point place = item.toWorld(item.form().centre());
                ProblemPane.icon(
                        canvas, camera.screenX(place.x()), camera.screenY(place.y()), finding);
            }
        }
    }
}
