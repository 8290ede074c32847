package rigibo.frontend.puzzle.show;

import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.puzzle.level.Verb;
import rigibo.frontend.puzzle.picture.VerbMark;
import rigibo.frontend.puzzle.rules.Link;
import rigibo.frontend.puzzle.rules.Piece;
import rigibo.frontend.puzzle.rules.Target;
import rigibo.frontend.puzzle.session.Pose;
import rigibo.frontend.puzzle.session.Session;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.joint.JointPen;
import rigibo.frontend.scene.joint.RopeLine;

import java.util.Optional;

/** Marks the targets of clicks, except boxes, which have faces. */
final class Marks {

    /** Width and opacity of the light along a rope under the pointer. */
    private static final double LIGHT = 11;

    private static final double LIT = 0.4;

    /** Distance of the sign from the pointer, px. */
    private static final double ASIDE = 20;

    /** Radius of the arrow about a motor, m. */
    private static final double TURN = 0.21;

    /** Distance of the tip of a rail's arrow from the sign, and length of its head, px. */
    private static final double ARROW = 27;

    private static final double HEAD = 8;

    private final Session session;
    private final Camera camera;

    Marks(Session session, Camera camera) {
        this.session = session;
        this.camera = camera;
    }

    /** Draws the marks over the bodies and joints. */
    void draw(Canvas canvas, Optional<Target> meant) {
        for (Target target : session.game().targets()) {
            if (target.isClickable() && !target.is(Verb.DELETE)) {
                draw(canvas, target, meant.filter(target::equals).isPresent());
            }
        }
    }

    private void draw(Canvas canvas, Target target, boolean isMeant) {
        if (target instanceof Piece piece) {
            Pose at = session.pose(piece.body());
            mark(canvas, target, at.x(), at.y(), isMeant);
        } else if (target instanceof Link link) {
            draw(canvas, link, isMeant);
        }
    }

    private void draw(Canvas canvas, Link link, boolean isMeant) {
        if (link.isRope()) {
            RopeLine line = line(link);
            if (isMeant) {
                light(canvas, line);
            }
            mark(canvas, link, line.x(0.5), line.y(0.5), isMeant);
            return;
        }
        Pose at = place(link.b());
        if (link.is(Verb.SWITCH)) {
            direction(canvas, link, at);
        }
        mark(canvas, link, at.x(), at.y(), isMeant);
    }

    private void mark(Canvas canvas, Target target, double x, double y, boolean isMeant) {
        double screenX = camera.screenX(x);
        double screenY = camera.screenY(y);
        Verb verb = target.verb().orElseThrow();
        VerbMark.draw(canvas, verb, target.isOn(), screenX, screenY, isMeant);
    }

    /**
     * Draws the direction of a motor, grey while it is off. A turning motor shows its direction by
     * itself.
     */
    private void direction(Canvas canvas, Link link, Pose at) {
        double speed = link.definition().settings().motor().speed();
        Color color = link.isOn() ? Color.GOOD : Color.EDGE;
        if (link.definition().type() == LevelJoint.Type.SLIDE) {
            Pose rail = session.pose(link.a().body());
            double axis = link.definition().axis() + rail.angle();
            arrow(canvas, at, speed < 0 ? axis + Math.PI : axis, color);
        } else if (!link.isOn()) {
            new JointPen(canvas, camera).motor(at.x(), at.y(), TURN, at.angle(), speed, color);
        }
    }

    private void arrow(Canvas canvas, Pose at, double angle, Color color) {
        double dx = Math.cos(angle);
        double dy = -Math.sin(angle);
        double x = camera.screenX(at.x()) + ARROW * dx;
        double y = camera.screenY(at.y()) + ARROW * dy;
        for (int side = -1; side <= 1; side += 2) {
            double backX = x - HEAD * (dx - side * dy);
            double backY = y - HEAD * (dy + side * dx);
            canvas.line(backX, backY, x, y, 4, color);
        }
    }

    private void light(Canvas canvas, RopeLine line) {
        double[] xy = line.points();
        for (int i = 0; i < xy.length; i += 2) {
            xy[i] = camera.screenX(xy[i]);
            xy[i + 1] = camera.screenY(xy[i + 1]);
        }
        canvas.curve(xy, xy.length / 2, LIGHT, Color.BAD.alpha(LIT));
    }

    /** The line of a rope whose bodies are drawn between two steps. */
    private RopeLine line(Link link) {
        Pose a = place(link.a());
        Pose b = place(link.b());
        return RopeLine.hanging(a.x(), a.y(), b.x(), b.y(), link.definition().length());
    }

    private Pose place(Link.Anchor anchor) {
        return session.pose(anchor.body()).at(anchor.localX(), anchor.localY());
    }

    /** Draws the sign of a click's action beside the pointer, px. */
    static void drawAtPointer(Canvas canvas, Target meant, double x, double y) {
        Verb verb = meant.verb().orElseThrow();
        if (verb != Verb.DELETE) {
            VerbMark.draw(canvas, verb, meant.isOn(), x + ASIDE, y + ASIDE, false);
        }
    }
}
