package rigibo.backend.law;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Convex;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** Another way to look at a scene, in which the same laws hold. */
enum Symmetry {
    /** Left is right. */
    MIRROR {
        @Override
        State of(State s, double time) {
            return new State(-s.x(), s.y(), -s.angle(), -s.velocityX(), s.velocityY(), -s.spin());
        }

        @Override
        Gravity of(Gravity gravity) {
            return new Gravity(-gravity.x(), gravity.y());
        }

        /** Corners the other way round, so that they stay counter-clockwise. */
        @Override
        Polygon ofCorners(double... xy) {
            int count = xy.length / 2;
            double[] mirrored = new double[xy.length];
            for (int i = 0; i < count; i++) {
                int from = (count - i) % count;
                mirrored[2 * i] = -xy[2 * from];
                mirrored[2 * i + 1] = xy[2 * from + 1];
            }
            return Polygon.of(mirrored);
        }

        @Override
        Polygon ofBox(double width, double height) {
            return Polygon.box(width, height);
        }

        /** The other way along, so that the air stays on its right. */
        @Override
        Chain of(Chain chain) {
            Chain reversed = chain.reversed();
            double[] xy = corners(reversed);
            for (int i = 0; i < xy.length; i += 2) {
                xy[i] = -xy[i];
            }
            return chain(chain, xy);
        }

        @Override
        Part place(Part part, Part like) {
            return part.at(-like.x(), like.y()).angle(-like.angle());
        }

        @Override
        Material of(Material material) {
            return material.isOneWay()
                    ? material.oneWay(-material.oneWayX(), material.oneWayY())
                    : material;
        }
    },
    /** A quarter turn of places, shapes and gravity; angles stay, so that nothing is rounded. */
    QUARTER_TURN {
        @Override
        State of(State s, double time) {
            return new State(-s.y(), s.x(), s.angle(), -s.velocityY(), s.velocityX(), s.spin());
        }

        @Override
        Gravity of(Gravity gravity) {
            return new Gravity(-gravity.y(), gravity.x());
        }

        @Override
        boolean isLockedInX(BodyDefinition body) {
            return body.yLocked();
        }

        @Override
        boolean isLockedInY(BodyDefinition body) {
            return body.xLocked();
        }

        @Override
        Polygon ofCorners(double... xy) {
            double[] turned = new double[xy.length];
            for (int i = 0; i < xy.length; i += 2) {
                turned[i] = -xy[i + 1];
                turned[i + 1] = xy[i];
            }
            return Polygon.of(turned);
        }

        @Override
        Polygon ofBox(double width, double height) {
            return Polygon.box(height, width);
        }

        @Override
        Chain of(Chain chain) {
            double[] xy = corners(chain);
            for (int i = 0; i < xy.length; i += 2) {
                double x = xy[i];
                xy[i] = -xy[i + 1];
                xy[i + 1] = x;
            }
            return chain(chain, xy);
        }

        @Override
        Part place(Part part, Part like) {
            return part.at(-like.y(), like.x()).angle(like.angle());
        }

        @Override
        Material of(Material material) {
            return material.isOneWay()
                    ? material.oneWay(-material.oneWayY(), material.oneWayX())
                    : material;
        }
    },
    /** Lengths 64 times as large in the same time: gravity too. A power of two rounds nothing. */
    LARGE {
        @Override
        State of(State s, double time) {
            return scaled(s, FACTOR);
        }

        @Override
        double metre() {
            return FACTOR;
        }

        @Override
        Gravity of(Gravity gravity) {
            return new Gravity(FACTOR * gravity.x(), FACTOR * gravity.y());
        }

        @Override
        Shape of(Shape shape) {
            return scaled(shape, FACTOR);
        }
    },
    /** Lengths 64 times as small. */
    SMALL {
        @Override
        State of(State s, double time) {
            return scaled(s, 1 / FACTOR);
        }

        @Override
        double metre() {
            return 1 / FACTOR;
        }

        @Override
        Gravity of(Gravity gravity) {
            return new Gravity(gravity.x() / FACTOR, gravity.y() / FACTOR);
        }

        @Override
        Shape of(Shape shape) {
            return scaled(shape, 1 / FACTOR);
        }
    },
    /** Ten thousand kilometres to the right. */
    FAR_AWAY {
        @Override
        State of(State s, double time) {
            return new State(
                    s.x() + DISTANCE, s.y(), s.angle(), s.velocityX(), s.velocityY(), s.spin());
        }
    },
    /** Seen from a train: what stands still moves, kinematic, with the others. */
    MOVING {
        @Override
        State of(State s, double time) {
            return new State(
                    s.x() + TRAIN * time,
                    s.y(),
                    s.angle(),
                    s.velocityX() + TRAIN,
                    s.velocityY(),
                    s.spin());
        }

        @Override
        BodyDefinition pattern(BodyDefinition body) {
            return body.type() == BodyType.STATIC
                    ? BodyDefinition.kinematic(body.shape())
                    : super.pattern(body);
        }
    };

    private static final double FACTOR = 64;

    /** m; doubles there are 1.9e-9 m apart. */
    private static final double DISTANCE = 1e7;

    /** m/s, a power of two. */
    private static final double TRAIN = 32;

    /** m that are a metre of the original scene. */
    double metre() {
        return 1;
    }

    /** The state that belongs to another at a time. */
    abstract State of(State state, double time);

    Gravity of(Gravity gravity) {
        return gravity;
    }

