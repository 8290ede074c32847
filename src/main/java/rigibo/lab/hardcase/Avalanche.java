package rigibo.lab.hardcase;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.lab.bench.scene.Crowd;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.bench.scene.Tumbler;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Scenes of boxes that slide and tumble over each other, which a seed makes. */
enum Avalanche {
    /** A column that has settled between two walls, which are taken away. */
    COLUMN {
        @Override
        Scene scene(int boxes, long seed) {
            List<BodyDefinition> bodies = new ArrayList<>();
            bodies.add(FLOOR);
            Polygon wall = Polygon.box(2, 100);
            double away = 0.6 * COLUMNS + 1;
            bodies.add(BodyDefinition.fixed(wall).at(-away, 50).material(Crowd.STONE));
            bodies.add(BodyDefinition.fixed(wall).at(away, 50).material(Crowd.STONE));
            bodies.addAll(Crowd.BOXES.rows(boxes, COLUMNS, 1, seed));
            List<BodyDefinition> lying = Piles.settled(bodies);
            lying.subList(1, 3).clear();
            return new Scene(Crowd.EFFECTS, lying);
        }
    },
    /** A heap that falls onto a floor and spreads. */
    HEAP {
        @Override
        Scene scene(int boxes, long seed) {
            List<BodyDefinition> bodies = new ArrayList<>();
            bodies.add(FLOOR);
            bodies.addAll(Crowd.BOXES.rows(boxes, 2 * COLUMNS, 1, seed));
            return new Scene(Crowd.EFFECTS, bodies);
        }
    },
    /** Boxes in a drum that turns. */
    DRUM {
        @Override
        Scene scene(int boxes, long seed) {
            SplittableRandom random = new SplittableRandom(seed);
            Scene drum = Tumbler.of((int) Math.round(Math.sqrt(boxes)));
            List<BodyDefinition> bodies =
                    drum.bodies().stream().map(body -> turned(body, random)).toList();
            return new Scene(drum.effects(), bodies, drum.driver());
        }
    };

    private static final int COLUMNS = 4;

    private static final BodyDefinition FLOOR = Solid.fixed(400, 2).at(0, -1).material(Crowd.STONE);

    /** The scene of a seed. */
    abstract Scene scene(int boxes, long seed);

    private static BodyDefinition turned(BodyDefinition body, SplittableRandom random) {
        boolean isBox = body.type() == BodyType.DYNAMIC;
        return isBox ? body.angle(2 * Math.PI * random.nextDouble()) : body;
    }
}
