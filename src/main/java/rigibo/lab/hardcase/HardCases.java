package rigibo.lab.hardcase;

import java.util.List;
import java.util.stream.Stream;

/** Every hard case there is. To add one, write its class and its line here. */
public final class HardCases {

    private static final List<HardCase> NUMBERED =
            List.of(
                    new FreeFlight(),
                    new LinearDrag(),
                    new QuadraticDrag(),
                    new ThrustAndTorque(),
                    new SpringAndOrbit(),
                    new ReboundThroughAir(),
                    new Bobbing(),
                    new BallDrop(),
                    new HeadOn(),
                    new OffCentre(),
                    new ObliqueDisc(),
                    new RodEnd(),
                    new FlatLanding(),
                    new SlowBall(),
                    new OneBox(),
                    new Stack(10),
                    new Stack(20),
                    new Stack(50),
                    new UnevenFloor(),
                    new ElasticRest(),
                    new SlopeSweep(),
                    new SlideToStop(),
                    new Wedge(),
                    new RollingDown(),
                    new RollingToStop(),
                    new Conveyor(),
                    new Bullets(),
                    new Billiard(),
                    new TurningRod(),
                    new BulletsMeet(),
                    new Grazing(),
                    new Zeno(),
                    new Cradle(),
                    new DegenerateInput(),
                    new FarAway(),
                    new Crush(),
                    new DeletedSupport(),
                    new RemovedOnContact(),
                    new HalfOnAnEdge(),
                    new RoundRolls(),
                    new IceAndRubber(),
                    new ThreeElasticities(),
                    new OrderOfBodies(),
                    new CornerOnCorner(),
                    new SkinnyBox(),
                    new Bernoulli(),
                    new Rack(),
                    new DominoWave(),
                    new Painleve(),
                    new Arch(),
                    new DiscColumn(),
                    new HeavyOnLight(),
                    new Pyramid("21/large", 10, 1),
                    new Pyramid("21/tiny", 30, 0.05),
                    new UntidyStack(),
                    new TurningPress(),
                    new ButtedBoxes(),
                    new BornInOverlap());

    private static final List<HardCase> HELD =
            Stream.of(NUMBERED, MovingPiles.held(), JointCases.held())
                    .flatMap(List::stream)
                    .toList();

    private static final List<HardCase> OPEN =
            Stream.of(
                            List.of(new ManyCornered(), new Dominoes(), new CardHouse()),
                            MovingPiles.open(),
                            JointCases.open())
                    .flatMap(List::stream)
                    .toList();

    private static final List<HardCase> LONG =
            Stream.concat(
                            Stream.of(new LongStack(), new LongBilliard()),
                            MovingPiles.longRuns().stream())
                    .toList();

    private HardCases() {}

    /** Cases whose every figure is within its limit at GAME and at EXACT; tests hold them there. */
    public static List<HardCase> held() {
        return HELD;
    }

    /** Cases whose truth is defined and not yet reached in every figure. */
    public static List<HardCase> open() {
        return OPEN;
    }

    /** Cases that take minutes; they run only when asked for by their row. */
    public static List<HardCase> longRuns() {
        return LONG;
    }

    /** All cases but the long runs. */
    public static List<HardCase> all() {
        return Stream.concat(HELD.stream(), OPEN.stream()).toList();
    }
}
