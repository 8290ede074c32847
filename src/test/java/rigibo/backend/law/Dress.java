package rigibo.backend.law;

import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Pieces;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;

import java.util.ArrayList;
import java.util.List;

/** Other shapes in place of those of every body that moves in a random scene. */
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
        Shape shape(Shape plain, int index) {
            return plain;
        }

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
    };

    /** Of what a polygon reaches, how much is its rounding. */
    private static final double ROUNDING = 0.2;

    abstract Shape shape(Shape plain, int index);

    BodyDefinition dress(BodyDefinition body, int index) {
        return body.shape(shape(body.shape(), index));
    }

    RandomScene on(RandomScene scene) {
        List<BodyDefinition> bodies = new ArrayList<>();
        for (BodyDefinition body : scene.bodies()) {
            boolean isFixed = body.type() != BodyType.DYNAMIC;
            bodies.add(isFixed ? body : dress(body, bodies.size()));
        }
        return scene.bodies(bodies);
    }
}
