package rigibo.backend;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sensors;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Material;

import java.util.Random;

/** Scenes that several tests of the engine run. */
enum Scenes {
    /** Ten boxes on each other, sleep off. */
    STACK {
        @Override
        Pool build() {
            Pool pool = restless();
            addFloor(pool);
            for (int i = 0; i < 10; i++) {
                pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, i + 0.5));
            }
            return pool;
        }
    },
    /** Three hundred discs poured into a tray, sleep off. */
    FLOOD {
        @Override
        Pool build() {
            Pool pool = restless();
            addTray(pool);
            Random random = new Random(SEED);
            for (int i = 0; i < 300; i++) {
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.2 + 0.1 * random.nextDouble()))
                                .at(i % 15 - 7, 1 + i / 15)
                                .material(new Material(1, 0.3, 0.2)));
            }
            return pool;
        }
    },
    /** Balls that bounce in a tray without loss. */
    ELASTIC_BALLS {
        @Override
        Pool build() {
            Pool pool = restless();
            addTray(pool);
            for (int i = 0; i < 12; i++) {
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.3))
                                .at(i - 5.5, 3 + 0.37 * i)
                                .material(new Material(1, 0, 1)));
            }
            return pool;
        }
    },
    /** Boxes, polygons and discs in a heap that falls asleep. */
    SLEEPERS {
        @Override
        Pool build() {
            Pool pool = new Pool();
            addTray(pool);
            addMixture(pool, 30);
            return pool;
        }
    },
    /** The same without sleep, tumbling. */
    MIXTURE {
        @Override
        Pool build() {
            Pool pool = restless();
            addTray(pool);
            addMixture(pool, 60);
            return pool;
        }
    },
    /** Half of it where nothing turns. */
    STRAIGHT {
        @Override
        Pool build() {
            Pool pool = new Pool(usualWithoutSleep().without(Rotation.class), Accuracy.GAME);
            addTray(pool);
            addMixture(pool, 30);
            return pool;
        }
    },
    /** The mixture in gusts, over a pond, under a whirl, on a floor that runs. */
    WEATHER {
        @Override
        Pool build() {
            Pool pool =
                    new Pool(
                            usualWithoutSleep()
                                    .with(new Drag())
                                    .with(new AirDrag(0.2, 1))
                                    .with(new Wind(3, 1, StrictMath::sin))
                                    .with(new CentralForce(0, 4, 2, 1))
                                    .with(new Field(at -> at.push(-at.y, at.x)))
                                    .with(new Buoyancy(1, 2, 1))
                                    .with(new SurfaceSpeed())
                                    .with(new Thrust()),
                            Accuracy.GAME);
            addTray(pool);
            addMixture(pool, 30);
            pool.bodies().get(0).material(new Material(1, 0.5, 0.3).surfaceSpeed(1));
            return pool;
        }
    },
    /** A chain of ten links that swings, and a car on springs that a motor drives. */
    JOINTED {
        @Override
        Pool build() {
            Pool pool = new Pool(usualWithoutSleep().with(new Joints()), Accuracy.GAME);
            RigidBody before = addFloor(pool);
            for (int i = 0; i < 10; i++) {
                BodyDefinition link = BodyDefinition.dynamic(Polygon.box(0.4, 0.1));
                RigidBody next = pool.add(link.at(0.4 * i - 9.8, 8));
                pool.join(RevoluteJoint.at(before, next, 0.4 * i - 10, 8));
                before = next;
            }
            RigidBody chassis =
                    pool.add(BodyDefinition.dynamic(Polygon.box(2, 0.5)).at(3, 1).mass(10));
            for (int side = -1; side <= 1; side += 2) {
                double x = 3 + 0.8 * side;
                BodyDefinition wheel = BodyDefinition.dynamic(new Circle(0.3));
                RigidBody added = pool.add(wheel.at(x, 0.5).mass(1));
                pool.join(
                        WheelJoint.at(chassis, added, x, 0.5, Math.PI / 2)
                                .limits(-0.2, 0.2)
                                .spring(4, 0.7)
                                .motor(side, 20));
            }
            return pool;
        }
    },
    /** All kinds of shapes in a bowl of edges, stirred: filters, locks, a shelf, sensors. */
    KINDS {
        @Override
        Pool build() {
            Effects effects = usualWithoutSleep().with(new Sensors());
            Pool pool = new Pool(effects, Accuracy.GAME);
            pool.add(BodyDefinition.fixed(Chain.open(9, 30, 9, 0, 4, -1, -4, -1, -9, 0, -9, 30)));
            Material oneWay = Material.DEFAULT.oneWay(0, 1);
            pool.add(BodyDefinition.fixed(Polygon.box(4, 0.3)).at(-5, 2).material(oneWay));
            pool.add(BodyDefinition.fixed(Polygon.box(4, 4)).at(5, 1).sensor());
            pool.add(BodyDefinition.kinematic(new Capsule(1.5, 0.2)).at(0, 1).spin(1));
            for (int i = 0; i < 40; i++) {
                pool.add(kind(i).at(i % 8 * 2 - 7, 3 + i / 8).angle(i));
            }
            return pool;
        }

        private BodyDefinition kind(int i) {
            BodyDefinition body = BodyDefinition.dynamic(shape(i));
            return switch (i % 7) {
                case 0 -> body.filter(Filter.ALL.category(2));
                case 1 -> body.filter(Filter.ALL.mask(~2));
                case 2 -> body.lockRotation();
                default -> body;
            };
        }

        private Shape shape(int i) {
            return switch (i % 4) {
                case 0 -> new Capsule(0.3, 0.2);
                case 1 -> Polygon.box(0.6, 0.5).rounded(0.1);
                case 2 ->
                        Compound.of(
                                Part.of(Polygon.box(0.8, 0.2)),
                                Part.of(Polygon.box(0.2, 0.8)).at(0.3, 0.3));
                default -> Compound.of(Part.of(new Circle(0.3)), Part.of(new Circle(0.6)).sensor());
            };
        }
    };

    static final double DT = 1.0 / 60;

    static BodyDefinition restingBox() {
        return BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 0.5);
    }

    static final long SEED = 2;

    abstract Pool build();

    /** Everything usual but sleep. */
    static Effects usualWithoutSleep() {
        return Effects.of(
                new Gravity(0, -9.81),
                new Contacts(),
                new Rotation(),
                new Friction(),
                new Restitution(),
                new ContinuousImpacts());
    }

    static Pool restless() {
        return new Pool(usualWithoutSleep(), Accuracy.GAME);
    }

    static RigidBody addFloor(Pool pool) {
        return pool.add(BodyDefinition.fixed(Polygon.box(40, 1)).at(0, -0.5).name("floor"));
    }

    static void addTray(Pool pool) {
        addFloor(pool);
        Material smooth = new Material(1, 0.3, 0.2);
        pool.add(BodyDefinition.fixed(Polygon.box(1, 40)).at(-9, 20).material(smooth));
        pool.add(BodyDefinition.fixed(Polygon.box(1, 40)).at(9, 20).material(smooth));
    }

    static void addMixture(Pool pool, int count) {
        Random random = new Random(SEED);
        for (int i = 0; i < count; i++) {
            BodyDefinition pattern =
                    switch (i % 3) {
                        case 0 -> BodyDefinition.dynamic(Polygon.box(0.8, 0.5));
                        case 1 -> BodyDefinition.dynamic(Polygon.regular(5, 0.4));
                        default -> BodyDefinition.dynamic(new Circle(0.35));
                    };
            pool.add(
                    pattern.at(1.6 * (i % 9) - 6.4, 1 + 1.2 * (i / 9))
                            .angle(6 * random.nextDouble())
                            .velocity(random.nextDouble() - 0.5, 0)
                            .material(new Material(1, 0.5, 0.3)));
        }
    }

    static void run(Pool pool, int steps) {
        for (int i = 0; i < steps; i++) {
            pool.step(DT);
        }
    }
}
