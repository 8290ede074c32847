package rigibo.lab.engine;

import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.JointKind;

import java.util.ArrayList;
import java.util.List;

/** The errors of joints, computed from the bodies' positions by one measure for all engines. */
public final class LinkErrors {

    /** A point of a body in its own frame, m. */
    private record Spot(int body, double x, double y) {

        static Spot of(int number, BodyDefinition body, double worldX, double worldY) {
            double cos = Math.cos(body.angle());
            double sin = Math.sin(body.angle());
            double dx = worldX - body.x();
            double dy = worldY - body.y();
            return new Spot(number, cos * dx + sin * dy, cos * dy - sin * dx);
        }

        double worldX(World world) {
            double angle = world.angle(body);
            return world.x(body) + Math.cos(angle) * x - Math.sin(angle) * y;
        }

        double worldY(World world) {
            double angle = world.angle(body);
            return world.y(body) + Math.sin(angle) * x + Math.cos(angle) * y;
        }
    }

    /** A joint with its anchors on both bodies and, for a slide, another point of its axis on A. */
    private record Held(Link link, Spot onA, Spot onB, Spot axis) {

        double off(World world) {
            double dx = onB.worldX(world) - onA.worldX(world);
            double dy = onB.worldY(world) - onA.worldY(world);
            if (link.kind() == JointKind.DISTANCE) {
                double length = Math.hypot(link.toX() - link.x(), link.toY() - link.y());
                return link.isSpring() ? 0 : Math.abs(Math.hypot(dx, dy) - length);
            }
            if (link.kind() != JointKind.PRISMATIC && link.kind() != JointKind.WHEEL) {
                return Math.hypot(dx, dy);
            }
            double alongX = axis.worldX(world) - onA.worldX(world);
            double alongY = axis.worldY(world) - onA.worldY(world);
            return Math.abs(alongX * dy - alongY * dx) / Math.hypot(alongX, alongY);
        }
    }

    private final List<Held> all = new ArrayList<>();

    /** Measures the joints of bodies. */
    public LinkErrors(List<BodyDefinition> bodies, List<Link> links) {
        for (Link link : links) {
            BodyDefinition a = bodies.get(link.a());
            BodyDefinition b = bodies.get(link.b());
            boolean isRod = link.kind() == JointKind.DISTANCE;
            double endX = isRod ? link.toX() : link.x();
            double endY = isRod ? link.toY() : link.y();
            all.add(
                    new Held(
                            link,
                            Spot.of(link.a(), a, link.x(), link.y()),
                            Spot.of(link.b(), b, endX, endY),
                            Spot.of(link.a(), a, link.toX(), link.toY())));
        }
    }

    /** The largest present error of a joint, m. */
    public double worst(World world) {
        double worst = 0;
        for (Held held : all) {
            worst = Math.max(worst, held.off(world));
        }
        return worst;
    }
}