    Shape of(Shape shape) {
        if (shape instanceof Polygon polygon) {
            if (polygon.radius() > 0) {
                return ofCorners(polygon.stated()).rounded(polygon.radius());
            }
            return polygon.isBox()
                    ? ofBox(2 * polygon.cornerX(2), 2 * polygon.cornerY(2))
                    : ofCorners(polygon.stated());
        }
        if (shape instanceof Chain chain) {
            return of(chain);
        }
        return shape instanceof Compound compound ? of(compound) : shape;
    }

    private Compound of(Compound compound) {
        Part[] parts = new Part[compound.parts()];
        for (int i = 0; i < parts.length; i++) {
            Part part = compound.part(i);
            parts[i] = like(part, place(Part.of((Convex) of(part.shape())), part));
        }
        return Compound.of(parts);
    }

    Chain of(Chain chain) {
        return chain;
    }

    Part place(Part part, Part like) {
        return part.at(like.x(), like.y()).angle(like.angle());
    }

    Material of(Material material) {
        return material;
    }

    Polygon ofCorners(double... xy) {
        return Polygon.of(xy);
    }

    Polygon ofBox(double width, double height) {
        return Polygon.box(width, height);
    }

    BodyDefinition pattern(BodyDefinition body) {
        return switch (body.type()) {
            case DYNAMIC -> BodyDefinition.dynamic(of(body.shape()));
            case STATIC -> BodyDefinition.fixed(of(body.shape()));
            case KINEMATIC -> BodyDefinition.kinematic(of(body.shape()));
        };
    }

    RandomScene of(RandomScene scene) {
        Map<BodyDefinition, BodyDefinition> seen = new IdentityHashMap<>();
        scene.bodies().forEach(body -> seen.put(body, of(body)));
        List<BodyDefinition> bodies =
                scene.bodies().stream().map(seen::get).collect(Collectors.toList());
        List<Link> links =
                scene.links().stream()
                        .filter(link -> seen.keySet().containsAll(link.bodies()))
                        .map(link -> link.seenBy(this, seen::get))
                        .collect(Collectors.toList());
        Effects effects = scene.effects();
        Effects turned = effects.find(Gravity.class).map(g -> effects.with(of(g))).orElse(effects);
        return scene.bodies(bodies).links(links).effects(turned);
    }

    private BodyDefinition of(BodyDefinition body) {
        State state = of(State.of(body), 0);
        return locked(body)
                .at(state.x(), state.y())
                .angle(state.angle())
                .velocity(state.velocityX(), state.velocityY())
                .spin(state.spin())
                .material(of(body.material()))
                .filter(body.filter());
    }

    private BodyDefinition locked(BodyDefinition body) {
        BodyDefinition plain = pattern(body);
        BodyDefinition inX = isLockedInX(body) ? plain.lockX() : plain;
        BodyDefinition inY = isLockedInY(body) ? inX.lockY() : inX;
        BodyDefinition locked = body.rotationLocked() ? inY.lockRotation() : inY;
        return body.isSensor() ? locked.sensor() : locked;
    }

    boolean isLockedInX(BodyDefinition body) {
        return body.xLocked();
    }

    boolean isLockedInY(BodyDefinition body) {
        return body.yLocked();
    }

    private static State scaled(State s, double factor) {
        return new State(
                factor * s.x(),
                factor * s.y(),
                s.angle(),
                factor * s.velocityX(),
                factor * s.velocityY(),
                s.spin());
    }

    private static Shape scaled(Shape shape, double factor) {
        if (shape instanceof Circle circle) {
            return new Circle(factor * circle.radius());
        }
        if (shape instanceof Capsule capsule) {
            return new Capsule(factor * capsule.halfLength(), factor * capsule.radius());
        }
        if (shape instanceof Compound compound) {
            return scaled(compound, factor);
        }
        if (shape instanceof Chain chain) {
            return chain(chain, times(corners(chain), factor));
        }
        double[] xy = times(((Polygon) shape).stated(), factor);
        double radius = ((Polygon) shape).radius();
        return radius > 0 ? Polygon.of(xy).rounded(factor * radius) : Polygon.of(xy);
    }

    private static Compound scaled(Compound compound, double factor) {
        Part[] parts = new Part[compound.parts()];
        for (int i = 0; i < parts.length; i++) {
            Part part = compound.part(i);
            Part other =
                    Part.of((Convex) scaled(part.shape(), factor))
                            .at(factor * part.x(), factor * part.y())
                            .angle(part.angle());
            parts[i] = like(part, other);
        }
        return Compound.of(parts);
    }

    /** A sensor if the part is one, and as heavy. */
    private static Part like(Part part, Part other) {
        Part same = part.isSensor() ? other.sensor() : other;
        return same.relativeDensity(part.relativeDensity());
    }

    private static double[] corners(Chain chain) {
        double[] xy = new double[2 * chain.corners()];
        for (int i = 0; i < chain.corners(); i++) {
            xy[2 * i] = chain.cornerX(i);
            xy[2 * i + 1] = chain.cornerY(i);
        }
        return xy;
    }

    private static Chain chain(Chain like, double... xy) {
        return like.isLoop() ? Chain.loop(xy) : Chain.open(xy);
    }

    private static double[] times(double[] xy, double factor) {
        for (int i = 0; i < xy.length; i++) {
            xy[i] *= factor;
        }
        return xy;
    }
}
