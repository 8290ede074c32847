package rigibo.backend.law;

import rigibo.backend.effect.Sensors;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Convex;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Pieces;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;

/** Kinds of bodies other than sharp ones in one piece that collide with all others. */
enum Dress {
    /** Capsules, and polygons with round corners. */
    ROUNDED {
        @Override
        Shape shape(Shape plain, int index) {
            double reach = plain.boundingRadius();
            Outline outline = plain.outline(0);
            if (outline.isDisc() || index % 3 == 0) {
                return new Capsule(0.6 * reach, 0.4 * reach);
            }
            double[] corners = ((Polygon) plain).stated();
            for (int i = 0; i < corners.length; i++) {
                corners[i] *= 1 - ROUNDING;
            }
            return Polygon.of(corners).rounded(ROUNDING * reach);
        }
    },

    /** The same outlines in many parts, and a few with a dent. */
    IN_PARTS {
        @Override
        Shape shape(Shape plain, int index) {
            if (index % 3 == 0) {
                return Pieces.cup(plain.boundingRadius());
            }
            return Pieces.of(plain);
        }
    },

    /** Every third body kept from moving along x, y or turning, or along two of these. */
    LOCKED {
        @Override
        BodyDefinition dress(BodyDefinition body, int index) {
            return switch (index % 12) {
                case 0 -> body.lockX();
                case 3 -> body.lockY();
                case 6 -> body.lockX().lockRotation();
                case 9 -> body.lockY().lockRotation();
                default -> body;
            };
        }
    },

    /** Fixed boxes as loops of edges, many in a line. */
    ON_CHAINS {
        @Override
        BodyDefinition ground(BodyDefinition body) {
            return body.shape(loop((Polygon) body.shape()));
        }
    },

    /** A shelf in the midst that is passed from below. */
    ONE_WAY {
        @Override
        List<BodyDefinition> furniture() {
            return List.of(SHELF);
        }
    },

    /** Two of three kinds of bodies that pass each other. */
    FILTERED {
        @Override
        BodyDefinition dress(BodyDefinition body, int index) {
            return filtered(body, index);
        }
    },

    /** A sensor in the midst, and every fourth body with one round it. */
    SENSED {
        @Override
        Shape shape(Shape plain, int index) {
            return index % 4 == 0 ? sensing(plain) : plain;
        }

        @Override
        List<BodyDefinition> furniture() {
            return List.of(SENSOR);
        }

        @Override
        boolean senses() {
            return true;
        }
    },

    /** All of these at once, but for locks. */
    OF_ALL_KINDS {
        @Override
        Shape shape(Shape plain, int index) {
            return switch (index % 4) {
                case 0 -> sensing(plain);
                case 1 -> ROUNDED.shape(plain, index);
                case 2 -> IN_PARTS.shape(plain, index);
                default -> plain;
            };
        }

        @Override
        BodyDefinition dress(BodyDefinition body, int index) {
            return filtered(super.dress(body, index), index);
        }

        @Override
        BodyDefinition ground(BodyDefinition body) {
            return ON_CHAINS.ground(body);
        }

        @Override
        List<BodyDefinition> furniture() {
            return List.of(SHELF, SENSOR);
        }

        @Override
        boolean senses() {
            return true;
        }
    };

    /** Share of a polygon's reach that is its rounding. */
    private static final double ROUNDING = 0.2;

    /** Edges in line along each side of a loop. */
    private static final int EDGES = 16;

    private static final BodyDefinition SHELF =
            BodyDefinition.fixed(Polygon.box(2, 0.25))
                    .at(0.3, 1.5)
                    .material(new Material(1, 0.6, 0.1).oneWay(0, 1));

    private static final BodyDefinition SENSOR =
            BodyDefinition.fixed(Polygon.box(2, 2)).at(0.25, 1).sensor();

    Shape shape(Shape plain, int index) {
        return plain;
    }

    BodyDefinition dress(BodyDefinition body, int index) {
        return body.shape(shape(body.shape(), index));
    }

    BodyDefinition ground(BodyDefinition body) {
        return body;
    }

    /** What comes after whatever leads the scene and stands. */
    List<BodyDefinition> furniture() {
        return List.of();
    }

    boolean senses() {
        return false;
    }

    RandomScene on(RandomScene scene) {
        List<BodyDefinition> bodies = new ArrayList<>();
        int standing = standing(scene);
        for (BodyDefinition body : scene.bodies().subList(0, standing)) {
            bodies.add(ground(body));
        }
        bodies.addAll(furniture());
        for (BodyDefinition body : scene.bodies().subList(standing, scene.bodies().size())) {
            bodies.add(dress(body, bodies.size()));
        }
        RandomScene dressed = scene.bodies(bodies);
        return senses() ? dressed.effects(scene.effects().with(new Sensors())) : dressed;
    }

    /** How many bodies come before the first that moves. */
    static int standing(RandomScene scene) {
        int count = 0;
        while (count < scene.bodies().size()
                && scene.bodies().get(count).type() != BodyType.DYNAMIC) {
            count++;
        }
        return count;
    }

    private static BodyDefinition filtered(BodyDefinition body, int index) {
        return switch (index % 3) {
            case 0 -> body.filter(Filter.ALL.category(2).mask(~4));
            case 1 -> body.filter(Filter.ALL.category(4));
            default -> body;
        };
    }

    private static Shape sensing(Shape plain) {
        Part round = Part.of(new Circle(1.5 * plain.boundingRadius())).sensor();
        return Compound.of(Part.of((Convex) plain), round);
    }

    private static Chain loop(Polygon box) {
        double[] xy = new double[2 * EDGES * box.corners()];
        for (int corner = 0; corner < box.corners(); corner++) {
            int next = (corner + 1) % box.corners();
            for (int i = 0; i < EDGES; i++) {
                double share = (double) i / EDGES;
                int at = 2 * (corner * EDGES + i);
                xy[at] = box.cornerX(corner) * (1 - share) + box.cornerX(next) * share;
                xy[at + 1] = box.cornerY(corner) * (1 - share) + box.cornerY(next) * share;
            }
        }
        return Chain.loop(xy);
    }
}
