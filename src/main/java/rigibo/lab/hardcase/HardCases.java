package rigibo.lab.hardcase;

import java.util.List;

/** Every hard case there is. To add one, write its class and its line here. */
public final class HardCases {

    private static final List<HardCase> ALL =
            List.of(
                    new FreeFlight(),
                    new LinearDrag(),
                    new ThrustAndTorque(),
                    new OrderOfBodies(),
                    new BallDrop(),
                    new HeadOn(),
                    new OffCentre(),
                    new ObliqueDisc(),
                    new RodEnd(),
                    new FlatLanding(),
                    new CornerOnCorner(),
                    new SlowBall(),
                    new OneBox(),
                    new Stack(10),
                    new Stack(20),
                    new Stack(50),
                    new Pyramid("21/large", 10, 1),
                    new Pyramid("21/tiny", 30, 0.05),
                    new DiscColumn(),
                    new UnevenFloor(),
                    new ElasticRest(),
                    new SlopeSweep(),
                    new SlideToStop(),
                    new Wedge(),
                    new RollingDown(),
                    new RollingToStop(),
                    new ManyCornered(),
                    new Bullets(),
                    new Billiard(),
                    new TurningRod(),
                    new SkinnyBox(),
                    new BulletsMeet(),
                    new Grazing(),
                    new ButtedBoxes(),
                    new Zeno(),
                    new Cradle(),
                    new Bernoulli(),
                    new Rack(),
                    new HeavyOnLight(),
                    new BornInOverlap(),
                    new DegenerateInput(),
                    new FarAway(),
                    new Dominoes(),
                    new Crush(),
                    new DeletedSupport(),
                    new HalfOnAnEdge(),
                    new RoundRolls(),
                    new IceAndRubber(),
                    new ThreeElasticities());

    private HardCases() {}

    /** All cases in the order of the catalogue. */
    public static List<HardCase> all() {
        return ALL;
    }
}
