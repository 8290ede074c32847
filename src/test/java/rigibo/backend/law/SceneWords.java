package rigibo.backend.law;

import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Material;

import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Bodies as the code that adds them. */
final class SceneWords {

    private SceneWords() {}

    static String of(BodyDefinition body) {
        return "pool.add("
                + pattern(body)
                + call("at", body.x(), body.y())
                + call("angle", body.angle())
                + call("velocity", body.velocityX(), body.velocityY())
                + call("spin", body.spin())
                + (body.statesMass() ? call("mass", body.mass()) : "")
                + (body.statesInertia() ? call("inertia", body.inertia()) : "")
                + material(body.material())
                + (body.xLocked() ? ".lockX()" : "")
                + (body.yLocked() ? ".lockY()" : "")
                + (body.rotationLocked() ? ".lockRotation()" : "")
                + filter(body.filter())
                + (body.isSensor() ? ".sensor()" : "")
                + ");";
    }

    private static String pattern(BodyDefinition body) {
        String maker =
                switch (body.type()) {
                    case DYNAMIC -> "dynamic";
                    case KINEMATIC -> "kinematic";
                    case STATIC -> "fixed";
                };
        return "BodyDefinition." + maker + "(" + shape(body.shape()) + ")";
    }

    private static String shape(Shape shape) {
        if (shape instanceof Circle circle) {
            return "new Circle(" + circle.radius() + ")";
        }
        if (shape instanceof Capsule capsule) {
            return "new Capsule(" + numbers(capsule.halfLength(), capsule.radius()) + ")";
        }
        if (shape instanceof Compound compound) {
            return IntStream.range(0, compound.parts())
                    .mapToObj(i -> part(compound.part(i)))
                    .collect(Collectors.joining(", ", "Compound.of(", ")"));
        }
        if (shape instanceof Chain chain) {
            return chain(chain);
        }
        Polygon polygon = (Polygon) shape;
        String rounded = polygon.radius() > 0 ? ".rounded(" + polygon.radius() + ")" : "";
        return "Polygon.of(" + numbers(polygon.stated()) + ")" + rounded;
    }

    private static String part(Part part) {
        return "Part.of("
                + shape(part.shape())
                + ")"
                + call("at", part.x(), part.y())
                + call("angle", part.angle())
                + (part.isSensor() ? ".sensor()" : "")
                + (part.relativeDensity() == (part.isSensor() ? 0 : 1)
                        ? ""
                        : ".relativeDensity(" + part.relativeDensity() + ")");
    }

    private static String material(Material m) {
        return ".material(new Material("
                + numbers(m.density(), m.friction(), m.elasticity())
                + ")"
                + call("oneWay", m.oneWayX(), m.oneWayY())
                + ")";
    }

    private static String filter(Filter filter) {
        return filter.equals(Filter.ALL)
                ? ""
                : String.format(
                        ".filter(new Filter(%d, %d, %d))",
                        filter.category(), filter.mask(), filter.group());
    }

    private static String chain(Chain chain) {
        String corners =
                IntStream.range(0, chain.corners())
                        .mapToObj(i -> numbers(chain.cornerX(i), chain.cornerY(i)))
                        .collect(Collectors.joining(", "));
        return "Chain." + (chain.isLoop() ? "loop(" : "open(") + corners + ")";
    }

    /** A verb of a definition; what is 0 need not be said. */
    private static String call(String verb, double... arguments) {
        boolean isDefault = Arrays.stream(arguments).allMatch(number -> number == 0);
        return isDefault ? "" : "." + verb + "(" + numbers(arguments) + ")";
    }

    private static String numbers(double... numbers) {
        return Arrays.stream(numbers).mapToObj(Double::toString).collect(Collectors.joining(", "));
    }
}
