package rigibo.lab.bench.probe;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;

import java.util.List;

/** The floors below bodies at the start of a scene. */
final class Grounds {

    private Grounds() {}

    /**
     * For each body, the top of the highest fixed body below it, m, or 0 if there is none. The
     * bounds of the fixed bodies are used.
     */
    static double[] below(List<BodyDefinition> bodies) {
        List<Aabb> fixed =
                bodies.stream()
                        .filter(body -> body.type() == BodyType.STATIC)
                        .map(Grounds::bounds)
                        .toList();
        double[] grounds = new double[bodies.size()];
        for (int i = 0; i < grounds.length; i++) {
            BodyDefinition body = bodies.get(i);
            grounds[i] =
                    fixed.stream()
                            .filter(floor -> isBelow(floor, body))
                            .mapToDouble(floor -> floor.maxY)
                            .max()
                            .orElse(0);
        }
        return grounds;
    }

    private static boolean isBelow(Aabb floor, BodyDefinition body) {
        return floor.minX <= body.x() && body.x() <= floor.maxX && floor.maxY <= body.y();
    }

    private static Aabb bounds(BodyDefinition body) {
        Aabb bounds = new Aabb();
        double cos = Math.cos(body.angle());
        double sin = Math.sin(body.angle());
        body.shape().bounds(body.x(), body.y(), cos, sin, bounds);
        return bounds;
    }
}
