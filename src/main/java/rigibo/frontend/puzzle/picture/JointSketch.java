package rigibo.frontend.puzzle.picture;

import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.scene.joint.JointPen;

/** Draws a joint as a level states it, without a pool: on cards and on the editor's desk. */
public final class JointSketch {

    private static final double PIN = 0.06;

    /** Length of the drawn strut of a wheel, and of a rail, m. */
    private static final double REACH = 0.5;

    private JointSketch() {}

    /** Draws a joint where the level places it. */
    public static void draw(JointPen pen, LevelJoint joint) {
        double x = joint.x();
        double y = joint.y();
        switch (joint.type()) {
            case HINGE -> pen.pin(x, y, PIN, 0);
            case WELD -> pen.weld(x, y, PIN, 0);
            case WHEEL -> strut(pen, joint);
            case SLIDE -> rail(pen, joint);
            case ROD -> pen.rod(x, y, joint.toX(), joint.toY());
            case ROPE -> pen.rope(x, y, joint.toX(), joint.toY(), joint.length());
            case SPRING -> pen.spring(x, y, joint.toX(), joint.toY(), joint.length());
        }
        if (joint.type().hasTwoPoints()) {
            pen.pin(x, y, PIN, 0);
            pen.pin(joint.toX(), joint.toY(), PIN, 0);
        }
    }

    private static void strut(JointPen pen, LevelJoint joint) {
        double topX = joint.x() + REACH * Math.cos(joint.axis());
        double topY = joint.y() + REACH * Math.sin(joint.axis());
        pen.spring(joint.x(), joint.y(), topX, topY, REACH);
        pen.pin(joint.x(), joint.y(), PIN, 0);
    }

    private static void rail(JointPen pen, LevelJoint joint) {
        double dx = REACH * Math.cos(joint.axis());
        double dy = REACH * Math.sin(joint.axis());
        pen.rail(joint.x() - dx, joint.y() - dy, joint.x() + dx, joint.y() + dy);
        pen.pin(joint.x(), joint.y(), PIN, 0);
    }
}
