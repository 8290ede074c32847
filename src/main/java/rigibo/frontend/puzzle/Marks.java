package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.level.Verb;
import rigibo.frontend.puzzle.rules.Link;
import rigibo.frontend.puzzle.rules.Target;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.joint.RopeLine;

import java.util.Optional;

/** Marks what a click acts on, besides boxes, which have faces. */
final class Marks {

    /** Width and opacity of the light along a rope that is pointed at. */
    private static final double LIGHT = 11;

    private static final double LIT = 0.4;

    /** Distance of the sign from the pointer, px. */
    private static final double ASIDE = 20;

    private final Session session;
    private final Camera camera;

    Marks(Session session, Camera camera) {
        this.session = session;
        this.camera = camera;
    }

    /** Draws the marks over the bodies and joints. */
    void draw(Canvas canvas, Optional<Target> meant) {
        for (Link link : session.game().links()) {
            if (link.isClickable()) {
                draw(canvas, link, meant.filter(link::equals).isPresent());
            }
        }
    }

    private void draw(Canvas canvas, Link link, boolean isMeant) {
        Verb verb = link.verb().orElseThrow();
        if (link.isRope()) {
            RopeLine line = line(link);
            if (isMeant) {
                light(canvas, line);
            }
            mark(canvas, verb, line.x(0.5), line.y(0.5), isMeant);
        } else {
            Pose at = place(link.b());
            mark(canvas, verb, at.x(), at.y(), isMeant);
        }
    }

    private void mark(Canvas canvas, Verb verb, double x, double y, boolean isMeant) {
        VerbMark.draw(canvas, verb, camera.screenX(x), camera.screenY(y), isMeant);
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

    /** Draws the sign of what a click would do beside the pointer, px. */
    static void drawAtPointer(Canvas canvas, Target meant, double x, double y) {
        if (meant instanceof Link) {
            VerbMark.draw(canvas, meant.verb().orElseThrow(), x + ASIDE, y + ASIDE, false);
        }
    }
}
